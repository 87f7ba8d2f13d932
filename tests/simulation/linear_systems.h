// Linear systems to simulate: devices that read states, and one system for each way in
// which readings come together.
#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "delos/device/inertial_device.h"
#include "delos/device/point_device.h"
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

/// How far a measured covariance of N runs is from the predicted one, in what N runs
/// scatter by.
struct CovarianceFit {
  /// Of an entry, in its standard error √((P_ii P_jj + P_ij²)/N), the largest.
  double largest = 0;
  /// N Σ_{i ≥ j} (W_ij − δ_ij)²/(1 + δ_ij) of W = L⁻¹ C L⁻ᵀ, P = L Lᵀ: χ² with
  /// `degrees` degrees of freedom, of errors at one instant.
  double chi_squared = 0;
  double degrees = 0;
};

inline CovarianceFit covariance_fit(const SimulatedCovariance& c, std::size_t runs) {
  const Eigen::MatrixXd P = c.predicted, C = c.measured;
  const auto N = static_cast<double>(runs);
  const Eigen::LLT<Eigen::MatrixXd> split(P);
  const Eigen::MatrixXd half = split.matrixL().solve(C),
                        W = split.matrixL().solve(half.transpose());
  CovarianceFit fit;
  for (Eigen::Index i = 0; i < P.rows(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j) {
      const double error = std::sqrt((P(i, i) * P(j, j) + P(i, j) * P(i, j)) / N);
      fit.largest = std::max(fit.largest, std::abs(C(i, j) - P(i, j)) / error);
      const double same = i == j;
      fit.chi_squared += N * std::pow(W(i, j) - same, 2) / (1 + same);
      ++fit.degrees;
    }
  return fit;
}

/// A system that is linear, so that a filter's errors have exactly the covariance that
/// the Riccati equations give.
struct LinearCase {
  std::string name;
  System system;
  double seconds = 0;  ///< to simulate; 0: five time constants
  int runs = 1500;     ///< in a test, of a second or two
  bool limit = false;  ///< P∞ is one of frequent updates, which errors come near to
};

/// A fix and a reading of the acceleration, 3 states of a drifting bias behind.
inline System biased(Fusion fusion, double fixes, double accelerations) {
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(3, 9);
  H.rightCols(3).setIdentity();
  std::vector<OwnState> bias;
  for (const char* name : {"bx", "by", "bz"})
    bias.push_back({name, "m/s^2", 1.0, 0.02});
  System system =
      moving(3,
             {axis(0, 1e-4, fixes), axis(1, 1e-4, fixes), axis(2, 1e-4, fixes),
              place("a",
                    std::make_shared<StateReading>(
                        H, 1e-2 * Eigen::MatrixXd::Identity(3, 3), bias),
                    {}, accelerations)},
             fusion);
  add_own(system, 3);
  return system;
}

/// One of each: every fusion that is of a filter, rates, exposures, biases.
inline std::vector<LinearCase> linear_cases() {
  std::vector<LinearCase> all;
  for (int order = 1; order <= 3; ++order)
    all.push_back({"stacked_" + std::string(order, 'P'),
                   moving(order, {axis(0, 1e-3, 50), axis(1, 4e-3, 50),
                                  axis(2, 1e-3, 50), axis(0, 1e-2, 50)})});
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(3, 6), R(3, 3);
  H.leftCols(3).setIdentity();
  R << 2, 1, 0.5, 1, 3, -1, 0.5, -1, 1;
  all.push_back(
      {"correlated_noise",
       moving(2, {place("all", std::make_shared<StateReading>(H, 1e-3 * R), {}, 50)})});
  const std::vector<PlacedDevice> rates = {axis(0, 1e-3, 50), axis(1, 1e-3, 20, 0.003),
                                           axis(2, 1e-3, 25, 0.01), axis(1, 1e-2, 100)};
  all.push_back({"periodic", moving(2, rates, Fusion::periodic)});
  all.push_back({"sequential",
                 moving(2, {axis(0, 1e-3, 90), axis(1, 4e-3, 90), axis(2, 1e-3, 60)},
                        Fusion::sequential)});
  all.push_back(
      {"continuous",
       moving(2, {axis(0, 1, 200), axis(1, 1, 100), axis(2, 4, 200), axis(1, 2, 200)},
              Fusion::continuous),
       0, 400, true});
  all.push_back({"equal_exposures",
                 moving(2, {axis(0, 1e-4, 30, 0, 0.03), axis(1, 1e-4, 30, 0, 0.03),
                            axis(2, 1e-4, 30, 0, 0.03)})});
  all.push_back({"different_exposures",  // in windows that overlap
                 moving(2,
                        {axis(0, 1e-4, 30, 0, 0.02), axis(1, 1e-4, 60, 0, 0.01),
                         axis(2, 1e-4, 60), axis(0, 1e-3, 60)},
                        Fusion::periodic)});
  all.push_back({"biases", biased(Fusion::stacked, 50, 50), 0, 1000});
  all.push_back({"biases_of_many_rates", biased(Fusion::periodic, 25, 100), 0, 500});
  return all;
}

}  // namespace delos::test
