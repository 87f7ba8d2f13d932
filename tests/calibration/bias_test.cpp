// The bias covariance against closed forms, against filters that are run with errors
// drawn at random, and against the filter's fixed point.
#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>

#include "delos/field/point.h"
#include "delos/layers/layers.h"
#include "scenes.h"
#include "support/rigs.h"

namespace delos {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::scene_of;
using test::system_of;
using test::three_ranges;
using test::two_cameras;

/// B of a system at a pose, over its whole state.
StateMatrix whole_bias(System system, const TargetPose& pose) {
  system.error = ErrorPart::bias;
  const Metric metric = testing::metric_of(system, "coverage");
  return evaluate_point(system, pose, metric).state.prior;
}

/// The same of the pose alone.
StateMatrix bias_of(const System& system, const TargetPose& pose) {
  const int d = system.motion.layout.coordinates();
  return whole_bias(system, pose).topLeftCorner(d, d);
}

const TargetPose kOrigin{Matrix3d::Identity(), Vector3d::Zero()};

Matrix3d cross(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

void expect_equal(const StateMatrix& B, const MatrixXd& expected, double tolerance) {
  ASSERT_EQ(B.rows(), expected.rows());
  for (Eigen::Index i = 0; i < B.rows(); ++i)
    for (Eigen::Index j = 0; j < B.cols(); ++j)
      EXPECT_NEAR(B(i, j), expected(i, j), tolerance) << i << ", " << j;
}

// Each range tells of one axis: what it is off by, or its anchor along it, is what the
// estimate is off by.
TEST(Bias, OfOrthogonalRangesIsTheirOwn) {
  const Matrix3d one = Matrix3d::Identity();
  expect_equal(bias_of(system_of(three_ranges("calibration: {offset: 5 cm}")), kOrigin),
               25e-4 * one, 1e-15);
  expect_equal(bias_of(system_of(three_ranges("calibration: {place: 2 cm}")), kOrigin),
               4e-4 * one, 1e-15);
  expect_equal(
      bias_of(system_of(three_ranges("calibration: {place: [1 cm, 2 cm, 3 cm]}")),
              kOrigin),
      Vector3d(1e-4, 4e-4, 9e-4).asDiagonal(), 1e-15);
  expect_equal(
      bias_of(system_of(three_ranges("calibration: {orientation: 9 deg}")), kOrigin),
      0 * one, 1e-15);
}

// One device that tells the whole pose and is displaced by δ and turned by φ, in its
// own axes, takes the target for displaced by −R δ + (−R φ) × r and turned by −R φ,
// where r leads from the device to the target.
TEST(Bias, OfADeviceThatSeesThePoseIsTheDevicesOwn) {
  const std::string text =
      "delos: 1\nmotion: {type: position_velocity, state: pose, q: [1, 1, 1, 1, 1, "
      "1]}\n"
      "sample: {points: [[0, 0, 0]]}\ndevices:\n"
      "  - {name: c, type: fiducial, rate: 30 Hz, at: [0.3, -0.4, 2.5], aim: [0, 0, "
      "0],\n"
      "     params: {resolution: [1280, 960], field_of_view: 75 deg, sigma: 0.3, size: "
      "20 cm, least_size: 8 px},\n"
      "     calibration: {place: 2 mm, orientation: [0.1 deg, 0.2 deg, 0.3 deg]}}\n";
  const TargetPose pose{rotation_from_rpy({0.3, 0.2, 0.4}), {0.1, 0.2, 0.3}};
  const System system = system_of(text);
  const Matrix3d R = system.devices[0].X_WS().R;
  const Vector3d r = pose.p - system.devices[0].X_WS().p;
  constexpr double kDegree = std::numbers::pi / 180;
  const Matrix3d turn = R * Vector3d(0.01, 0.04, 0.09).asDiagonal().toDenseMatrix() *
                        kDegree * kDegree * R.transpose();
  MatrixXd expected(6, 6);
  expected.topLeftCorner(3, 3) =
      4e-6 * Matrix3d::Identity() + cross(r) * turn * cross(r).transpose();
  expected.bottomRightCorner(3, 3) = turn;
  expected.topRightCorner(3, 3) = -cross(r) * turn;
  expected.bottomLeftCorner(3, 3) = expected.topRightCorner(3, 3).transpose();
  expect_equal(bias_of(system, pose), expected, 1e-9);
}

// The same of a camera that sees markers, whose rows are of points.
TEST(Bias, OfACameraThatSeesMarkersIsTheCamerasOwn) {
  const std::string text =
      "delos: 1\nmotion: {type: position_velocity, state: pose, q: [1, 1, 1, 1, 1, "
      "1]}\n"
      "target: {markers: [[0.2, 0, 0], [-0.1, 0.2, 0], [-0.1, -0.2, 0.1], [0, 0, "
      "0.2]]}\n"
      "sample: {points: [[0, 0, 0]]}\ndevices:\n"
      "  - {name: c, type: camera, rate: 30 Hz, at: [0.3, -0.4, 2.5], aim: [0, 0, 0],\n"
      "     params: {resolution: [1280, 960], field_of_view: 75 deg, sigma: 0.3},\n"
      "     calibration: {place: 2 mm, orientation: 0.2 deg}}\n";
  const System system = system_of(text);
  const TargetPose pose{rotation_from_rpy({0.3, 0.2, 0.4}), {0.1, 0.2, 0.3}};
  const Vector3d r = pose.p - system.devices[0].X_WS().p;
  const double turn = std::pow(0.2 * std::numbers::pi / 180, 2);
  const StateMatrix B = bias_of(system, pose);
  expect_equal(B.topLeftCorner(3, 3),
               4e-6 * Matrix3d::Identity() + turn * cross(r) * cross(r).transpose(),
               1e-9);
  expect_equal(B.bottomRightCorner(3, 3), turn * Matrix3d::Identity(), 1e-9);
}

// A device that the target carries, an arm from its origin: the target is taken for
// displaced by R δ + arm × R φ and turned by R φ.
TEST(Bias, OfACarriedDeviceIsTheDevicesOwn) {
  const std::string text =
      "delos: 1\nmotion: {type: position_velocity, state: pose, q: [1, 1, 1, 1, 1, "
      "1]}\n"
      "sample: {points: [[3, 4, 1.9]]}\n"
      "beacons: {ceiling: {grid: {min: [0, 0, 2.8], max: [6.3, 9, 2.8], step: 0.1}, "
      "normal: [0, 0, -1]}}\ndevices:\n"
      "  - {name: h, type: hiball, rate: 1000 Hz, mount: target, select: mean, at: "
      "[0.1, "
      "-0.05, 0.2], params: {layout: six, views: adjacent, field: 6 deg, r: 2.1e-5},\n"
      "     calibration: {place: 1 mm, orientation: 0.1 deg}}\n";
  const System system = system_of(text);
  const TargetPose pose{rotation_from_rpy({0.05, -0.1, 0.7}), {3, 4, 1.9}};
  const Vector3d arm = pose.R * Vector3d(0.1, -0.05, 0.2);
  const double turn = std::pow(0.1 * std::numbers::pi / 180, 2);
  MatrixXd expected(6, 6);
  expected.topLeftCorner(3, 3) =
      1e-6 * Matrix3d::Identity() + turn * cross(arm) * cross(arm).transpose();
  expected.topRightCorner(3, 3) = turn * cross(arm);
  expected.bottomLeftCorner(3, 3) = expected.topRightCorner(3, 3).transpose();
  expected.bottomRightCorner(3, 3) = turn * Matrix3d::Identity();
  expect_equal(bias_of(system, pose), expected, 1e-11);
}

/// Noiseless readings of all devices of the target's origin, one after another.
VectorXd readings(const System& system, const TargetPose& pose) {
  std::vector<double> all;
  for (const PlacedDevice& placed : system.devices) {
    Target target;
    target.p_ST = placed.X_WS().R.transpose() * (pose.p - placed.X_WS().p);
    Observation out;
    EXPECT_TRUE(placed.device->observe(target, out));
    all.insert(all.end(), out.z.begin(), out.z.end());
  }
  return Eigen::Map<VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// A scene whose devices are off by errors drawn as they say.
Scene drawn(Scene scene, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const auto three = [&] {
    const double x = normal(random), y = normal(random), z = normal(random);
    return Vector3d(x, y, z);
  };
  for (DeviceEntry& device : scene.devices) {
    const Pose X = device_pose(scene, device);
    const Vector3d place = three().cwiseProduct(device.calibration.place);
    const Vector3d turn = three().cwiseProduct(device.calibration.orientation);
    const Eigen::Quaterniond q(
        X.R * Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()).matrix());
    device.placement = {X.p + X.R * place,
                        QuaternionWxyz{{q.w(), q.x(), q.y(), q.z()}}};
    for (const auto& [name, deviation] : device.calibration.params)
      device.params.set(name, device.params[name] + deviation * normal(random));
    device.calibration.params.clear();
  }
  return scene;
}

/// The steady filter of a system, which believes its scene, at a target at rest: what
/// it is off by in the end, over rigs that are off.
void expect_filters_as_predicted(const Scene& scene) {
  const TargetPose pose{Matrix3d::Identity(), {0.2, -0.3, 0.1}};
  const System system = build_system(scene, test::plugins());
  const StateMatrix B = bias_of(system, pose);
  const WhitenedRows rows = whitened_rows(system, pose);
  const Eigen::Index m = rows.rows.rows();
  MatrixXd H = MatrixXd::Zero(m, 6);
  H.leftCols(3) = rows.rows;
  System scatter = system;
  scatter.error = ErrorPart::scatter;
  const MatrixXd P = testing::state_at(scatter, pose).prior;
  const MatrixXd K =
      P * H.transpose() * (H * P * H.transpose() + MatrixXd::Identity(m, m)).inverse();
  const MatrixXd A = discretize(system.motion, system.devices[0].period).A;
  const MatrixXd loop = (MatrixXd::Identity(6, 6) - K * H) * A;
  const VectorXd z = readings(system, pose);
  const VectorXd scale =
      Eigen::Map<const VectorXd>(rows.variance.data(), m).cwiseSqrt().cwiseInverse();
  std::mt19937_64 random(31);
  std::normal_distribution<double> normal;
  constexpr int kRuns = 10'000;
  MatrixXd sum = MatrixXd::Zero(3, 3);
  for (int run = 0; run < kRuns; ++run) {
    VectorXd dz =
        readings(build_system(drawn(scene, random), test::plugins(), &system), pose) -
        z;
    Eigen::Index row = 0;
    for (const PlacedDevice& device : system.devices)
      for (Eigen::Index r = 0; r < m / static_cast<Eigen::Index>(system.devices.size());
           ++r)
        dz(row++) += device.calibration.offset * normal(random);
    const VectorXd input = K * scale.cwiseProduct(dz);
    VectorXd e = VectorXd::Zero(6);
    for (int k = 0; k < 100; ++k) e = loop * e + input;
    EXPECT_LT(e.tail(3).norm(), 1e-3 * (e.head(3).norm() + 1e-9)) << "it stays";
    sum += e.head(3) * e.head(3).transpose() / kRuns;
  }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j)
      EXPECT_NEAR(sum(i, j), B(i, j),
                  4.5 * std::sqrt((B(i, i) * B(j, j) + B(i, j) * B(i, j)) / kRuns))
          << i << ", " << j;
}

TEST(Bias, IsThatOfFiltersThatDontKnowOfDrawnErrors) {
  expect_filters_as_predicted(
      scene_of(three_ranges("calibration: {place: 1 cm, offset: 2 cm}")));
  expect_filters_as_predicted(scene_of(two_cameras(
      "calibration: {place: 3 mm, orientation: 0.1 deg, offset: 0.5 px, params: "
      "{field_of_view: 0.2 deg}}")));
}

/// A chain as what it is, and as matrices that are the same.
System as_matrices(System system) {
  const MotionStep step = discretize(system.motion, system.devices[0].period);
  system.motion.dynamics = CustomMotion{step.A, step.Q};
  return system;
}

TEST(Bias, OfAnyMotionIsTheFixedPointOfTheFilter) {
  const TargetPose pose{Matrix3d::Identity(), {0.2, -0.3, 0.1}};
  const System chain = system_of(two_cameras(
      "calibration: {place: 3 mm, orientation: 0.1 deg, params: {sigma: 0.1 px}}"));
  const StateMatrix by_chain = bias_of(chain, pose);
  const StateMatrix general = whole_bias(as_matrices(chain), pose);
  ASSERT_EQ(general.rows(), 6);
  expect_equal(general.topLeftCorner(3, 3), by_chain, 1e-9 * by_chain.norm());
  EXPECT_LT(general.bottomRightCorner(3, 3).norm(), 1e-9 * by_chain.norm());
}

// Under continuous fusion a reading counts by its rate: one of twice the rate has two
// thirds of the say.
TEST(Bias, CountsEachReadingByItsRate) {
  const std::string device =
      ", type: range, params: {sigma: 3 cm}, calibration: {offset: 6 cm}, ";
  const System system = system_of(
      "delos: 1\nmotion: {type: position_velocity, q: [0.4, 0.4, 0.4]}\n"
      "sample: {points: [[0, 0, 0]]}\ndevices:\n  - {name: a" +
      device + "at: [4, 0, 0], rate: 20 Hz}\n  - {name: b" + device +
      "at: [5, 0, 0], rate: 10 Hz}\n  - {name: c" + device +
      "at: [0, 4, 0], rate: 10 Hz}\n  - {name: d" + device +
      "at: [0, 0, 4], rate: 10 Hz}\n");
  ASSERT_EQ(system.fusion, Fusion::continuous);
  expect_equal(bias_of(system, kOrigin),
               36e-4 * Vector3d(5. / 9, 1, 1).asDiagonal().toDenseMatrix(), 1e-14);
}

// What is estimated is no bias: two readings of one axis, of which one has a state for
// what it is off by.
TEST(Bias, OfWhatIsEstimatedIsNone) {
  class Biased final : public Device {
   public:
    explicit Biased(bool estimated) : estimated_(estimated) {}
    std::vector<OwnState> states() const override {
      return estimated_ ? std::vector<OwnState>{{"bias", "m", 1e9, 1e-6}}
                        : std::vector<OwnState>{};
    }
    bool observe(const Target& target, Observation& out) const override {
      out.z = target.p_ST;
      out.H.setZero(3, estimated_ ? 4 : 3);
      out.H.leftCols(3).setIdentity();
      if (estimated_) out.H(0, 3) = 1;
      out.R = 1e-4 * Matrix3d::Identity();
      return true;
    }

   private:
    bool estimated_;
  };
  System system;
  system.motion = testing::chain_motion(PoseState::position, 2, Matrix3d::Identity());
  system.markers = {Vector3d::Zero()};
  const Pose off{Matrix3d::Identity(), {5, 5, 5}};
  system.devices = {testing::place("a", std::make_shared<Biased>(true), off, 50),
                    testing::place("b", std::make_shared<Biased>(false), off, 50)};
  system.motion.layout.extra = {"a_bias"};
  system.motion.own = {{1e9, 1e-6}};
  system.devices[0].own = {6, 1};
  system.devices[0].calibration.offset = 0.1;
  const StateMatrix B = whole_bias(system, kOrigin);
  EXPECT_NEAR(B(0, 0), 0, 1e-8) << "its state takes it up";
  EXPECT_NEAR(B(6, 6), 0.01, 1e-7);
  EXPECT_NEAR(B(1, 1), 0.01 / 4, 1e-9) << "of y nothing does";
}

}  // namespace
}  // namespace delos
