// The paper's experiments on simulated motion.
#pragma once

#include <cstdint>
#include <vector>

#include "delos/rigid_body/filter.h"

namespace delos::rigid_body {

/// Bounds of what is drawn evenly and added to the motion of each frame.
struct DrawnMotion {
  double omega = 1e-3, v = 1e-2, a = 1e-5;
};

/// The motion of experiment 1, and of 3 from frame 10 on; a unit of time is a
/// millisecond, which is the one with which the paper's figures make sense: v_z runs
/// from 0.2 by steps of 0.02.
struct Experiment {
  double dt = 20;
  std::vector<BodyState> motion;  ///< over each frame; v is that of its beginning
  BodyPoints start;               ///< e₁, e₂, e₃
};

/// ω = (0, 0, 0.02), v₀ = (0, 0, 0.2), a = (0, 0, 0.001) over `frames` frames.
[[nodiscard]] Experiment steady_motion(int frames);
/// The same, and from frame 10 on ω = (0.005, −0.01, −0.02), v = (0.2, 0.1, −0.2),
/// a = (0.001, 0.0008, −0.001).
[[nodiscard]] Experiment sudden_turn(int frames);
/// Each frame's motion is off by what is drawn, evenly between ± the bounds.
[[nodiscard]] Experiment shaken(Experiment experiment, const DrawnMotion& bounds,
                                std::uint64_t seed);

/// What the filter has after each frame, and how far its prediction of the frame's
/// first point was off, metres.
struct FilteredFrame {
  BodyState state;
  double predicted_error;
};
[[nodiscard]] std::vector<FilteredFrame> filtered(const Experiment& experiment,
                                                  BodyFilter filter = BodyFilter());

}  // namespace delos::rigid_body
