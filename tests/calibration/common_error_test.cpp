// Errors that devices have in common, and readings that are late: closed forms, the
// filter of a target that really moves, and drawn rigs that are really off.
#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>

#include "delos/field/point.h"
#include "delos/layers/layers.h"
#include "delos/simulation/simulate.h"
#include "scenes.h"
#include "support/rigs.h"

namespace delos {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using test::scene_of;
using test::system_of;
using test::three_ranges;
using test::two_cameras;

constexpr double kRadian = std::numbers::pi / 180;

Matrix3d bias_at(System system, const Vector3d& p) {
  system.error = ErrorPart::bias;
  return evaluate_point(system, {Matrix3d::Identity(), p},
                        testing::metric_of(system, "coverage"))
      .state.prior.topLeftCorner<3, 3>();
}

void expect_near(const Matrix3d& B, const Matrix3d& expected, double tolerance) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(B(i, j), expected(i, j), tolerance);
}

// Three ranges along the axes, all 4 m: what each is off by is what the estimate is off
// by along its axis, and what they have in common is off along all axes at once.
TEST(CommonErrors, OfOrthogonalRangesAddUpBeforeTheyAreSquared) {
  const Matrix3d ones = Matrix3d::Ones();
  const auto of = [](const std::string& errors) {
    return bias_at(system_of(three_ranges("phase: 0",
                                          "target: {speed: 3 m/s}\n"
                                          "common_errors: {e: {" +
                                              errors + "}}\n")),
                   Vector3d::Zero());
  };
  expect_near(of("offset: 5 cm"), 25e-4 * ones, 1e-15);
  expect_near(of("scale: 1 %"), 16e-4 * ones, 1e-15);
  expect_near(of("offset: 5 cm, devices: [r1, r2]"),
              25e-4 * (Matrix3d() << 1, 1, 0, 1, 1, 0, 0, 0, 0).finished(), 1e-15);
  // Late by τ, a target that goes v is taken for v τ behind, whoever sees it.
  expect_near(of("delay: 10 ms"), 1e-4 * 9 / 3 * Matrix3d::Identity(), 1e-15);
  // Each its own.
  expect_near(
      bias_at(system_of(three_ranges("calibration: {scale: 1 %}")), Vector3d::Zero()),
      16e-4 * Matrix3d::Identity(), 1e-15);
  // Of two along one axis, each late by itself, the mean is half as far off, squared.
  const std::string late = "calibration: {delay: 10 ms}";
  expect_near(
      bias_at(system_of(three_ranges(late, "target: {speed: 3 m/s}\n") +
                        "  - {name: r4, type: range, rate: 20 Hz, params: {sigma: 3 "
                        "cm}, at: [-7, 0, 0], " +
                        late + "}\n"),
              Vector3d::Zero()),
      3e-4 * Vector3d(0.5, 1, 1).asDiagonal().toDenseMatrix(), 1e-15);
}

// A rig that is put up wrong as one takes everything it sees along: displaced by δ and
// turned by φ about its origin the target is off by −δ − φ × r, whatever the rig.
TEST(CommonErrors, OfARigMoveWhatItSees) {
  const std::string rig =
      "delos: 1\nmotion: {type: position_velocity, q: [0.4, 0.4, 0.4]}\n"
      "sample: {points: [[0, 0, 0]]}\n"
      "groups: {rig: {at: [1, 2, 0.5], rpy: [0, 0, 30 deg]}}\n"
      "common_errors: {frame: {group: rig, place: [1 mm, 2 mm, 3 mm], orientation: "
      "[0.1 deg, 0.2 deg, 0.3 deg]}}\ndevices:\n";
  const std::string cameras =
      "  - {name: a, type: camera, group: rig, rate: 50 Hz, at: [-0.5, 0, 0], aim: "
      "[0, 0.2, 4], params: {resolution: [1280, 960], field_of_view: 60 deg, sigma: "
      "0.3}}\n"
      "  - {name: b, type: camera, group: rig, rate: 50 Hz, at: [0.5, 0.1, 0], aim: "
      "[0, 0, 4], params: {resolution: [1280, 960], field_of_view: 60 deg, sigma: "
      "0.5}}\n";
  const Vector3d p(1.1, 1.9, 4.3);
  const Matrix3d R = rotation_from_rpy({0, 0, 30 * kRadian});
  const Vector3d r = p - Vector3d(1, 2, 0.5);
  Matrix3d cross;
  cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  const Matrix3d place = R * Vector3d(1e-6, 4e-6, 9e-6).asDiagonal() * R.transpose(),
                 turn = R *
                        (kRadian * kRadian * Vector3d(0.01, 0.04, 0.09)).asDiagonal() *
                        R.transpose();
  const Matrix3d B = bias_at(system_of(rig + cameras), p);
  expect_near(B, place + cross * turn * cross.transpose(), 1e-13);
  // Each by itself they are off another way.
  EXPECT_GT(
      (B - bias_at(system_of(two_cameras("calibration: {place: 2 mm}")), p)).norm(),
      1e-6);
}

TEST(CommonErrors, SayWhatTheyAreWorth) {
  const System system = system_of(
      three_ranges("calibration: {offset: 2 cm}",
                   "common_errors: {sound: {scale: 1 %}, board: {offset: 1 cm}}\n"));
  const Metric metric = testing::metric_of(system, "trace");
  const PointReport report =
      evaluate_point(system, {Matrix3d::Identity(), Vector3d::Zero()}, metric);
  ASSERT_TRUE(report.budget);
  ASSERT_EQ(report.budget->common.size(), 2u);
  const auto m = static_cast<std::size_t>(
      std::find_if(report.metrics.begin(), report.metrics.end(),
                   [](const MetricValue& v) { return v.metric.name == "trace"; }) -
      report.metrics.begin());
  const double total = report.budget->total[m];
  EXPECT_NEAR(report.budget->bias[m], 3 * (4e-4 + 16e-4 + 1e-4), 1e-12);
  EXPECT_NEAR(report.budget->common[0].calibration, 48e-4 / total, 1e-9);
  EXPECT_NEAR(report.budget->common[1].calibration, 3e-4 / total, 1e-9);
  EXPECT_NEAR(report.devices[0].calibration, 4e-4 / total, 1e-9);
}

// A target that goes straight on, ranges that are really read late, and the steady
// filter of the scene, which doesn't know: what it is off by when the target passes.
TEST(CommonErrors, DelaysAreThoseOfATargetThatMoves) {
  const std::string far =
      "delos: 1\nmotion: {type: position_velocity, q: [0.4, 0.4, 0.4]}\n"
      "target: {speed: 2 m/s}\nsample: {points: [[0, 0, 0]]}\n"
      "common_errors: {clock: {delay: 20 ms}}\ndevices:\n"
      "  - {name: a, type: range, rate: 20 Hz, at: [5000, 100, 0], params: {reach: "
      "9000, sigma: 3 cm}, calibration: {delay: 10 ms}}\n"
      "  - {name: b, type: range, rate: 20 Hz, at: [0, 4000, 300], params: {reach: "
      "9000, sigma: 5 cm}, calibration: {delay: 10 ms}}\n"
      "  - {name: c, type: range, rate: 20 Hz, at: [3000, 0, 5000], params: {reach: "
      "9000, sigma: 3 cm}, calibration: {delay: 10 ms}}\n"
      "  - {name: d, type: range, rate: 20 Hz, at: [0, -4000, 4000], params: {reach: "
      "9000, sigma: 3 cm}, calibration: {delay: 10 ms}}\n";
  const System system = system_of(far);
  const Matrix3d B = bias_at(system, Vector3d::Zero());
  const WhitenedRows rows =
      whitened_rows(system, {Matrix3d::Identity(), Vector3d::Zero()});
  MatrixXd H = MatrixXd::Zero(4, 6);
  H.leftCols(3) = rows.rows;
  System scatter = system;
  scatter.error = ErrorPart::scatter;
  const MatrixXd P =
      testing::state_at(scatter, {Matrix3d::Identity(), Vector3d::Zero()}).prior;
  const MatrixXd K =
      P * H.transpose() * (H * P * H.transpose() + MatrixXd::Identity(4, 4)).inverse();
  const double dt = 0.05;
  MatrixXd A = MatrixXd::Identity(6, 6);
  A.topRightCorner(3, 3) = dt * Matrix3d::Identity();
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  constexpr int kRuns = 10'000, kSteps = 80;
  Matrix3d sum = Matrix3d::Zero();
  for (int run = 0; run < kRuns; ++run) {
    const double x = normal(random), y = normal(random), z = normal(random);
    const Vector3d v = 2 / std::sqrt(3.0) * Vector3d(x, y, z);
    const double common = 0.02 * normal(random);
    Eigen::Vector4d late;
    for (double& one : late) one = common + 0.01 * normal(random);
    Eigen::VectorXd estimate = Eigen::VectorXd::Zero(6);
    for (int k = -kSteps; k <= 0; ++k) {
      Eigen::Vector4d reading;
      for (int i = 0; i < 4; ++i)
        reading(i) = rows.rows.row(i).dot(v * (k * dt - late(i)));
      estimate = A * estimate;
      estimate += K * (reading - H * estimate);
    }
    sum += estimate.head<3>() * estimate.head<3>().transpose() / kRuns;
  }
  // τ v is no normal number: its fourth moment is 9 σ⁴, of which eight are its square's
  // variance.
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j)
      EXPECT_NEAR(sum(i, j), B(i, j), 4.5 * std::sqrt(8 * B(i, i) * B(j, j) / kRuns))
          << i << ", " << j;
}

/// Filters on readings of rigs that are off as drawn, against the total. They begin
/// where the target is, and take their time to be off.
Simulation expect_total(const System& system, const Vector3d& p, int runs) {
  const TargetPose pose{Matrix3d::Identity(), p};
  const double once = simulate(system, pose, {.runs = 2}).time_constant;
  const Simulation s =
      simulate(system, pose, {.runs = runs, .seed = 11, .seconds = 12 * once});
  EXPECT_LE(s.lost, 5u) << "targets that come from behind the devices";
  for (const SimulatedCovariance& c : s.covariances)
    for (Eigen::Index i = 0; i < c.predicted.rows(); ++i)
      for (Eigen::Index j = 0; j <= i; ++j)
        EXPECT_NEAR(c.measured(i, j), c.predicted(i, j), 4.5 * c.error(i, j))
            << c.name << ' ' << i << ", " << j;
  return s;
}

TEST(DrawnErrors, OfRangesAreTheTotal) {
  const System system = system_of(three_ranges(
      "calibration: {place: 1 cm, offset: 2 cm, params: {sigma: 1 mm}}",
      "target: {speed: 1 m/s}\n"
      "common_errors: {sound: {scale: 0.5 %}, board: {offset: 2 cm, delay: 10 ms}}\n"));
  const Simulation s = expect_total(system, {0.2, -0.3, 0.1}, 10'000);
  // Of the prediction a good part is what scatter doesn't have, and the filter doesn't
  // know of.
  System scatter = system;
  scatter.error = ErrorPart::scatter;
  const Simulation alone =
      simulate(scatter, {Matrix3d::Identity(), {0.2, -0.3, 0.1}}, {.runs = 500});
  EXPECT_GT(s.covariances[0].predicted(0, 0),
            1.5 * alone.covariances[0].predicted(0, 0));
  EXPECT_GT(s.instants.back().nees.mean, s.instants.back().nees.upper);
  EXPECT_LT(alone.instants.back().nees.mean, 1.1 * alone.instants.back().nees.upper);
}

TEST(DrawnErrors, OfCamerasAreTheTotal) {
  const System system = system_of(two_cameras(
      "calibration: {place: 3 mm, orientation: 0.1 deg, offset: 0.5 px, params: "
      "{field_of_view: 0.2 deg}}",
      "common_errors: {frame: {place: 2 mm, orientation: 0.1 deg}}\n"));
  expect_total(system, {0.2, -0.3, 0.1}, 10'000);
}

// A HiBall on an arm, put on wrong and read late. As its target moves it looks at other
// LEDs, and scatters by up to 7 % more than where it stands: beside the same runs of
// one that is put on right.
TEST(DrawnErrors, OfAHiBallAddWhatIsPredicted) {
  const System system = system_of(
      "delos: 1\nmotion: {type: position_velocity, state: pose, q: [1, 1, 1, 10, 10, "
      "10]}\ntarget: {speed: 0.5 m/s}\nsample: {points: [[3, 4, 1.9]]}\n"
      "beacons: {ceiling: {grid: {min: [0, 0, 2.8], max: [6.3, 9, 2.8], step: 0.1}, "
      "normal: [0, 0, -1]}}\ndevices:\n"
      "  - {name: h, type: hiball, rate: 100 Hz, mount: target, select: nearest, "
      "count: "
      "10, at: [0.1, -0.05, 0.2], params: {layout: six, views: adjacent, field: 6 deg, "
      "r: 2.1e-5},\n     calibration: {place: 3 mm, orientation: 0.1 deg, delay: 5 "
      "ms}}\n");
  const auto run = [&](ErrorPart part) {
    System of = system;
    of.error = part;
    return simulate(of, {Matrix3d::Identity(), {3, 4, 1.9}},
                    {.runs = 10'000, .seed = 11, .seconds = 0.14})
        .covariances[0];
  };
  const SimulatedCovariance total = run(ErrorPart::total),
                            scatter = run(ErrorPart::scatter);
  EXPECT_GT(total.predicted(0, 0), 3 * scatter.predicted(0, 0));
  for (Eigen::Index i = 0; i < 6; ++i)
    for (Eigen::Index j = 0; j <= i; ++j)
      EXPECT_NEAR(total.measured(i, j) - scatter.measured(i, j),
                  total.predicted(i, j) - scatter.predicted(i, j),
                  4.5 * std::hypot(total.error(i, j), scatter.error(i, j)))
          << i << ", " << j;
}

TEST(DrawnErrors, AreTheSameForAnyNumberOfThreads) {
  const System system = system_of(two_cameras("calibration: {orientation: 0.1 deg}"));
  const auto run = [&](int threads) {
    return simulate(system, {Matrix3d::Identity(), Vector3d::Zero()},
                    {.runs = 70, .seed = 3, .seconds = 0.2, .threads = threads})
        .covariances[0]
        .measured;
  };
  EXPECT_EQ(run(1), run(3));
}

TEST(DrawnErrors, OfBiasAloneArentSimulated) {
  System system = system_of(three_ranges("calibration: {offset: 2 cm}"));
  system.error = ErrorPart::bias;
  EXPECT_THROW((void)simulate(system, {Matrix3d::Identity(), Vector3d::Zero()}, {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace delos
