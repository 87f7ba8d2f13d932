// Worlds that are planes: dilutions of precision, motion in continuous time, and the
// robot of scene 18.
#include <Eigen/LU>
#include <numbers>
#include <sstream>

#include "shipped.h"

namespace delos::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Anchors of ranges of 1 m at the corners of a regular polygon around the origin.
std::string polygon(int corners) {
  std::ostringstream text;
  text.precision(17);
  text << "delos: 1\n"
          "motion: {type: position_velocity, state: planar, q: [0.4, 0.4]}\n"
          "covariance: single\n"
          "metric: sigma_horizontal\n"
          "sample: {points: [[0, 0, 1.2]]}\n"
          "devices:\n";
  for (int i = 0; i < corners; ++i) {
    const double angle = 0.3 + 2 * kPi * i / corners;
    text << "  - {name: a" << i << ", type: uwb_range, rate: 10 Hz, at: ["
         << 4 * std::cos(angle) << ", " << 4 * std::sin(angle)
         << ", 1.2], params: {sigma: 1 m}}\n";
  }
  return text.str();
}

// Σ u uᵀ of n unit vectors at equal angles is n/2 of the identity: HDOP = √(4/n).
TEST(Plane, HorizontalDilutionInARegularPolygonIsTwoOverTheRootOfItsCorners) {
  for (const int corners : {3, 4, 5, 6, 7, 12, 40}) {
    const Scene scene = scene_of(polygon(corners));
    EXPECT_NEAR(value_of(scene, "sigma_horizontal"), 2 / std::sqrt(corners), 1e-12);
    EXPECT_NEAR(value_of(scene, "sigma_x"), std::sqrt(2.0 / corners), 1e-12);
  }
}

// Two anchors fix what lies in a plane, which in space they don't.
TEST(Plane, NeedsOneDeviceLessThanSpace) {
  const Scene flat =
      load("15-uwb-anchors", {{"motion.state", "planar"},
                              {"motion.q", "[0.4, 0.4]"},
                              {"sample", "{points: [[2, 2, 1], [6, 2, 1]]}"}});
  Scene two = flat;
  two.devices.resize(2);
  two.occluders.clear();
  EXPECT_TRUE(std::isfinite(value_of(two, "sigma_position")));
  two.motion.layout.pose = PoseState::position;
  two.motion.dynamics = ChainMotion{CoordinateMatrix::Identity(3, 3)};
  EXPECT_TRUE(std::isinf(value_of(two, "sigma_position")));
}

// The same chain, told by its matrices: the general solvers against the closed forms.
TEST(ContinuousMotion, OfAChainGivesTheChainsCovariance) {
  const Scene chain =
      load("01-acoustic", {{"motion.state", "planar"}, {"motion.q", "[0.4, 0.3]"}});
  Scene matrices = chain;
  const MotionStep form = continuous_form(chain.motion);
  matrices.motion.dynamics = ContinuousMotion{form.A, form.Q};
  for (const Fusion fusion : {Fusion::stacked, Fusion::continuous, Fusion::periodic,
                              Fusion::sequential, Fusion::artemis}) {
    Scene a = chain, b = scene_of(write_scene(matrices));
    a.fusion = b.fusion = fusion;
    for (const char* metric : {"eigmax", "sigma_vy", "mle"}) {
      const double expected = value_of(a, metric);
      EXPECT_NEAR(value_of(b, metric), expected, 1e-9 * expected) << to_string(fusion);
    }
  }
}

// A level that returns to its mean: the scalar filter's quadratic, written out.
//   p = φ² p r/(p + r) + Q  ⇒  p² + (r (1 − φ²) − Q) p − Q r = 0
TEST(ContinuousMotion, OfOneStateIsTheScalarFilter) {
  const Scene scene = scene_of(R"(delos: 1
motion: {type: continuous, state: none, names: [level], A: [[-2]], Q: [[3]]}
metric: sigma_level
sample: {points: [[0, 0, 0]]}
devices: [{name: a, type: linear, rate: 10 Hz, params: {H: [[1]], R: [[0.5]]}}]
)");
  const double phi = std::exp(-0.2), Q = 3 * (1 - std::exp(-0.4)) / 4, r = 0.5;
  const double b = r * (1 - phi * phi) - Q;
  const double p = (-b + std::sqrt(b * b + 4 * Q * r)) / 2;
  EXPECT_NEAR(value_of(scene, "sigma_level"), std::sqrt(p), 1e-12);
  // Read all the time with 1/r ten times a second: −4 p + 3 − 20 p² = 0.
  Scene always = scene;
  always.fusion = Fusion::continuous;
  EXPECT_NEAR(value_of(always, "sigma_level"),
              std::sqrt((-4 + std::sqrt(16 + 240.0)) / 40), 1e-12);
}

/// Covariance of x, y, θ from one look at the landmarks: rows of a bearing's Jacobian,
/// [Δy, −Δx]/r² and −1.
Eigen::Matrix3d look(double x, double y) {
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  const double sigma = 1.2018 * kPi / 180;
  for (const Eigen::Vector2d& landmark :
       {Eigen::Vector2d(0, 0), {6, 0}, {6, 6}, {0, 6}}) {
    const Eigen::Vector2d d = landmark - Eigen::Vector2d(x, y);
    const Eigen::Vector3d h =
        Eigen::Vector3d(d.y() / d.squaredNorm(), -d.x() / d.squaredNorm(), -1) / sigma;
    S += h * h.transpose();
  }
  return S.inverse();
}

TEST(FloorRobot, KnowsItsPlaceAsFourBearingsDo) {
  const Field field = field_of("18-floor-robot");
  Scene turned = load("18-floor-robot");
  turned.metric = "sigma_yaw";
  const Field yaw = field_of(turned);
  ASSERT_EQ(field.value.size(), 121u);
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    const Eigen::Vector3d& p = field.samples.points[i];
    const Eigen::Matrix3d P = look(p.x(), p.y());
    const double expected = std::sqrt(P(0, 0) + P(1, 1));
    EXPECT_NEAR(field.value[i], expected, 1e-12 * expected) << p.transpose();
    EXPECT_NEAR(yaw.value[i], std::sqrt(P(2, 2)), 1e-12 * std::sqrt(P(2, 2)));
  }
}

// The scene's header.
TEST(FloorRobot, GivesTheNumbersOfItsHeader) {
  const Field field = field_of("18-floor-robot");
  const FieldStatistics s = summarize(field);
  EXPECT_NEAR(s.min.value, 0.0868, 5e-5);
  EXPECT_NEAR(s.max.value, 0.117, 5e-4);
  EXPECT_NEAR(value_at(field, {3, 3, 0}), 0.0890, 5e-5);
  double mean = 0;
  for (const double x : {1.5, 3.0, 4.5})
    for (const double y : {1.5, 3.0, 4.5})
      mean += std::pow(value_at(field, {x, y, 0}), 2) / 9;
  EXPECT_NEAR(std::sqrt(mean), 0.0892, 5e-5);
}

}  // namespace
}  // namespace delos::test
