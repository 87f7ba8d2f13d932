// Where linearising a reading can't be trusted: against closed forms, draws and a
// textbook's unscented update.
#include "field/linearisation.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

#include "delos/field/point.h"
#include "support/rigs.h"

namespace delos {
namespace {

using testing::acoustic_system;
using testing::metric_of;

const TargetPose kInVolume{Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.5}};

double value_at(const System& system, const TargetPose& pose, const char* name) {
  return evaluate_field(system, testing::points({pose.p}), {}, metric_of(system, name))
      .value[0];
}

/// A range r with R = 0.005 r² over x ~ N(·, P): G = (I − u uᵀ)/r, so that in closed
/// form E[ρ²] = (½ tr GP)² + ½ tr GPGP.
TEST(Linearisation, OfRangesIsTheClosedForm) {
  const System system = acoustic_system();
  const StateMatrix P = evaluate_point(system, kInVolume, metric_of(system, "eigmax"))
                            .state.prior.topLeftCorner(3, 3);
  double largest = 0;
  for (const PlacedDevice& placed : system.devices) {
    const Eigen::Vector3d to = kInVolume.p - placed.X_WS().p;
    const double r = to.norm();
    const Eigen::Matrix3d u = to * to.transpose() / (r * r),
                          G = (Eigen::Matrix3d::Identity() - u) / r, GP = G * P;
    const double square = std::pow(GP.trace() / 2, 2) + (GP * GP).trace() / 2;
    largest = std::max(largest, std::sqrt(square / (0.005 * r * r)));
  }
  EXPECT_NEAR(value_at(system, kInVolume, "nonlinearity"), largest, 1e-6 * largest);
}

/// It is of the error before an update, also where the field's numbers are of that
/// after it, and of a state that is solved whole or by scalar chains.
TEST(Linearisation, IsOfTheErrorBeforeAnUpdate) {
  System system = acoustic_system();
  const double before = value_at(system, kInVolume, "nonlinearity"),
               ratio = value_at(system, kInVolume, "unscented_ratio");
  system.covariance = CovarianceKind::posterior;
  EXPECT_NEAR(value_at(system, kInVolume, "nonlinearity"), before, 1e-9 * before);
  EXPECT_NEAR(value_at(system, kInVolume, "unscented_ratio"), ratio, 1e-9);
}

/// Eq. 52, 53 of Allen (2007): v = 1.5 m/s, δt = 20 ms; a range of r and 30 mm across
/// it. The table is computed from the printed equation.
TEST(Linearisation, LeavesOutWhatEquation52Says) {
  const double r[] = {0.3, 0.5, 1, 2},
               dr[] = {1.49627e-3, 8.99191e-4, 4.49899e-4, 2.24987e-4};
  System system = acoustic_system();
  system.devices.resize(1);
  system.devices[0].mount = WorldMount{Pose{}};
  for (int i = 0; i < 4; ++i) {
    const TargetPose pose{Eigen::Matrix3d::Identity(), {r[i], 0, 0}};
    const ReadingModel model(system, pose, 6);
    const TrackReading reading{0, 0, 0, {0, 6}, {}};
    PredictedReading here, there;
    StateVector x = StateVector::Zero(6);
    ASSERT_TRUE(model.predict(reading, x, pose.R, here));
    x(1) = 1.5 * 0.02;
    ASSERT_TRUE(model.predict(reading, x, pose.R, there));
    const double left = there.z(0) - here.z(0) - here.H.row(0).dot(x);
    EXPECT_NEAR(left, dr[i], 6e-9);
    // The metric's second order of it, with that error and no other.
    StateMatrix P = StateMatrix::Zero(6, 6);
    P(1, 1) = x(1) * x(1);
    const double rms = LinearisationCheck(system).at(pose, P).nonlinearity;
    const double noise = std::sqrt(0.005) * r[i];
    EXPECT_NEAR(rms * noise, std::sqrt(3.0) * x(1) * x(1) / (2 * r[i]), 1e-8);
  }
}

/// Image coordinates of a point, and their noise.
class Pinhole final : public Device {
 public:
  bool observe(const Target& t, Observation& out) const override {
    const Eigen::Vector3d& p = t.p_ST;
    out.z = Eigen::Vector2d(p.x(), p.y()) / p.z();
    out.H.resize(2, 3);
    out.H << 1 / p.z(), 0, -p.x() / (p.z() * p.z()), 0, 1 / p.z(),
        -p.y() / (p.z() * p.z());
    out.R.resize(2, 2);
    out.R << 4e-4, 1e-4, 1e-4, 2e-4;
    return true;
  }
};

/// A body of one marker on an arm, that turns: rms of what is left of drawn errors.
TEST(Linearisation, OfABodyThatTurnsIsThatOfDrawnErrors) {
  System system;
  system.motion =
      testing::chain_motion(PoseState::pose, 1, CoordinateMatrix::Identity(6, 6));
  system.markers = {Eigen::Vector3d(0.3, -0.2, 0.1)};
  system.devices = {testing::place("c", std::make_shared<Pinhole>(), {}, 50)};
  std::mt19937_64 random(5);
  const TargetPose pose{testing::random_rotation(random), {0.2, 0.1, 1.5}};
  std::normal_distribution<double> normal;
  StateMatrix L = StateMatrix::Zero(6, 6);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j <= i; ++j) L(i, j) = 0.02 * normal(random);
  const Linearisation at = LinearisationCheck(system).at(pose, L * L.transpose());

  const ReadingModel model(system, pose, 6);
  const TrackReading reading{0, 0, 0, {0, 6}, {}};
  PredictedReading middle, drawn;
  ASSERT_TRUE(model.predict(reading, StateVector::Zero(6), pose.R, middle));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> split(Eigen::Matrix2d(middle.R));
  Eigen::Vector2d squares(0, 0);
  const int draws = 40000;
  for (int i = 0; i < draws; ++i) {
    StateVector e(6), x = StateVector::Zero(6);
    for (double& number : e) number = normal(random);
    e = (L * e).eval();
    Eigen::Matrix3d R = pose.R;
    move_state(system.motion.layout, e, x, R);
    ASSERT_TRUE(model.predict(reading, x, R, drawn));
    const Eigen::Vector2d left = drawn.z - middle.z - middle.H * e;
    squares += (split.eigenvectors().transpose() * left).cwiseAbs2();
  }
  const double largest =
      (squares.cwiseQuotient(split.eigenvalues()) / draws).maxCoeff();
  EXPECT_NEAR(at.nonlinearity / std::sqrt(largest), 1, 0.03);
}

/// One reading after another by a textbook's formulas.
TEST(Linearisation, ComparesWithATextbooksUnscentedUpdate) {
  const System system = acoustic_system(12.5);
  const Eigen::MatrixXd prior =
      evaluate_point(system, kInVolume, metric_of(system, "eigmax")).state.prior;
  Eigen::MatrixXd points = prior, linear = prior;
  for (const PlacedDevice& placed : system.devices) {
    const auto range = [&](const Eigen::VectorXd& x) {
      return (kInVolume.p + x.head<3>() - placed.X_WS().p).norm();
    };
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(6);
    const double r = range(none), noise = 0.005 * r * r;
    const Eigen::MatrixXd root =
        (6 * points).llt().matrixL();  // κ = 0 from three states on
    std::vector<Eigen::VectorXd> x;
    for (int k = 0; k < 6; ++k)
      for (const double sign : {1., -1.}) x.push_back(sign * root.col(k));
    double mean = 0, S = noise;
    Eigen::VectorXd C = none;
    for (const auto& p : x) mean += range(p) / 12;
    for (const auto& p : x) {
      S += std::pow(range(p) - mean, 2) / 12;
      C += p * (range(p) - mean) / 12;
    }
    points -= C * C.transpose() / S;
    Eigen::VectorXd h = none;
    h.head<3>() = (kInVolume.p - placed.X_WS().p) / r;
    linear -= linear * h * h.transpose() * linear / (h.dot(linear * h) + noise);
  }
  const double ratio = std::sqrt(points.topLeftCorner(3, 3).trace() /
                                 linear.topLeftCorner(3, 3).trace());
  EXPECT_GT(ratio, 1.002);
  EXPECT_NEAR(value_at(system, kInVolume, "unscented_ratio"), ratio, 1e-9);
}

/// A place itself, read.
class Fix final : public Device {
 public:
  bool observe(const Target& t, Observation& out) const override {
    out.z = t.p_ST;
    out.H.setIdentity(3, 3);
    out.R.setIdentity(3, 3);
    out.R *= 1e-3;
    return true;
  }
};

TEST(Linearisation, OfLinearReadingsIsNothing) {
  System system = acoustic_system();
  system.devices = {testing::place("fix", std::make_shared<Fix>(), {}, 50)};
  EXPECT_LT(value_at(system, kInVolume, "nonlinearity"), 1e-9);
  EXPECT_NEAR(value_at(system, kInVolume, "unscented_ratio"), 1, 1e-12);
}

TEST(Linearisation, IsInfiniteWhereADirectionIsLostAndRefusedWithoutAFilter) {
  System system = acoustic_system();
  system.devices.resize(2);
  const Metric metric = metric_of(system, "nonlinearity");
  EXPECT_TRUE(std::isinf(value_at(system, kInVolume, "nonlinearity")));
  EXPECT_TRUE(std::isinf(value_at(system, kInVolume, "unscented_ratio")));
  EXPECT_EQ(metric_problem(system, metric), "");
  System other = system;
  other.covariance = CovarianceKind::single;
  EXPECT_NE(metric_problem(other, metric).find("covariance: prior"), std::string::npos);
  other = system;
  other.fusion = Fusion::artemis;
  EXPECT_NE(metric_problem(other, metric).find("artemis"), std::string::npos);
  other = system;
  other.lag = 0.01;
  EXPECT_NE(metric_problem(other, metric).find("lag"), std::string::npos);
}

/// Of a cycle it is that of the worst instant, and any number of threads says the same.
TEST(Linearisation, IsThatOfTheWorstInstantOfACycle) {
  System system = acoustic_system();
  system.fusion = Fusion::periodic;
  for (std::size_t i = 0; i < 4; ++i)
    system.devices[i].phase = 0.005 * static_cast<double>(i);
  const PointReport report =
      evaluate_point(system, kInVolume, metric_of(system, "nonlinearity"));
  const Linearisation worst =
      LinearisationCheck(system).at(kInVolume, report.state.worst_prior);
  EXPECT_EQ(value_at(system, kInVolume, "nonlinearity"), worst.nonlinearity);
  const Samples samples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.1);
  const auto with = [&](int threads) {
    return evaluate_field(system, samples, {}, metric_of(system, "unscented_ratio"),
                          {.threads = threads})
        .value;
  };
  EXPECT_EQ(with(1), with(3));
}

}  // namespace
}  // namespace delos
