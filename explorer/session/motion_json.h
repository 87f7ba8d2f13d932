// A fitted motion as JSON (`fit-motion --json`).
#pragma once

#include "motion/motion_fit.h"
#include "session/json.h"

namespace delos::session {

[[nodiscard]] Json motion_json(const motion::MotionFit& fit, const std::string& source);

}  // namespace delos::session
