// Motions by name and in words, instead of type and q.
#pragma once

#include <optional>

#include "delos/model/motion.h"
#include "document/keys.h"

namespace delos {

/// Whether a motion is described in words.
[[nodiscard]] bool has_motion_words(const Node& motion);

/// `motion: {named: walk}`: all of it.
void read_named_motion(Reader& reader, const Place& at, MotionModel& out);

/// q of words.
/// @param layout of a chain
/// @returns nullopt with findings
[[nodiscard]] std::optional<CoordinateMatrix> q_of_words(Reader& reader,
                                                         const Place& at,
                                                         const StateLayout& layout);

/// The names of the library.
[[nodiscard]] std::vector<const char*> motion_names();

}  // namespace delos
