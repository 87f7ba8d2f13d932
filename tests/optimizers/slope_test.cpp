// Slopes of objectives and constraints against central differences of the soft score
// itself, on the scenes of scenes/.
#include <cmath>
#include <random>

#include "delos/optimize/problem.h"
#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

struct Case {
  const char* scene;
  const char* variables;
  const char* objective = "{minimize: mean}";
  std::vector<Override> more = {};
  std::size_t samples = 120;
};

std::string name_of_case(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.scene;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name + "_" + std::to_string(info.index);
}

class Slopes : public testing::TestWithParam<Case> {};

// Steps of 2e-6 of the unit cube leave (h/width)² ~ 1e-8 and rounding ~1e-7: both are
// below the tolerance, 1e-5 of the whole slope.
TEST_P(Slopes, MatchCentralDifferences) {
  const Case& c = GetParam();
  std::vector<Override> changes = c.more;
  changes.push_back({"variables", c.variables});
  changes.push_back({"objective", c.objective});
  const Scene scene = load(c.scene, changes);
  Problem problem(scene, plugins(), {c.samples, 2});
  ASSERT_EQ(problem.slope_problem(), "");
  const std::size_t n = problem.design().size(), limits = problem.limits().size();
  std::mt19937_64 random(1);
  for (const double width : {0.3, 0.05}) {
    // A point where no sample sits on a symmetry of the scene.
    std::vector<double> x = problem.design().start();
    for (double& value : x)
      value = std::clamp(
          value + 0.01 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5), 0.01,
          0.99);
    std::vector<double> slope(n), slopes(n * limits);
    const Score score =
        problem.score_with_slopes(x, width, slope.data(), slopes.data());
    ASSERT_TRUE(std::isfinite(score.objective));
    const double size = Eigen::Map<Eigen::VectorXd>(slope.data(), n).norm();
    EXPECT_GT(size, 0);
    constexpr double kStep = 2e-6;
    for (std::size_t v = 0; v < n; ++v) {
      std::vector<double> at = x;
      at[v] = x[v] + kStep;
      const Score up = problem.soft_score(at, width);
      at[v] = x[v] - kStep;
      const Score down = problem.soft_score(at, width);
      EXPECT_NEAR(slope[v], (up.objective - down.objective) / (2 * kStep), 1e-5 * size)
          << scene.variables[v].path << " width " << width;
      for (std::size_t i = 0; i < limits; ++i) {
        const double of_limit = Eigen::Map<Eigen::VectorXd>(&slopes[i * n], n).norm();
        EXPECT_NEAR(slopes[i * n + v], (up.slacks[i] - down.slacks[i]) / (2 * kStep),
                    1e-5 * of_limit)
            << "limit " << i << ", " << scene.variables[v].path;
      }
    }
  }
}

constexpr const char* kPlaces =
    "[{path: devices.*.at, lower: -6, upper: 7}, {path: devices.*.aim, lower: -6, "
    "upper: 8}]";
constexpr const char* kTurned =
    "[{path: devices.*.at, lower: -6, upper: 6}, {path: devices.*.quaternion_wxyz}]";

constexpr const char* kSpeakers =
    "[{path: devices.s1.at.x, lower: -0.4, upper: 0.8, mirror: {path: devices.s4.at.x, "
    "about: 0.2}}, {path: devices.s2.at, lower: -1, upper: 2}]";

const std::vector<Override> kExposures = {{"devices.s1.exposure", "13 ms"},
                                          {"devices.s2.exposure", "13 ms"},
                                          {"devices.s3.exposure", "13 ms"},
                                          {"devices.s4.exposure", "13 ms"}};

/// Only what all expose equally long has slopes, also at the designs that a search
/// would come to.
TEST(SlopesOfExposures, AreNoneOfDifferentOnes) {
  const auto problem_of = [](std::vector<Override> changes, const char* variables) {
    changes.push_back({"variables", variables});
    return Problem(load("01-acoustic", changes), plugins(), {20, 1}).slope_problem();
  };
  constexpr const char* kNone =
      "fusion of devices that don't expose equally long has no derivative here";
  constexpr const char* kAt = "[{path: devices.s1.at.z, lower: 0, upper: 2}]";
  EXPECT_EQ(problem_of(kExposures, kAt), "");
  EXPECT_EQ(problem_of({kExposures.front()}, kAt), kNone);
  EXPECT_EQ(
      problem_of(kExposures, "[{path: devices.s1.exposure, lower: 0, upper: 20 ms}]"),
      kNone);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Slopes,
    testing::Values(
        Case{"01-acoustic", "[{path: devices.*.at, lower: -1, upper: 2}]"},
        Case{"01-acoustic",
             "[{path: devices.*.at, lower: -1, upper: 2}, {path: devices.s1.params.r, "
             "lower: 0.001, upper: 0.1}]",
             "{minimize: p_norm, of: sigma_position}"},
        Case{"02-eight-cameras", kPlaces},
        Case{"02-eight-cameras",
             "[{path: devices.*.at, lower: -6, upper: 7}, {path: "
             "devices.upper1.params.focal, lower: 3 mm, upper: 12 mm}]",
             "{minimize: soft_max}"},
        Case{"03-hybrid", "[{path: devices.*.at, lower: -6, upper: 7}]",
             "{terms: [{minimize: cvar, of: eiglen, level: 0.8}, {minimize: mean, of: "
             "sigma_x, weight: 2}]}"},
        Case{"04-motion-capture", kPlaces, "{minimize: mean, of: trace}"},
        Case{"05-optitrack-lab", kTurned, "{minimize: fraction, limit: 0.6 mm}"},
        Case{"06-furnished-lab", kTurned},
        Case{"07-torso", kPlaces, "{minimize: mean, guess: 5 mm}"},
        Case{"08-self-occlusion", kPlaces, "{minimize: mean}", {}, 5},
        // Orientation too, of three markers on levers.
        Case{"04-motion-capture",
             kPlaces,
             "{minimize: mean, of: sigma_orientation}",
             {{"motion",
               "{type: position_velocity, state: pose, q: [0.4, 0.4, 0.1, 1, 1, "
               "2]}"},
              {"target", "{markers: [[0.1, 0, 0], [0, 0.2, 0], [0, 0, 0.15]]}"}},
             40},
        // Rates change more than a device: differences of fields.
        Case{"03-hybrid", "[{path: devices.s*.rate, lower: 10, upper: 100}]"},
        // So do exposures, which places know of too.
        Case{"01-acoustic",
             "[{path: devices.s1.exposure, lower: 0, upper: 20 ms, tie: "
             "[devices.s2.exposure, devices.s3.exposure, devices.s4.exposure]}, "
             "{path: devices.*.at, lower: -1, upper: 2}]",
             "{minimize: mean}", kExposures},
        // Anchors on walls, in sight of both wings or not.
        Case{"15-uwb-anchors",
             "[{path: devices.*.coordinates}, {path: devices.east.params.sigma}]",
             "{minimize: p_norm, p: 4}"},
        // Each camera may fail, and what is left may be blind.
        Case{"02-eight-cameras", kPlaces, "{minimize: mean, robust: {failures: '*'}}"},
        Case{"06-furnished-lab",
             kTurned,
             "{minimize: p_norm, robust: {failures: 'c10433*', mounting: {at: 3 cm, "
             "angle: 1 deg}, draws: 3}}",
             {},
             60},
        Case{"08-self-occlusion",
             kPlaces,
             "{minimize: mean, robust: {failures: '*'}}",
             {},
             5},
        // Several terms, noises of differing devices, parameters of one.
        Case{"03-hybrid",
             "[{path: devices.*.at, lower: -6, upper: 7}, {path: devices.s2.params.r, "
             "lower: 0.001, upper: 0.1}]",
             "{terms: [{minimize: cvar, of: eiglen, level: 0.8}, {minimize: mean, of: "
             "sigma_x, weight: 2}], robust: {failures: [s1, s2, upper1], noise: 30 %, "
             "mounting: {at: 1 cm}, draws: 4, combine: worst}}"},
        // Rates by differences, and limits that hold where nothing fails.
        Case{
            "10-better-speakers",
            "[{path: devices.*.at, lower: -1, upper: 2}, {path: motion.q.2, lower: "
            "0.05, upper: 1}]",
            "{minimize: mean, robust: {failures: '*', mounting: {at: 2 cm}, draws: 2}}",
            {{"constraints", "[{metric: eigmax, below: 5 cm}]"}}},
        // How many devices see a sample: of one marker and of three, from places and
        // by what devices are, where each may fail, and against shadows.
        Case{"02-eight-cameras",
             "[{path: devices.*.at, lower: -6, upper: 7}, {path: "
             "devices.upper1.params.focal, lower: 3 mm, upper: 12 mm}]",
             "{maximize: mean, of: coverage}"},
        Case{"06-furnished-lab", kTurned,
             "{minimize: fraction, of: coverage, limit: 3}"},
        Case{"03-hybrid",
             "[{path: devices.*.at, lower: -6, upper: 7}]",
             "{terms: [{maximize: cvar, of: coverage, level: 0.8}, {minimize: mean}], "
             "robust: {failures: '*'}}",
             {{"constraints", "[{metric: coverage, above: 5}]"}}},
        Case{"04-motion-capture",
             kPlaces,
             "{maximize: percentile, of: coverage, level: 0.7}",
             {{"motion",
               "{type: position_velocity, state: pose, q: [0.4, 0.4, 0.1, 1, 1, "
               "2]}"},
              {"target", "{markers: [[0.1, 0, 0], [0, 0.2, 0], [0, 0, 0.15]]}"}},
             40},
        // Formulas: of metrics, of entries of P and of who sees; one of them isn't
        // monotone, so that what nobody sees costs.
        Case{"02-eight-cameras",
             kPlaces,
             "{terms: [{minimize: mean, of: flat}, {minimize: cvar, of: mixed}]}",
             {{"metrics",
               "{flat: {expression: 'sigma_z/sigma_x + 0.1*P[x, vx]/P[x, x] + x', "
               "unit: '1'}, mixed: "
               "{expression: (eigmax + sigma_vz*0.1)/coverage^2, unit: m}}"},
              {"constraints", "[{metric: flat, below: 3}]"}}},
        // One reading of everything, without motion.
        Case{"03-hybrid",
             "[{path: devices.*.at, lower: -6, upper: 7}]",
             "{terms: [{minimize: mean, of: sigma_position}, {minimize: cvar, of: "
             "eigmax}]}",
             {{"covariance", "single"}}},
        // Limits on places, numbers and metrics.
        Case{"10-better-speakers",
             kSpeakers,
             "{minimize: percentile, level: 0.7}",
             {{"constraints",
               "[{metric: eigmax, below: 5 cm}, {metric: mle, above: 10}, {spacing: "
               "0.3, "
               "devices: '*'}, {sum: {devices.*.at.z: 1}, at_most: 4}]"}}}),
    name_of_case);

}  // namespace
}  // namespace delos::test
