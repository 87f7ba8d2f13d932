// Constraints: kept, with the slack that geometry says; refused where they can't be.
#include <Eigen/Geometry>
#include <cmath>

#include "optimizers/scenes.h"
#include "problem/place_limits.h"

namespace delos::test {
namespace {

/// Three speakers around a target; all three may move within 2 m.
std::string speakers(const std::string& constraints) {
  return kOneTarget + R"(regions:
  table: {box: {min: [-1, -1, 0.5], max: [1, 1, 3]}}
  floor: {box: {min: [-9, -9, -9], max: [9, 9, 0]}}
devices:
  - {name: a, rate: 50, at: [1, 0, 1], type: acoustic_range}
  - {name: b, rate: 50, at: [-1, 1, 1], type: acoustic_range}
  - {name: c, rate: 50, at: [-1, -1, 1], type: acoustic_range}
variables:
  - {path: devices.*.at, lower: [-2, -2, 0.3], upper: 2}
constraints:
)" + constraints;
}

Eigen::Vector3d place(const Scene& scene, std::size_t i) {
  return scene.devices[i].placement.at;
}

double slack(const OptimizeResult& result, const std::string& name) {
  for (const ConstraintReport& c : result.constraints) {
    if (c.name != name) continue;
    EXPECT_EQ(c.satisfied, c.slack >= 0);
    return c.slack;
  }
  ADD_FAILURE() << "no constraint " << name;
  return NAN;
}

// Without a constraint, speakers go as near to the target as they may.
TEST(Constraints, ChangeTheAnswer) {
  const OptimizeResult found = search(parse(speakers(" []\n")));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(place(found.scene, i).norm(), 0.7);
}

TEST(Constraints, Spacing) {
  const OptimizeResult found =
      search(parse(speakers("  - {name: apart, spacing: 1.5, devices: \"*\"}\n")));
  double least = 1e300;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, (place(found.scene, i) - place(found.scene, j)).norm());
  EXPECT_GE(least, 1.5);
  EXPECT_LT(least, 1.51);  // it binds
  EXPECT_NEAR(slack(found, "apart"), least - 1.5, 1e-12);
  EXPECT_NE(found.stop, SearchStop::infeasible);
}

TEST(Constraints, InsideARegion) {
  const OptimizeResult found = search(parse(
      speakers("  - {name: on_table, inside: table, devices: [a, b], margin: 0.1}\n")));
  for (const std::size_t i : {0u, 1u}) EXPECT_GE(place(found.scene, i).z(), 0.6);
  EXPECT_LT(place(found.scene, 2).z(), 0.6);
  EXPECT_GE(slack(found, "on_table"), 0);
}

TEST(Constraints, OutsideARegion) {
  const OptimizeResult found = search(parse(
      speakers("  - {name: off, outside: floor, devices: \"*\", margin: 0.8}\n")));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_GE(place(found.scene, i).z(), 0.8);
  EXPECT_GE(slack(found, "off"), 0);
  EXPECT_LT(slack(found, "off"), 0.01);
}

TEST(Constraints, SumOfNumbers) {
  const OptimizeResult found = search(
      parse(speakers("  - {name: cable, sum: {devices.*.at.z: -1}, at_most: -2.4}\n")));
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += place(found.scene, i).z();
  EXPECT_GE(sum, 2.4);
  EXPECT_NEAR(slack(found, "cable"), sum - 2.4, 1e-12);
}

TEST(Constraints, KeepOffALine) {
  const OptimizeResult found = search(parse(speakers(
      "  - {name: beam, clear: [[0, 0, 0], [0, 0, 3]], distance: 0.5, devices: "
      "\"*\"}\n")));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_GE(place(found.scene, i).head<2>().norm(), 0.5);
  EXPECT_GE(slack(found, "beam"), 0);
}

// A line ends: 2 m behind its first end, and beyond its second one, is 2 m away.
TEST(Constraints, ALineToKeepOffEnds) {
  for (const double z : {-2.0, 5.0}) {
    Scene scene =
        parse(speakers("  - {name: beam, clear: [[0, 0, 0], [0, 0, 3]], distance: 0.5, "
                       "devices: [a]}\n"));
    scene.variables.resize(1);
    scene.devices[0].placement.at = {0, 0, z};
    const Design design(scene, plugins());
    const GeometryLimits limits(design);
    double slack = 0;
    limits.slacks(design.scene(), &slack);
    EXPECT_NEAR(slack, 2 - 0.5, 1e-15) << z;
  }
}

TEST(Constraints, Tilt) {
  const Scene scene = parse(kOneTarget + R"(devices:
  - {name: a, rate: 50, at: [1, 0, 1], aim: [0, 0, 0], type: pinhole_camera, params: &p {focal: 8 mm, pitch: 5 um, resolution: [1280, 1024]}}
  - {name: b, rate: 50, at: [-0.9, 0.2, 1], aim: [0, 0, 0], type: pinhole_camera, params: *p}
variables: [{path: "devices.*.at", lower: [-2, -2, 0.5], upper: 2}]
constraints: [{name: steep, tilt: 30 deg, devices: "*"}]
)");
  const OptimizeResult found = search(scene);
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector3d at = place(found.scene, i);
    EXPECT_LE(std::atan2(at.head<2>().norm(), at.z()), 30 * M_PI / 180 + 1e-12);
  }
  EXPECT_GE(slack(found, "steep"), 0);
  // The scene as it stands is at 45 degrees.
  ASSERT_EQ(found.messages.size(), 1u);
  EXPECT_NE(found.messages[0].find("doesn't keep steep"), std::string::npos);
}

// All the money is spent near one set of samples unless the other must be served too.
TEST(Constraints, MetricOfASampleSet) {
  const std::string text = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample:
  - {name: here, points: [[0, 0, 0]]}
  - {name: there, points: [[3, 0, 0]]}
devices:
  - {name: a, rate: 50, at: [1, 0, 1], type: acoustic_range, params: {r: 1.0e-5}}
  - {name: b, rate: 50, at: [1, 1, 1], type: acoustic_range, params: {r: 1.0e-5}}
  - {name: c, rate: 50, at: [1, -1, 1], type: acoustic_range, params: {r: 1.0e-5}}
variables: [{path: "devices.*.at", lower: [-2, -2, 0.3], upper: [5, 2, 2]}]
objective: {minimize: mean, over: here}
)";
  const auto at = [](const OptimizeResult& r, int i) { return r.best_field.value[i]; };
  const OptimizeResult free = search(parse(text));
  const double limit = 0.6 * at(free, 1);
  const OptimizeResult kept = search(
      parse(text + "constraints: [{name: there, metric: eigmax, in: there, below: " +
            std::to_string(limit) + "}]\n"));
  EXPECT_LE(at(kept, 1), limit + 1e-6);
  EXPECT_GT(at(kept, 0), at(free, 0));
  EXPECT_GE(slack(kept, "there"), 0);
}

TEST(Constraints, ContradictionsAreNamed) {
  const Scene scene =
      parse(speakers("  - {name: on_table, inside: table, devices: \"*\"}\n"
                     "  - {name: below, inside: floor, devices: a}\n"
                     "  - {name: apart, spacing: 0.1, devices: \"*\"}\n"));
  try {
    (void)search(scene);
    FAIL();
  } catch (const std::invalid_argument& refusal) {
    const std::string text = refusal.what();
    EXPECT_NE(text.find("no design keeps all of: "), std::string::npos) << text;
    EXPECT_TRUE(text.find("on_table") != std::string::npos ||
                text.find("below") != std::string::npos)
        << text;
    EXPECT_EQ(text.find("apart"), std::string::npos) << text;
  }
}

TEST(Constraints, AnUnreachableMetricIsSaid) {
  const OptimizeResult found =
      search(parse(speakers("  - {name: sharp, metric: eigmax, below: 1 um}\n")));
  EXPECT_EQ(found.stop, SearchStop::infeasible);
  EXPECT_LT(slack(found, "sharp"), 0);
}

// Out of bounds: put on them, with a message.
TEST(Bounds, AStartOutsideIsRepaired) {
  const Scene scene = parse(kOneTarget + R"(devices:
  - {name: a, rate: 50, at: [3, 0, 1], type: acoustic_range}
variables: [{path: devices.a.at.x, lower: -2, upper: 2}]
)");
  Problem problem(scene, plugins(), {});
  EXPECT_EQ(problem.design().start(), std::vector<double>{1});
  EXPECT_EQ(problem.design().repairs(),
            std::vector<std::string>{
                "devices.a.at.x is 3, outside -2 to 2; the search starts at 2"});
}

TEST(Search, NeedsVariables) {
  EXPECT_THROW((void)search(load("01-acoustic")), std::invalid_argument);
}

TEST(Search, RefusesSlopesThatAreNotThere) {
  const Scene scene = load("10-better-speakers", {{"fusion", "periodic"}});
  OptimizeOptions options;
  options.algorithm = "slsqp";
  EXPECT_THROW((void)search(scene, options), std::invalid_argument);
  options.algorithm = "auto";
  options.evaluations = 20;
  options.starts = 1;
  options.samples = 200;
  const OptimizeResult found = search(scene, options);
  EXPECT_EQ(found.algorithm, "cobyla");
  EXPECT_LE(found.best.objective, found.initial.objective);
}

// The objective as the scene's first lines say it, on all samples; and that a short
// search improves it with all constraints kept.
TEST(Search, ImprovesTheCameraRoom) {
  OptimizeOptions options;
  options.starts = 1;
  options.evaluations = 60;
  options.samples = 400;
  const OptimizeResult found = search(load("09-camera-room"), options);
  EXPECT_NEAR(found.initial.objective, 0.00165, 5e-6);
  EXPECT_LT(found.best.objective, 0.7 * found.initial.objective);
  ASSERT_EQ(found.constraints.size(), 2u);
  for (const ConstraintReport& c : found.constraints)
    EXPECT_TRUE(c.satisfied) << c.name;
}

// Seeds differ in how many of the samples that are blind at first they come to see.
TEST(Search, ImprovesTheUwbHall) {
  const OptimizeResult found = search(load("15-uwb-anchors"));
  EXPECT_NEAR(found.initial.objective, 0.640, 5e-4);
  EXPECT_LT(found.best.objective, 0.75 * found.initial.objective);
  EXPECT_TRUE(found.best.feasible());
  EXPECT_EQ(found.algorithm, "slsqp");
}

// Beacons come into view and go at once: methods without slopes move a HiBall's axes.
TEST(Search, ImprovesTheAxesOfAHiBall) {
  OptimizeOptions options;
  options.starts = 1;
  options.evaluations = 60;
  options.samples = 20;
  const OptimizeResult found = search(load("hiball/custom-lepd"), options);
  EXPECT_NEAR(found.initial.objective, 0.582e-3, 5e-7);
  EXPECT_LT(found.best.objective, 0.8 * found.initial.objective);
  EXPECT_EQ(found.algorithm, "bobyqa");
  EXPECT_EQ(found.gradient_evaluations, 0u);
}

// Same seed, same bytes, for any number of threads.
TEST(Search, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = load("10-better-speakers");
  OptimizeOptions options;
  options.evaluations = 60;
  options.starts = 3;
  options.threads = 1;
  const OptimizeResult one = search(scene, options);
  options.threads = 4;
  const OptimizeResult four = search(scene, options);
  EXPECT_EQ(one.best_x, four.best_x);
  EXPECT_EQ(one.best.objective, four.best.objective);
  EXPECT_EQ(one.gradient_evaluations, four.gradient_evaluations);
}

}  // namespace
}  // namespace delos::test
