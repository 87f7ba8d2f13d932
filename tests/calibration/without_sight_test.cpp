// Readings that come through what stands in their way: closed forms, fields in lanes
// and point by point, octrees, and what filters make of them.
#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "delos/field/adaptive.h"
#include "delos/field/evaluate.h"
#include "delos/field/point.h"
#include "delos/layers/layers.h"
#include "delos/simulation/simulate.h"
#include "scenes.h"
#include "support/rigs.h"

namespace delos {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::findings_of;
using test::scene_of;
using test::system_of;
using test::three_ranges;

/// A wall that hides the first of the three ranges from the middle.
const std::string kWall = "occluders: [{box: {min: [2, -1, -1], max: [2.1, 1, 1]}}]\n";

System behind_a_wall(const std::string& keys, const std::string& more = "") {
  return system_of(three_ranges(keys, kWall + more));
}

const TargetPose kMiddle{Matrix3d::Identity(), Vector3d::Zero()};

/// Diagonal of what one update knows of the middle.
Vector3d information(const System& system) {
  const WhitenedRows rows = whitened_rows(system, kMiddle);
  return (rows.rows.transpose() * rows.rows).diagonal();
}

// σ = 3 cm; one in five comes through a wall, with 4 cm besides: σ² + s² = (5 cm)².
TEST(WithoutSight, ItsInformationIsThatOfWhatArrives) {
  const Vector3d seen = information(
      behind_a_wall("without_sight: {probability: 0.2, sigma: 4 cm, bias: 30 cm}"));
  EXPECT_NEAR(seen.x(), 0.2 / 25e-4, 1e-9);
  EXPECT_NEAR(seen.y(), 1 / 9e-4, 1e-9);
  EXPECT_EQ(information(behind_a_wall("phase: 0")).x(), 0) << "nothing else does";
  EXPECT_EQ(information(behind_a_wall("without_sight: {probability: 0}")).x(), 0);
}

// Late by b, it puts the middle off by b along its axis, and no other way.
TEST(WithoutSight, IsOffByWhatItIsLate) {
  System system = behind_a_wall(
      "without_sight: {probability: 0.2, sigma: 4 cm, bias: 30 cm}", "error: bias\n");
  const auto prior = [&](const System& of) {
    return evaluate_point(of, kMiddle, testing::metric_of(of, "coverage")).state.prior;
  };
  const StateMatrix B = prior(system);
  EXPECT_NEAR(B(0, 0), 0.09, 1e-12);
  EXPECT_NEAR(B(1, 1), 0, 1e-12);
  // All three late together put it off along the diagonal.
  system.in_world = Occluders();
  EXPECT_NEAR(prior(system).norm(), 0, 1e-15) << "nothing is in the way";
  const System all = system_of(three_ranges(
      "without_sight: {probability: 0.5, bias: 30 cm}",
      "error: bias\noccluders: [{box: {min: [2, -1, -1], max: [2.1, 1, 1]}}, "
      "{box: {min: [-1, 2, -1], max: [1, 2.1, 1]}}, {box: {min: [-1, -1, 2], max: [1, "
      "1, 2.1]}}]\n"));
  const StateMatrix of_all = prior(all);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(of_all(i, j), 0.09, 1e-12);
}

/// A field of a few anchors and boxes, node by node and through an octree.
const std::string kRoom =
    "delos: 1\nmotion: {type: position_velocity, q: [0.4, 0.4, 0.4]}\n"
    "occluders: [{box: {min: [2, 1, 0], max: [2.2, 3, 2]}}, {box: {min: [3, 3.5, 0], "
    "max: [4, 3.7, 2.4]}}]\ntarget: {markers: [[0, 0, 0], [0.1, 0, 0.3]]}\ndevices:\n"
    "  - {name: a, type: range, rate: 20 Hz, at: [0, 0, 2.5], without_sight: &w "
    "{probability: 0.6, sigma: 20 cm, bias: 10 cm}}\n"
    "  - {name: b, type: range, rate: 20 Hz, at: [6, 0, 0.5], without_sight: *w}\n"
    "  - {name: c, type: range, rate: 20 Hz, at: [6, 6, 2.5], without_sight: *w}\n"
    "  - {name: d, type: range, rate: 20 Hz, at: [0, 6, 0.5], without_sight: *w}\n";

TEST(WithoutSight, LanesAreOfOnePointEach) {
  const System system = system_of(kRoom + "sample: {points: [[0, 0, 0]]}\n");
  std::vector<TargetPose> poses;
  for (int i = 0; i < 150; ++i)
    poses.push_back({Matrix3d::Identity(), {0.04 * i, 6 - 0.038 * i, 0.3 + 0.01 * i}});
  const InformationLayers layers(system, poses, {.threads = 1});
  LayerBlock scratch;
  int weakened = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const WhitenedRows rows = whitened_rows(system, poses[i]);
    const Matrix3d S = rows.rows.transpose() * rows.rows;
    const LayerBlock& block = layers.block(i / kLanes, scratch);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c <= r; ++c)
        EXPECT_NEAR(block.total[static_cast<std::size_t>(packed_index(r, c)) * kLanes +
                                i % kLanes],
                    S(r, c), 1e-9 * S.norm());
    for (const double share : rows.share) weakened += share < 1;
    EXPECT_EQ(rows.rows.rows(), 8);
  }
  EXPECT_GT(weakened, 100);
}

TEST(WithoutSight, OctreesKnowTheEdgesOfShadows) {
  const System system =
      system_of(kRoom + "error: scatter\nsample: {points: [[0, 0, 0]]}\n");
  const Metric metric = testing::metric_of(system, "trace");
  AdaptiveSampling sampling;
  sampling.min = {1, 1, 0.2};
  sampling.max = {5, 5, 2.2};
  sampling.tolerance = 0.05;
  sampling.depth = 4;
  const AdaptiveField field = evaluate_adaptive(system, sampling, {}, metric);
  Samples samples;
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 500; ++i) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    samples.points.emplace_back(1 + 4 * x, 1 + 4 * y, 0.2 + 2 * z);
  }
  samples.parts = {SamplePart{.count = 500, .shape = ScatteredShape{}}};
  const Field read = field.read(samples, ShadowEdges::exact);
  const Field direct = evaluate_field(system, samples, {}, metric);
  for (std::size_t i = 0; i < samples.points.size(); ++i)
    EXPECT_NEAR(read.value[i], direct.value[i], 0.05 * direct.value[i]);
}

// What arrives now and then is worth less than its expected information says, since
// covariance is convex in information; of readings that arrive often, and matter little
// each, next to nothing less. By a scalar recursion over random arrivals, of a script
// of its own, mean variances are 2.446 and 1.182 times those of the expected
// information at 20 and 100 Hz. Filters that are told which came without sight reach
// that:
TEST(WithoutSight, ExpectedInformationIsABoundThatFiltersComeNear) {
  for (const auto& [rate, ratio] : {std::pair(20.0, 2.446), std::pair(100.0, 1.182)}) {
    Scene scene =
        scene_of(three_ranges("without_sight: {probability: 0.3, sigma: 4 cm}", kWall));
    for (DeviceEntry& device : scene.devices) device.rate = rate;
    const System system = build_system(scene, test::plugins());
    const Simulation s = simulate(system, kMiddle, {.runs = 3000, .seed = 5});
    EXPECT_LE(s.lost, 15u) << "gaps in which they run away";
    const SimulatedCovariance& c = s.covariances[0];
    EXPECT_NEAR(c.measured(1, 1), c.predicted(1, 1), 4.5 * c.error(1, 1))
        << "what is seen is as ever";
    EXPECT_NEAR(c.measured(0, 0), ratio * c.predicted(0, 0), 4.5 * c.error(0, 0))
        << rate;
    EXPECT_GT(c.measured(0, 0), c.predicted(0, 0) + 3 * c.error(0, 0)) << "a bound";
  }
}

// Readings that always come, late and noisy: filters are off by just what is said.
TEST(WithoutSight, BiasIsWhatFiltersAreOffBy) {
  const System system =
      behind_a_wall("without_sight: {probability: 1, sigma: 4 cm, bias: 3 cm}");
  const Simulation s =
      simulate(system, kMiddle, {.runs = 10'000, .seed = 5, .seconds = 3});
  const SimulatedCovariance& c = s.covariances[0];
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j <= i; ++j)
      EXPECT_NEAR(c.measured(i, j), c.predicted(i, j), 4.5 * c.error(i, j));
  EXPECT_NEAR(s.instants.back().mean(0), 0.03, 0.002)
      << "truth is nearer to the anchor";
}

bool says(const std::string& text, const std::string& what) {
  for (const std::string& line : findings_of(text))
    if (line.find(what) != std::string::npos) return true;
  return false;
}

TEST(WithoutSight, IsReadWrittenAndRefused) {
  const std::string keys =
      "without_sight: {probability: 60 %, sigma: 20 cm, bias: -0.1}";
  const Scene scene = scene_of(three_ranges(keys, kWall));
  EXPECT_EQ(scene.devices[0].without_sight, (WithoutSight{0.6, 0.2, -0.1}));
  EXPECT_EQ(scene_of(write_scene(scene)), scene);
  EXPECT_TRUE(
      says(three_ranges("without_sight: {probability: 1.2}"), "must be from 0 to 1"));
  EXPECT_TRUE(says(three_ranges("without_sight: {sigma: 1}"), "probability: missing"));
  EXPECT_TRUE(says(three_ranges("without_sight: {probability: 1, sigma: -1}"),
                   "must not be below 0"));
  EXPECT_TRUE(says(three_ranges(keys, "fusion: periodic\n"), "error: scatter"));
  EXPECT_EQ(findings_of(three_ranges("without_sight: {probability: 1, sigma: 1}",
                                     "fusion: periodic\n")),
            std::vector<std::string>{});
}

TEST(CommonErrors, AreReadWrittenAndRefused) {
  const std::string errors =
      "target: {speed: 2 m/s}\ngroups: {rig: {at: [0, 0, 1]}}\n"
      "common_errors: {frame: {group: rig, place: 1 mm}, sound: {scale: 0.2 %, delay: "
      "1 "
      "ms, devices: 'r*'}}\n";
  const std::string text = three_ranges("group: rig", errors);
  const Scene scene = scene_of(text);
  ASSERT_EQ(scene.common_errors.size(), 2u);
  EXPECT_EQ(scene.common_errors[0].group, "rig");
  EXPECT_NEAR(scene.common_errors[1].of.scale, 0.002, 1e-15);
  EXPECT_EQ(scene.common_errors[1].devices.size(), 3u);
  EXPECT_EQ(scene.speed, 2);
  EXPECT_EQ(scene_of(write_scene(scene)), scene);
  const auto with = [](const std::string& error) {
    return three_ranges("phase: 0", "common_errors: {e: {" + error + "}}\n");
  };
  EXPECT_TRUE(says(with("delay: 1 ms"), "say how fast it is"));
  EXPECT_TRUE(says(with("params: {sigma: 1}"), "unknown key"));
  EXPECT_TRUE(says(with("place: -1"), "must not be below 0"));
  EXPECT_TRUE(says(with("place: 1, group: rag"), "there is no group 'rag'"));
  EXPECT_TRUE(says(with("devices: [r1]"), "says of no error"));
  EXPECT_TRUE(says(with("place: 1 mm, devices: [q]"), "q"));
}

}  // namespace
}  // namespace delos
