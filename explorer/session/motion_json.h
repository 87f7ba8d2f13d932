// A fitted motion as JSON (`fit-motion --json`).
#pragma once

#include "delos/model/motion_words.h"
#include "motion/segments.h"
#include "session/json.h"

namespace delos::session {

[[nodiscard]] Json motion_json(const motion::MotionFit& fit, const std::string& source);
/// Those of `fit-motion --segments`.
[[nodiscard]] Json segments_json(const std::vector<motion::Segment>& segments,
                                 const std::string& source);

}  // namespace delos::session
