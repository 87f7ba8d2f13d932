// How the target moves: the keys of `motion`.
#pragma once

#include <vector>

#include "delos/model/motion.h"
#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_motion(Reader& reader, const Place& at, MotionModel& out);
[[nodiscard]] Node write_motion(const MotionModel& motion);

/// Others that it may have instead, by name.
void read_motions(Reader& reader, const Place& at, std::vector<MotionEntry>& out);
[[nodiscard]] Node write_motions(const std::vector<MotionEntry>& motions);

[[nodiscard]] std::vector<KeyShape> motion_keys();
[[nodiscard]] Shape motion_shape();

}  // namespace delos
