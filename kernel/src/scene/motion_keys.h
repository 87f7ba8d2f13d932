// How the target moves: the keys of `motion`.
#pragma once

#include "delos/model/motion.h"
#include "document/keys.h"

namespace delos {

void read_motion(Reader& reader, const Place& at, MotionModel& out);
[[nodiscard]] Node write_motion(const MotionModel& motion);

}  // namespace delos
