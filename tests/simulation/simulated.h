// Systems to simulate, and what tests ask of an answer.
#pragma once

#include <gtest/gtest.h>

#include "delos/device/inertial_device.h"
#include "delos/simulation/simulate.h"
#include "support/rigs.h"

namespace delos::test {

using namespace delos::testing;

inline const TargetPose kOrigin{Eigen::Matrix3d::Identity(), {0, 0, 0}};

/// z = H x of the whole state, with what it is off by.
class StateReading final : public Device {
 public:
  StateReading(Eigen::MatrixXd H, Eigen::MatrixXd R, std::vector<OwnState> own = {})
      : H_(std::move(H)), R_(std::move(R)), own_(std::move(own)) {}
  Span span() const override { return Span::state; }
  int state_size() const override { return static_cast<int>(H_.cols()); }
  std::vector<OwnState> states() const override { return own_; }
  bool observe(const Target& target, Observation& out) const override {
    const auto own = static_cast<Eigen::Index>(own_.size());
    out.z = H_ * target.state;
    out.H.setZero(H_.rows(), H_.cols() + own);
    out.H.leftCols(H_.cols()) = H_;
    if (own > 0) {
      out.z += target.own.head(own);
      out.H.rightCols(own).setIdentity();
    }
    out.R = R_;
    return true;
  }

 private:
  Eigen::MatrixXd H_, R_;
  std::vector<OwnState> own_;
};

/// One coordinate of the position, as a point device reads it.
class AxisReading final : public PointDevice<AxisReading, 1> {
 public:
  AxisReading(int axis, double variance) : axis_(axis), variance_(variance) {}
  template <class T>
  void read(const Point<T>& p, Reading<T, 1>& out) const {
    out.z[0] = axis_ == 0 ? p.x : axis_ == 1 ? p.y : p.z;
    out.variance[0] = T(variance_);
    out.inside = T(1);
  }

 private:
  int axis_;
  double variance_;
};

inline PlacedDevice axis(int which, double variance, double rate, double phase = 0,
                         double exposure = 0) {
  // Off the target: a point at the device itself is never seen.
  PlacedDevice placed = place("axis" + std::to_string(which),
                              std::make_shared<AxisReading>(which, variance),
                              {Eigen::Matrix3d::Identity(), {50, 50, 50}}, rate);
  placed.phase = phase;
  placed.exposure = exposure;
  return placed;
}

inline System moving(int order, std::vector<PlacedDevice> devices,
                     Fusion fusion = Fusion::stacked) {
  System system;
  system.motion = chain_motion(PoseState::position, order,
                               Eigen::Vector3d(0.4, 0.4, 0.1).asDiagonal());
  system.markers = {Eigen::Vector3d::Zero()};
  system.devices = std::move(devices);
  system.fusion = fusion;
  return system;
}

/// The states of a device's own, as build_system() adds them.
inline void add_own(System& system, std::size_t device) {
  PlacedDevice& placed = system.devices[device];
  StateLayout& layout = system.motion.layout;
  const auto states = placed.device->states();
  placed.own = {layout.size(), static_cast<int>(states.size())};
  for (const OwnState& state : states) {
    layout.extra.push_back(state.name);
    system.motion.own.push_back({state.time_constant, state.density});
  }
}

/// Every entry of the measured covariance is P∞'s within its own standard error times
/// `sigmas`: of the same normal errors, √((P_ii P_jj + P_ij²)/N).
inline void expect_predicted(const Simulation& s, double sigmas = 4.5) {
  for (const SimulatedCovariance& c : s.covariances) {
    const Eigen::Index n = c.predicted.rows();
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j <= i; ++j)
        EXPECT_NEAR(c.measured(i, j), c.predicted(i, j), sigmas * c.error(i, j))
            << c.name << " " << i << ", " << j;
  }
}

/// The filter's own covariance doesn't depend on the readings of a linear system: it is
/// P∞ but for what is left of the start, and so is the bound.
inline void expect_settled(const Simulation& s, double tolerance = 1e-3) {
  for (const SimulatedCovariance& c : s.covariances) {
    EXPECT_LT((c.filter - c.predicted).norm(), tolerance * c.predicted.norm())
        << c.name;
    ASSERT_EQ(c.bound.rows(), c.predicted.rows());
    EXPECT_LT((c.bound - c.predicted).norm(), tolerance * c.predicted.norm()) << c.name;
  }
}

}  // namespace delos::test
