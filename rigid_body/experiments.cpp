#include "delos/rigid_body/experiments.h"

#include <random>

namespace delos::rigid_body {
namespace {

/// Frames of constant acceleration.
void append(BodyState state, int frames, double dt, std::vector<BodyState>& motion) {
  for (int i = 0; i < frames; ++i) {
    motion.push_back(state);
    state.v += dt * state.a;
  }
}

}  // namespace

Experiment steady_motion(int frames) {
  Experiment e;
  e.start = unit_points({});
  append({{0, 0, 0.02}, {0, 0, 0.2}, {0, 0, 0.001}}, frames, e.dt, e.motion);
  return e;
}

Experiment sudden_turn(int frames) {
  Experiment e = steady_motion(9);
  append({{0.005, -0.01, -0.02}, {0.2, 0.1, -0.2}, {0.001, 0.0008, -0.001}}, frames - 9,
         e.dt, e.motion);
  return e;
}

Experiment shaken(Experiment experiment, const DrawnMotion& bounds,
                  std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto add = [&](double bound, Eigen::Vector3d& to) {
    for (double& x : to)
      x += bound * (2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1);
  };
  for (BodyState& state : experiment.motion) {
    add(bounds.omega, state.omega);
    add(bounds.v, state.v);
    add(bounds.a, state.a);
  }
  return experiment;
}

std::vector<FilteredFrame> filtered(const Experiment& experiment, BodyFilter filter) {
  std::vector<FilteredFrame> frames;
  BodyPoints before = experiment.start;
  for (const BodyState& state : experiment.motion) {
    const BodyPoints after = moved(state, experiment.dt, before);
    const Eigen::Vector3d predicted =
        moved(filter.next(experiment.dt), experiment.dt, before[0]);
    filter.frame(experiment.dt, before, after);
    frames.push_back({filter.state(), (predicted - after[0]).norm()});
    before = after;
  }
  return frames;
}

}  // namespace delos::rigid_body
