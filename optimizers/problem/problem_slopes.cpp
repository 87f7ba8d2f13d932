#include <algorithm>
#include <cmath>

#include "delos/device/faults.h"
#include "delos/model/infinity.h"
#include "problem/problem_state.h"
#include "problem/worst_case.h"

namespace delos {
namespace {

/// Steps of differences, in the unit cube.
constexpr double kPoseStep = 1e-6;
constexpr double kLayerStep = 1e-5;

/// R_to R_fromᵀ = exp([φ]×) for a small φ.
Eigen::Vector3d turn_between(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const Eigen::Matrix3d turn = to * from.transpose();
  return Eigen::Vector3d(turn(2, 1) - turn(1, 2), turn(0, 2) - turn(2, 0),
                         turn(1, 0) - turn(0, 1)) /
         2;
}

}  // namespace

// With the miss m = (v − limit)/|limit| of each sample, as far as it is less than 0,
// and log(1 + m) beyond, which keeps a blind sample from hiding how others fare:
//
//   φ ≈ (1/s) log Σ exp(s φ_i)/n,   s = 1/width
//
// A mean leads out of blindness that a worst sample alone doesn't feel. At last the sum
// isn't divided, since what it keeps is kept.
double soft_miss(const MetricLimit& limit, const std::vector<double>& values,
                 double width, double* slopes) {
  const double s = width > 0 ? std::min(1 / width, kSharpest) : kSharpest;
  const double most = width > 0 ? limit.soft_limit : limit.limit;
  const auto miss = [&](std::size_t i) {
    return limit.sign * (values[i] - most) / limit.unit();
  };
  const auto compressed = [](double m) { return m > 0 ? std::log1p(m) : m; };
  double worst = -kInfinity;
  for (const std::size_t i : limit.samples)
    worst = std::max(worst, compressed(miss(i)));
  double sum = 0;
  for (const std::size_t i : limit.samples)
    sum += std::exp(s * (compressed(miss(i)) - worst));
  for (const std::size_t i : limit.samples) {
    if (!slopes) break;
    const double m = miss(i);
    slopes[i] = limit.sign / limit.unit() / (1 + std::max(m, 0.0)) *
                std::exp(s * (compressed(m) - worst)) / sum;
  }
  const double n = width > 0 ? static_cast<double>(limit.samples.size()) : 1;
  return worst + std::log(sum / n) / s;
}

/// @param[out] slope of the objective, or null
void Problem::State::soft_values(std::span<const double> x, double width, Score& out,
                                 double* slope) {
  out = {kInfinity, std::vector<double>(limits.size(), -kInfinity)};
  try {
    build(x);
  } catch (const Unbuildable&) {
    return;
  }
  out.objective = soft_robust_objective(x, width, slope);
  geometry.slacks(scene(), out.slacks.data());
  if (metric_limits.empty()) return;
  if (!drawn.empty()) values = soft->evaluate(nominal.system, width);
  double* slack = out.slacks.data() + geometry.limits().size();
  for (const MetricLimit& limit : metric_limits)
    *slack++ = -limit.unit() * soft_miss(limit, values[limit.metric], width, nullptr);
}

Score Problem::soft_score(std::span<const double> x, double width) {
  Score score;
  state_->soft_values(x, width, score);
  return score;
}

/// ∂J/∂x of variables that touch single devices, from those of poses and layers, where
/// the soft field is that of a world.
//
// A deviation moves a device in the world and turns it about its own axes: slopes with
// respect to the place it has are those with respect to the place it should have.
void Problem::State::chain(std::span<const double> x, const World& world,
                           const std::vector<PoseSlope>& poses, double* out) {
  std::vector<PlacedDevice> changed;
  for (std::size_t v = 0; v < design.size(); ++v) {
    out[v] = 0;
    if (touched[v].all) continue;
    for (const std::size_t i : touched[v].poses) {
      const DeviceEntry& entry = scene().devices[i];
      design.set(v, x[v] + kPoseStep);
      const Pose to = device_pose(scene(), entry);
      design.set(v, x[v] - kPoseStep);
      const Pose from = device_pose(scene(), entry);
      PoseSlope along;
      along << to.p - from.p, turn_between(from.R, to.R);
      out[v] += poses[i].dot(along) / (2 * kPoseStep);
    }
    for (const std::size_t i : touched[v].layers) {
      // Within the bounds, beyond which a device may not exist.
      const double up = std::min(x[v] + kLayerStep, 1.0),
                   down = std::max(x[v] - kLayerStep, 0.0);
      const auto contraction = [&](double at) {
        design.set(v, at);
        PlacedDevice device = nominal.system.devices[i];
        device.params = scene().devices[i].params;
        device.device = make_device(*plugins.find(device.type).info, device.params);
        if (!world.deviations.empty()) device = deviated(device, world.deviations[i]);
        return soft->contraction(i, device);
      };
      out[v] += (contraction(up) - contraction(down)) / (up - down);
    }
    design.set(v, x[v]);
  }
}

/// Variables that touch more than single devices: two fields each.
void Problem::State::slopes_by_differences(std::span<const double> x, double width,
                                           double* slope, double* slopes) {
  std::vector<double> at(x.begin(), x.end());
  const std::size_t n = design.size();
  for (std::size_t v = 0; v < n; ++v) {
    if (!touched[v].all) continue;
    const double up = std::min(x[v] + kLayerStep, 1.0),
                 down = std::max(x[v] - kLayerStep, 0.0);
    Score to, from;
    at[v] = up;
    soft_values(at, width, to);
    at[v] = down;
    soft_values(at, width, from);
    at[v] = x[v];
    slope[v] = (to.objective - from.objective) / (up - down);
    for (std::size_t i = geometry.limits().size(); i < limits.size(); ++i)
      slopes[i * n + v] = (to.slacks[i] - from.slacks[i]) / (up - down);
  }
}

Score Problem::score_with_slopes(std::span<const double> x, double width, double* slope,
                                 double* slopes) {
  State& s = *state_;
  const std::size_t n = s.design.size(), first = s.geometry.limits().size();
  std::fill_n(slope, n, 0.0);
  std::fill_n(slopes, s.limits.size() * n, 0.0);
  Score score;
  const bool differences = std::any_of(s.touched.begin(), s.touched.end(),
                                       [](const Touched& t) { return t.all; });
  s.soft_values(x, width, score, slope);
  if (!std::isfinite(score.objective)) return score;
  const FieldValues values = s.values;
  for (std::size_t k = 0; k < s.metric_limits.size(); ++k) {
    const MetricLimit& limit = s.metric_limits[k];
    FieldValues of_values(s.metrics.size(), std::vector<double>(s.samples.set.size()));
    (void)soft_miss(limit, values[limit.metric], width, of_values[limit.metric].data());
    for (double& w : of_values[limit.metric]) w *= -limit.unit();
    s.soft->adjoin(of_values);
    s.chain(x, s.nominal, s.soft->pose_slopes(), slopes + (first + k) * n);
  }

  // Places are cheap: differences of the slacks themselves.
  std::vector<double> up(first), down(first);
  for (std::size_t v = 0; first > 0 && v < n; ++v) {
    s.design.set(v, x[v] + kPoseStep);
    s.geometry.slacks(s.scene(), up.data());
    s.design.set(v, x[v] - kPoseStep);
    s.geometry.slacks(s.scene(), down.data());
    s.design.set(v, x[v]);
    for (std::size_t i = 0; i < first; ++i)
      slopes[i * n + v] = (up[i] - down[i]) / (2 * kPoseStep);
  }
  if (differences) s.slopes_by_differences(x, width, slope, slopes);
  return score;
}

}  // namespace delos
