#include "simulation/drawn_errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace delos {
namespace {

Eigen::Vector3d three(RunRandom& random) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return {x, y, z};
}

/// By δ and by turning by φ about the origin, along the axes of the frame that it is a
/// pose in.
Pose drawn_pose(const Calibration& known, RunRandom& random) {
  const Eigen::Vector3d place = three(random).cwiseProduct(known.place);
  const Eigen::Vector3d turn = three(random).cwiseProduct(known.orientation);
  return {Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()).toRotationMatrix(),
          place};
}

}  // namespace

DrawnErrors::DrawnErrors(const System& system, const TargetPose& about, int states)
    : system_(system),
      errant_(system),
      model_(errant_, about, states),
      drawn_(system.devices.size()) {
  // What several devices have in common is of any number of rows.
  for (Drawn& drawn : drawn_) drawn.offsets.setZero(kMaxRows);
}

void DrawnErrors::draw_own(PlacedDevice& placed, Drawn& drawn, RunRandom& random) {
  const Calibration& known = placed.calibration;
  const Pose moved = drawn_pose(known, random);
  if (auto* carried = std::get_if<TargetMount>(&placed.mount))
    carried->X_TS = carried->X_TS * moved;
  else
    placed.X_WS() = placed.X_WS() * moved;
  drawn.params.clear();
  for (const DoubtfulParameter& parameter : placed.doubtful)
    drawn.params.push_back(parameter.deviation * random.normal());
  for (double& offset : drawn.offsets) offset = known.offset * random.normal();
  drawn.scale = known.scale * random.normal();
  drawn.delay = known.delay * random.normal();
}

void DrawnErrors::draw_common(std::size_t number, RunRandom& random) {
  const PlacedCommonError& common = system_.common_errors[number];
  const Pose moved =
      common.X_WF * drawn_pose(common.of, random) * common.X_WF.inverse();
  const double offset = common.of.offset * random.normal(),
               scale = common.of.scale * random.normal(),
               delay = common.of.delay * random.normal();
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    const auto& shared = errant_.devices[i].common_errors;
    if (!std::binary_search(shared.begin(), shared.end(), number)) continue;
    errant_.devices[i].X_WS() = moved * errant_.devices[i].X_WS();
    drawn_[i].offsets.array() += offset;
    drawn_[i].scale += scale;
    drawn_[i].delay += delay;
  }
}

void DrawnErrors::draw(RunRandom& random) {
  velocity_ = system_.speed / std::sqrt(3.0) * three(random);
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    errant_.devices[i].mount = system_.devices[i].mount;
    draw_own(errant_.devices[i], drawn_[i], random);
  }
  for (std::size_t c = 0; c < system_.common_errors.size(); ++c) draw_common(c, random);
}

bool DrawnErrors::read(const TrackReading& reading, const StateVector& x,
                       const Eigen::Matrix3d& R, PredictedReading& seen,
                       decltype(Observation::z)& z) {
  const auto device = static_cast<std::size_t>(reading.device);
  PlacedDevice& placed = errant_.devices[device];
  const Drawn& drawn = drawn_[device];
  StateVector then = x;
  for (int i = 0; i < system_.motion.layout.positions(); ++i)
    then(reading.block.first + i) -= drawn.delay * velocity_(i);
  if (!model_.predict(reading, then, R, seen)) return false;
  z = seen.z;
  for (std::size_t k = 0; k < drawn.params.size(); ++k) {
    const DoubtfulParameter& parameter = placed.doubtful[k];
    const auto of = [&](const std::shared_ptr<const Device>& other) {
      placed.device = other;
      const bool sees = model_.predict(reading, then, R, beside_);
      placed.device = system_.devices[device].device;
      return sees && beside_.z.size() == seen.z.size() ? beside_.z : seen.z;
    };
    const auto above = of(parameter.above), below = of(parameter.below);
    z += drawn.params[k] / parameter.between * (above - below);
  }
  z += drawn.scale * seen.z + drawn.offsets.head(z.size());
  return true;
}

}  // namespace delos
