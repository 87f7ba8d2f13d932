// Single readings whose devices share an unknown clock: satellites, and time
// differences.
#include <Eigen/LU>
#include <numbers>
#include <sstream>

#include "delos/scene/definition.h"
#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

/// Pseudoranges of 1 m from one anchor overhead and `around` at an elevation, far away.
std::string sky(double elevation, int around, const std::string& overhead = "rx") {
  constexpr double kFar = 1000;
  std::ostringstream text;
  text.precision(17);
  text << "delos: 1\n"
          "motion: {type: position, q: [1, 1, 1]}\n"
          "covariance: single\n"
          "sample: {points: [[0, 0, 0]]}\n"
          "devices:\n"
          "  - {name: up, type: uwb_range, rate: 1, at: [0, 0, "
       << kFar << "], clock: " << overhead << ", params: {sigma: 1 m, reach: 1 Gm}}\n";
  for (int k = 0; k < around; ++k) {
    const double azimuth = 2 * std::numbers::pi * k / around;
    text << "  - {name: s" << k << ", type: uwb_range, rate: 1, at: ["
         << kFar * std::cos(elevation) * std::cos(azimuth) << ", "
         << kFar * std::cos(elevation) * std::sin(azimuth) << ", "
         << kFar * std::sin(elevation)
         << "], clock: rx, params: {sigma: 1 m, reach: 1 Gm}}\n";
  }
  return text.str();
}

/// With n anchors around at an elevation whose sine is s, HᵀH is diagonal but for z and
/// the clock: VDOP² = (n + 1)/D, TDOP² = (n s² + 1)/D with D = n (1 − s)², and
/// HDOP² = 4/(n cos²).
TEST(Clock, IsSolvedForBesideThePosition) {
  for (const int n : {3, 4, 7})
    for (const double elevation : {0.1, 0.6, 1.2}) {
      const Scene scene = scene_of(sky(elevation, n));
      const double s = std::sin(elevation), c = std::cos(elevation);
      const double D = n * (1 - s) * (1 - s);
      const auto near = [&](const char* metric, double expected) {
        EXPECT_NEAR(value_of(scene, metric), expected, 1e-9 * expected)
            << metric << " " << n << " " << elevation;
      };
      near("sigma_z", std::sqrt((n + 1) / D));
      near("sigma_clock_rx", std::sqrt((n * s * s + 1) / D));
      near("sigma_horizontal", std::sqrt(4 / (n * c * c)));
      near("sigma_position", std::sqrt(4 / (n * c * c) + (n + 1) / D));
    }
}

/// What is left of pseudoranges where the clock is eliminated: the differences to one
/// of them, z_i − z_0, with R = I + 1 1ᵀ of their shared noise. By Eigen's inverse.
TEST(Clock, LeavesWhatTimeDifferencesKnow) {
  const Scene scene = scene_of(R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.1]}
covariance: single
sample: {volume: {min: [0.5, 0.5, 0.3], max: [6, 4, 2.1], step: [1.1, 0.875, 0.6]}}
metric: trace
devices:
  - {name: a, type: uwb_range, rate: 10, at: [0, 0, 2.9], clock: tag, params: &u {sigma: 0.2 m}}
  - {name: b, type: uwb_range, rate: 10, at: [7, 0, 0.2], clock: tag, params: *u}
  - {name: c, type: uwb_range, rate: 10, at: [7, 5, 2.7], clock: tag, params: *u}
  - {name: d, type: uwb_range, rate: 10, at: [0, 5, 0.4], clock: tag, params: *u}
  - {name: e, type: uwb_range, rate: 10, at: [3, 2, 3.0], clock: tag, params: *u}
)");
  const Field field = field_of(scene);
  ASSERT_GT(field.value.size(), 60u);
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    const auto direction = [&](std::size_t k) -> Eigen::RowVector3d {
      return (field.samples.points[i] - scene.devices[k].placement.at)
          .normalized()
          .transpose();
    };
    Eigen::Matrix<double, 4, 3> H;
    for (int k = 0; k < 4; ++k)
      H.row(k) = direction(static_cast<std::size_t>(k) + 1) - direction(0);
    const Eigen::Matrix4d R =
        0.04 * (Eigen::Matrix4d::Identity() + Eigen::Matrix4d::Ones());
    const double trace = (H.transpose() * R.inverse() * H).inverse().trace();
    EXPECT_NEAR(field.value[i], trace, 1e-8 * trace) << i;
  }
}

/// An offset of one's own says nothing; two clocks want a reading more than one.
TEST(Clock, TakesAReadingOfEachClock) {
  EXPECT_TRUE(std::isfinite(value_of(scene_of(sky(0.5, 3)), "sigma_position")));
  EXPECT_TRUE(std::isinf(value_of(scene_of(sky(0.5, 3, "own")), "sigma_position")));
  EXPECT_TRUE(std::isfinite(value_of(scene_of(sky(0.5, 4)), "sigma_position")));
  // Around at one elevation, z and their clock are one direction.
  EXPECT_TRUE(std::isinf(value_of(scene_of(sky(0.5, 4, "own")), "sigma_z")));
  EXPECT_NEAR(value_of(scene_of(sky(0.5, 4, "own")), "sigma_horizontal"),
              value_of(scene_of(sky(0.5, 4)), "sigma_horizontal"), 1e-9);
}

/// A state has 30 numbers at most: three of the position and 27 clocks.
TEST(Clock, IsRefusedWhereTheyAreTooMany) {
  const auto findings_of = [](int clocks) {
    std::string text = sky(0.5, clocks - 1, "own");
    for (int k = 0; k < clocks - 1; ++k) {
      const std::size_t at = text.find("clock: rx");
      text.replace(at, 9, "clock: c" + std::to_string(k));
    }
    Diagnostics findings;
    (void)parse_scene(text, "scene.yaml", {}, plugins(), findings);
    return findings;
  };
  EXPECT_TRUE(findings_of(27).empty());
  const Diagnostics findings = findings_of(28);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NE(to_string(findings[0]).find("31 numbers are unknown; at most 30"),
            std::string::npos)
      << to_string(findings[0]);
}

TEST(Clock, IsAStateOfSingleReadingsAlone) {
  const Scene scene = scene_of(sky(0.5, 3));
  EXPECT_EQ(covariance_layout(scene).names(),
            (std::vector<std::string>{"x", "y", "z", "clock_rx"}));
  EXPECT_EQ(scene_of(write_scene(scene)), scene);

  std::string text = sky(0.5, 3);
  const std::string kind = "covariance: single\n";
  text.erase(text.find(kind), kind.size());
  Diagnostics findings;
  EXPECT_FALSE(parse_scene(text, "scene.yaml", {}, plugins(), findings));
  ASSERT_EQ(findings.size(), 4u);
  EXPECT_NE(to_string(findings[0])
                .find("devices.up.clock: goes with covariance: single; filters learn"),
            std::string::npos)
      << to_string(findings[0]);
}

}  // namespace
}  // namespace delos::test
