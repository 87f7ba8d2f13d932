#include "simulation/motion_steps.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "model/lower_root.h"
#include "steady/windows.h"

namespace delos {
namespace {

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Eigen::Matrix3d exponential(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

}  // namespace

MotionSteps::MotionSteps(const System& system, std::span<const UpdateSlot> slots)
    : layout_(system.motion.layout) {
  const ExposureWindows windows(system, slots);
  for (std::size_t s = 0; s < slots.size(); ++s) {
    SimulatedSlot slot{windows.motion(s), {}, slots[s].interval, slots[s].devices, {}};
    slot.root = lower_root(slot.motion.Q);
    for (const int device : slot.devices)
      slot.blocks.push_back(windows.block(s, device));
    cycle_ += slot.interval;
    states_ = static_cast<int>(slot.motion.A.rows());
    slots_.push_back(std::move(slot));
  }
}

void predict_state(const StateLayout& layout, const MotionStep& motion,
                   TrackEstimate& estimate) {
  const StateVector before = estimate.x;
  estimate.x.noalias() = motion.A * before;
  StateMatrix F = motion.A, Q = motion.Q;
  if (layout.turns() > 0) {
    const int at = layout.positions();
    Eigen::Vector3d turn(0, 0, 0);
    if (layout.turns() == 1)
      turn.z() = estimate.x(at) - before(at);
    else
      turn = estimate.x.segment<3>(at) - before.segment<3>(at);
    const Eigen::Matrix3d E = exponential(turn);
    estimate.R = (E * estimate.R).eval();
    if (layout.turns() == 3) {
      const Eigen::Matrix3d S = skew(turn);
      const Eigen::Matrix3d J = Eigen::Matrix3d::Identity() + S / 2 + S * S / 6;
      F.middleRows<3>(at) = (J * motion.A.middleRows<3>(at)).eval();
      F.block<3, 3>(at, at) = E;
      Q.middleRows<3>(at) = (J * Q.middleRows<3>(at)).eval();
      Q.middleCols<3>(at) = (Q.middleCols<3>(at) * J.transpose()).eval();
    }
  }
  StateMatrix FP;
  FP.noalias() = F * estimate.P;
  estimate.P.noalias() = FP * F.transpose();
  estimate.P += Q;
  estimate.P = ((estimate.P + estimate.P.transpose()) / 2).eval();
}

TargetDraws::TargetDraws(const System& system, const TargetPose& about,
                         const MotionSteps& steps, std::size_t instants)
    : system_(system),
      about_(about),
      steps_(steps),
      instants_(instants),
      target_states_(system.motion.layout.size() -
                     static_cast<int>(system.motion.own.size())),
      ends_at_pose_(system.motion.is_chain()) {
  const int n = target_states_;
  StateMatrix whole = StateMatrix::Identity(n, n);
  for (std::size_t i = 0; i < instants; ++i)
    whole = (steps.slot(i).motion.A.topLeftCorner(n, n) * whole).eval();
  if (ends_at_pose_) back_to_start_ = whole.inverse();
}

void TargetDraws::draw(RunRandom& random, const std::vector<StateVector>* given,
                       DrawnPath& path) const {
  const int N = steps_.states();
  path.x.resize(instants_ + 1);
  path.R.assign(instants_ + 1, about_.R);
  StateVector noise(N), x = StateVector::Zero(N);
  // A bias that drifts is as it has long been; one that walks begins at 0.
  for (std::size_t i = 0; i < system_.motion.own.size(); ++i) {
    const GaussMarkov& own = system_.motion.own[i];
    const double drawn = random.normal();
    if (std::isfinite(own.time_constant))
      x(target_states_ + static_cast<Eigen::Index>(i)) =
          std::sqrt(own.density * own.time_constant / 2) * drawn;
  }
  path.x[0] = x;
  for (std::size_t i = 0; i < instants_; ++i) {
    const SimulatedSlot& slot = steps_.slot(i);
    for (double& number : noise) number = random.normal();
    path.x[i + 1].noalias() = slot.motion.A * path.x[i];
    path.x[i + 1].noalias() += slot.root.triangularView<Eigen::Lower>() * noise;
  }
  if (given) {
    for (std::size_t i = 0; i <= instants_; ++i)
      path.x[i].head(target_states_) = (*given)[i].head(target_states_);
    return;
  }
  if (ends_at_pose_) {
    // The same noise, and another start: x_t − A…A Φ⁻¹ x_T.
    x.setZero();
    x.head(target_states_) = -(back_to_start_ * path.x.back().head(target_states_));
    path.x[0] += x;
    for (std::size_t i = 0; i < instants_; ++i) {
      x = (steps_.slot(i).motion.A * x).eval();
      path.x[i + 1] += x;
    }
  }
  const StateLayout& layout = system_.motion.layout;
  if (layout.turns() == 0) return;
  const int at = layout.positions();
  const auto turn = [&](std::size_t from, std::size_t to) -> Eigen::Vector3d {
    if (layout.turns() == 1) return {0, 0, path.x[to](at) - path.x[from](at)};
    return path.x[to].segment<3>(at) - path.x[from].segment<3>(at);
  };
  if (ends_at_pose_) {
    for (std::size_t i = instants_; i-- > 0;)
      path.R[i] = exponential(-turn(i, i + 1)) * path.R[i + 1];
  } else {
    for (std::size_t i = 0; i < instants_; ++i)
      path.R[i + 1] = exponential(turn(i, i + 1)) * path.R[i];
  }
}

}  // namespace delos
