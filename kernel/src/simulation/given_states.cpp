#include "simulation/given_states.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace delos {
namespace {

/// The slope at point i of the parabola through it and its neighbours; at the ends that
/// of the chord.
Eigen::Vector3d slope_at(const GivenPath& path, std::size_t i) {
  const auto chord = [&](std::size_t k) -> Eigen::Vector3d {
    return (path.p[k + 1] - path.p[k]) / (path.t[k + 1] - path.t[k]);
  };
  if (i == 0) return chord(0);
  if (i + 1 == path.t.size()) return chord(i - 1);
  const double before = path.t[i] - path.t[i - 1], after = path.t[i + 1] - path.t[i];
  return (after * chord(i - 1) + before * chord(i)) / (before + after);
}

/// Position, velocity and acceleration at a time.
void at_time(const GivenPath& path, double t, Eigen::Vector3d (&out)[3]) {
  const auto after = std::upper_bound(path.t.begin() + 1, path.t.end() - 1, t);
  const auto k = static_cast<std::size_t>(after - path.t.begin()) - 1;
  const double h = path.t[k + 1] - path.t[k],
               s = std::clamp((t - path.t[k]) / h, 0., 1.);
  const Eigen::Vector3d rise = path.p[k + 1] - path.p[k];
  const Eigen::Vector3d m0 = h * slope_at(path, k), m1 = h * slope_at(path, k + 1);
  const Eigen::Vector3d b = 3 * rise - 2 * m0 - m1, c = m0 + m1 - 2 * rise;
  out[0] = path.p[k] + s * (m0 + s * (b + s * c));
  out[1] = (m0 + s * (2 * b + 3 * s * c)) / h;
  out[2] = (2 * b + 6 * s * c) / (h * h);
}

}  // namespace

std::vector<StateVector> given_states(const System& system, const TargetPose& about,
                                      const GivenPath& path, const MotionSteps& steps,
                                      std::size_t instants) {
  if (path.t.size() < 2 || path.t.size() != path.p.size())
    throw std::invalid_argument("a path needs two points at least");
  for (std::size_t i = 1; i < path.t.size(); ++i)
    if (!(path.t[i] > path.t[i - 1]))
      throw std::invalid_argument("the times of a path must rise; that of point " +
                                  std::to_string(i + 1) +
                                  " isn't after the one before");
  const StateLayout& layout = system.motion.layout;
  std::vector<StateVector> states;
  double t = path.t.front();
  for (std::size_t i = 0; i <= instants; ++i) {
    if (i > 0) t += steps.slot(i - 1).interval;
    Eigen::Vector3d p[3];
    at_time(path, t, p);
    p[0] -= about.p;
    StateVector x = StateVector::Zero(steps.states());
    for (int k = 0; k < std::min(layout.order, 3); ++k)
      for (int j = 0; j < layout.positions(); ++j)
        x(k * layout.coordinates() + j) = p[k](j);
    states.push_back(std::move(x));
  }
  return states;
}

}  // namespace delos
