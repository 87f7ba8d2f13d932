// Small systems for tests, built without scenes or plugins.
#pragma once

#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "delos/device/point_device.h"
#include "delos/device/range_device.h"
#include "delos/field/evaluate.h"
#include "delos/rig/system.h"
#include "delos/steady/steady_solver.h"

namespace delos::testing {

/// z = ‖p‖ with R = r·z², the papers' acoustic law; blind beyond `reach`.
class TestRange : public Device {
 public:
  explicit TestRange(double r, double reach = 1e9) : r_(r), reach_(reach) {}
  bool observe(const Target& target, Observation& out) const override {
    const double range = target.p_ST.norm();
    if (range == 0 || range > reach_) return false;
    out.z.setConstant(1, range);
    out.H = target.p_ST.transpose() / range;
    out.R.setConstant(1, 1, r_ * range * range);
    return true;
  }

 private:
  double r_, reach_;
};

/// The same law as plugins have it, with every entry that a device may offer.
class TestFullRange : public RangeDevice {
 public:
  explicit TestFullRange(double r, double reach = 1e9) : RangeDevice(0, r, reach) {}
};

/// z = atan2(y, x), read all around: where it is seen from −x, π and −π are neighbours.
class TestBearing final : public PointDevice<TestBearing, 1> {
 public:
  /// @param comes_back whether it says so
  explicit TestBearing(double sigma, bool comes_back = true)
      : variance_(sigma * sigma), comes_back_(comes_back) {}
  double period(int) const override { return comes_back_ ? 2 * EIGEN_PI : 0; }
  template <class T>
  void read(const Point<T>& p, Reading<T, 1>& out) const {
    using std::atan2;
    out.z[0] = atan2(p.y, p.x);
    out.variance[0] = T(variance_);
    out.inside = T(1);
  }

 private:
  double variance_;
  bool comes_back_;
};

/// A given H and R over any span, the same everywhere.
class TestLinear final : public Device {
 public:
  TestLinear(Span span, Eigen::MatrixXd H, Eigen::MatrixXd R)
      : span_(span), H_(std::move(H)), R_(std::move(R)) {}
  Span span() const override { return span_; }
  int state_size() const override { return static_cast<int>(H_.cols()); }
  bool observe(const Target&, Observation& out) const override {
    out.z.setZero(H_.rows());
    out.H = H_;
    out.R = R_;
    return true;
  }

 private:
  Span span_;
  Eigen::MatrixXd H_, R_;
};

inline PlacedDevice place(std::string name, std::shared_ptr<const Device> device,
                          const Pose& X_WS, double rate) {
  PlacedDevice placed;
  placed.name = std::move(name);
  placed.type = "test";
  placed.device = std::move(device);
  placed.mount = WorldMount{X_WS};
  placed.period = 1 / rate;
  return placed;
}

inline MotionModel chain_motion(PoseState pose, int order, const CoordinateMatrix& q) {
  MotionModel motion;
  motion.layout.pose = pose;
  motion.layout.order = order;
  motion.dynamics = ChainMotion{q};
  return motion;
}

/// The papers' acoustic tracker with the geometry inferred in docs/theory.md, "A
/// published table, reproduced".
inline System acoustic_system(double rate = 50) {
  System system;
  system.motion = chain_motion(
      PoseState::position, 2,
      Eigen::Vector3d(0.3951529079, 0.3951529079, 0.10745377401).asDiagonal());
  system.markers = {Eigen::Vector3d::Zero()};
  for (const double x : {0.0, 0.4}) {
    for (const double y : {0.0, 0.4}) {
      system.devices.push_back(place("s" + std::to_string(system.devices.size() + 1),
                                     std::make_shared<TestRange>(0.005),
                                     {Eigen::Matrix3d::Identity(), {x, y, 1.0485}},
                                     rate));
    }
  }
  return system;
}

inline Metric metric_of(const System& system, const std::string& name) {
  return std::get<Metric>(parse_metric(name, system.motion.layout));
}

inline Samples volume(const Eigen::Vector3d& min, const Eigen::Vector3d& max,
                      double step) {
  return make_samples(
      {{"", VolumeSampling{min, max, Eigen::Vector3d::Constant(step)}}});
}

inline Samples points(std::vector<Eigen::Vector3d> list) {
  return make_samples({{"", PointSampling{"", std::move(list)}}});
}

/// State of one pose by the field's own way, through formed information.
inline FusedState state_at(const System& system, const TargetPose& pose,
                           Solver solver = Solver::automatic) {
  const InformationLayers layers(system, {pose}, {.threads = 1});
  const auto fusion = make_steady_solver(system, solver);
  SteadyEquation equation = fusion->equation();
  LayerBlock empty;
  FusedState state;
  fusion->read(layers.block(0, empty), 0, pose, equation);
  fusion->solve(equation, {.time_constant = true}, state);
  return state;
}

inline Eigen::Matrix3d random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  return q.normalized().toRotationMatrix();
}

}  // namespace delos::testing
