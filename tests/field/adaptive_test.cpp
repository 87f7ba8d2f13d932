// Adaptive fields against direct evaluation, and what they promise.
#include "delos/field/adaptive.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>

#include "delos/geometry/primitives.h"
#include "support/rigs.h"

namespace delos {
namespace {

/// The papers' acoustic tracker, of devices that answer for many points at once.
System acoustic_in_lanes() {
  System system = testing::acoustic_system();
  for (PlacedDevice& d : system.devices) {
    d.device = std::make_shared<testing::TestFullRange>(0.005);
  }
  return system;
}

const Eigen::AlignedBox3d kBox(Eigen::Vector3d(0, 0, 0),
                               Eigen::Vector3d(0.4, 0.4, 0.8));

Metric metric(const char* name, const System& system) {
  return std::get<Metric>(parse_metric(name, system.motion.layout));
}

AdaptiveSampling sampling(double tolerance, int depth) {
  AdaptiveSampling s;
  s.min = kBox.min();
  s.max = kBox.max();
  s.tolerance = tolerance;
  s.depth = depth;
  return s;
}

AdaptiveField evaluate(const System& system, const AdaptiveSampling& s,
                       const char* name = "eigmax", AdaptiveOptions options = {}) {
  return evaluate_adaptive(system, s, {}, metric(name, system), options);
}

Samples points_in_box(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Samples samples;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d p = kBox.min();
    for (int k = 0; k < 3; ++k) p(k) += uniform(random) * kBox.sizes()(k);
    samples.points.push_back(p);
  }
  samples.parts.push_back({"", 0, samples.points.size(), ScatteredShape{}});
  return samples;
}

Field direct(const System& system, const Samples& samples,
             const char* name = "eigmax") {
  return evaluate_field(system, samples, {}, metric(name, system));
}

/// The acoustic tracker with a wall between two speakers and half of the volume.
System with_wall() {
  System system = acoustic_in_lanes();
  system.in_world = Occluders({make_box({0.15, 0.1, 0.85}, {0.16, 0.5, 0.9})});
  return system;
}

TEST(Adaptive, NodesHoldWhatDirectEvaluationGives) {
  const System system = with_wall();
  const AdaptiveField field = evaluate(system, sampling(0.05, 4));
  const Field expected = direct(system, field.field().samples);
  ASSERT_GT(expected.value.size(), 500u);
  for (std::size_t i = 0; i < expected.value.size(); ++i) {
    if (std::isinf(expected.value[i])) {
      ASSERT_EQ(field.field().value[i], expected.value[i]);
    } else {
      ASSERT_NEAR(field.field().value[i], expected.value[i], 1e-9 * expected.value[i]);
    }
  }
}

// A smooth field is read to the tolerance nearly everywhere, and the stated error is
// that of other random points.
TEST(Adaptive, ASmoothFieldMeetsTheToleranceAndKnowsItsError) {
  const System system = acoustic_in_lanes();
  const AdaptiveField field = evaluate(system, sampling(0.005, 8));
  EXPECT_EQ(field.report().stop, AdaptiveStop::tolerance);
  const Samples points = points_in_box(5000, 3);
  const Field read = field.read(points), truth = direct(system, points);
  std::vector<double> off;
  for (std::size_t i = 0; i < truth.value.size(); ++i) {
    off.push_back(std::abs(read.value[i] / truth.value[i] - 1));
  }
  std::sort(off.begin(), off.end());
  const double p95 = off[off.size() * 95 / 100];
  EXPECT_LT(p95, 0.005);
  ASSERT_TRUE(field.field().discretization_error);
  EXPECT_NEAR(*field.field().discretization_error, p95, 0.2 * p95);
}

// Edges of fields of view are exact: a device's reach cuts the volume in two.
TEST(Adaptive, EdgesOfFieldsOfViewAreExact) {
  System system = acoustic_in_lanes();
  system.devices[0].device = std::make_shared<testing::TestFullRange>(0.005, 0.8);
  const AdaptiveField field = evaluate(system, sampling(0.05, 3), "coverage");
  const Samples points = points_in_box(5000, 4);
  EXPECT_EQ(field.read(points).value, direct(system, points, "coverage").value);
}

// With rays in doubtful cells nothing is left of the shadows' blur; without, only the
// cells that an edge crosses may be wrong.
TEST(Adaptive, ShadowsAreRightButForTheCellsThatTheirEdgesCross) {
  const System system = with_wall();
  const Samples points = points_in_box(5000, 5);
  const Field truth = direct(system, points, "coverage");
  double before = 1;
  for (const int depth : {4, 5, 6}) {
    const AdaptiveField field = evaluate(system, sampling(0.05, depth), "coverage");
    EXPECT_EQ(field.read(points, ShadowEdges::exact).value, truth.value);
    const Field read = field.read(points);
    double wrong = 0;
    for (std::size_t i = 0; i < truth.value.size(); ++i) {
      wrong += read.value[i] != truth.value[i];
    }
    wrong /= static_cast<double>(truth.value.size());
    EXPECT_GT(wrong, 0) << "or the test shows nothing";
    EXPECT_LT(wrong, 0.7 * before) << "at depth " << depth;
    before = wrong;
  }
  EXPECT_LT(before, 0.01);
}

TEST(Adaptive, MostSightLinesNeedNoRay) {
  const AdaptiveField field = evaluate(with_wall(), sampling(0.02, 6));
  const auto rays = static_cast<double>(field.report().rays);
  const auto saved = static_cast<double>(field.report().rays_saved);
  EXPECT_GT(saved / (rays + saved), 0.5);
}

// Across faces between leaves of different levels the field has no step.
TEST(Adaptive, IsContinuousAcrossHangingNodes) {
  System system = acoustic_in_lanes();
  AdaptiveSampling s = sampling(1e-4, 5);
  s.within =
      Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.1, 0.1, 0.2));
  const AdaptiveField field = evaluate(system, s);
  const auto& octree = std::get<OctreeShape>(field.field().samples.parts[0].shape);
  Samples left, right;
  const double step = 1e-9;
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (std::size_t c = 0; c < octree.cells.size(); ++c) {
    const Eigen::Vector3d a = field.field().samples.points[octree.cells[c][0]];
    const Eigen::Vector3d b = field.field().samples.points[octree.cells[c][7]];
    if (b.x() >= 0.4) continue;
    const Eigen::Vector3d p(b.x(), a.y() + uniform(random) * (b.y() - a.y()),
                            a.z() + uniform(random) * (b.z() - a.z()));
    left.points.push_back(p - Eigen::Vector3d(step, 0, 0));
    right.points.push_back(p + Eigen::Vector3d(step, 0, 0));
  }
  const Field l = field.read(left), r = field.read(right);
  double most = 0;
  for (std::size_t i = 0; i < l.value.size(); ++i) {
    most = std::max(most, std::abs(l.value[i] / r.value[i] - 1));
  }
  EXPECT_LT(most, 1e-6);
  EXPECT_GT(*std::max_element(octree.levels.begin(), octree.levels.end()),
            *std::min_element(octree.levels.begin(), octree.levels.end()) + 1);
}

TEST(Adaptive, DoesNotDependOnTheNumberOfThreads) {
  const System system = with_wall();
  AdaptiveOptions one, eight;
  one.field.threads = 1;
  eight.field.threads = 8;
  const AdaptiveField a = evaluate(system, sampling(0.02, 5), "eigmax", one);
  const AdaptiveField b = evaluate(system, sampling(0.02, 5), "eigmax", eight);
  EXPECT_EQ(a.field().value, b.field().value);
  EXPECT_EQ(a.field().samples.points, b.field().samples.points);
  EXPECT_EQ(a.field().discretization_error, b.field().discretization_error);
  EXPECT_EQ(a.report().rays, b.report().rays);
}

TEST(Adaptive, CancelledItIsAValidCoarserField) {
  const System system = with_wall();
  std::atomic<bool> cancel = false;
  AdaptiveOptions options;
  options.field.cancel = &cancel;
  std::vector<std::size_t> sizes;
  options.on_level = [&](const Field& so_far) {
    sizes.push_back(so_far.value.size());
    if (sizes.size() == 3) cancel = true;
  };
  const AdaptiveField field = evaluate(system, sampling(0.01, 7), "eigmax", options);
  EXPECT_EQ(field.report().stop, AdaptiveStop::cancelled);
  EXPECT_TRUE(field.field().cancelled);
  ASSERT_EQ(sizes.size(), 3u);
  EXPECT_LT(sizes[0], sizes[1]);
  EXPECT_EQ(field.field().value.size(), sizes[2]);
  const Samples points = points_in_box(500, 8);
  const Field read = field.read(points), truth = direct(system, points);
  double off = 0;
  for (std::size_t i = 0; i < truth.value.size(); ++i) {
    if (read.value[i] == truth.value[i]) continue;
    off += std::min(1.0, std::abs(read.value[i] / truth.value[i] - 1));
  }
  EXPECT_LT(off / 500, 0.2);
}

TEST(Adaptive, StopsNearItsBudget) {
  AdaptiveSampling s = sampling(1e-4, 9);
  s.evaluations = 3000;
  AdaptiveOptions options;
  options.held_back = 0;
  const AdaptiveField field = evaluate(with_wall(), s, "eigmax", options);
  EXPECT_EQ(field.report().stop, AdaptiveStop::evaluations);
  EXPECT_LT(field.field().evaluations, 6000u);
  EXPECT_GT(field.field().evaluations, 1500u);
}

// Only around 3 cm: far from there leaves stay coarse.
TEST(Adaptive, FocusesOnAValue) {
  AdaptiveSampling s = sampling(1e-3, 6);
  const AdaptiveField all = evaluate(acoustic_in_lanes(), s);
  s.near_value = 0.03;
  const AdaptiveField focused = evaluate(acoustic_in_lanes(), s);
  EXPECT_LT(focused.report().nodes, all.report().nodes / 2);
}

// Weights are volumes: a quarter of the box under water counts a quarter.
TEST(Adaptive, WeightsAreVolumes) {
  const AdaptiveField field = evaluate(with_wall(), sampling(0.02, 5));
  double sum = 0;
  for (const double w : field.field().weight) sum += w;
  EXPECT_NEAR(sum, kBox.volume(), 1e-12);
}

TEST(Adaptive, LeavesOutWhatIsInsideSolids) {
  System system = acoustic_in_lanes();
  system.in_world = Occluders({make_box({0.1, 0.1, 0.1}, {0.3, 0.3, 0.5})});
  const AdaptiveField field = evaluate(system, sampling(0.05, 5));
  const FieldStatistics s = summarize(field.field());
  EXPECT_GT(s.inside, 0u);
  EXPECT_EQ(s.samples + s.inside, field.report().nodes);
  for (std::size_t i = 0; i < field.field().value.size(); ++i) {
    const Eigen::Vector3d& p = field.field().samples.points[i];
    const bool within = (p.array() >= Eigen::Array3d(0.1, 0.1, 0.1)).all() &&
                        (p.array() <= Eigen::Array3d(0.3, 0.3, 0.5)).all();
    EXPECT_EQ(field.field().inside[i] != 0, within) << p.transpose();
  }
}

// The general path: one update of several rates over a cycle.
TEST(Adaptive, WorksForEveryFusion) {
  System system = acoustic_in_lanes();
  system.fusion = Fusion::sequential;
  const AdaptiveField field = evaluate(system, sampling(0.2, 2));
  const Field expected = direct(system, field.field().samples);
  for (std::size_t i = 0; i < expected.value.size(); ++i) {
    ASSERT_NEAR(field.field().value[i], expected.value[i], 1e-9 * expected.value[i]);
  }
  ASSERT_TRUE(field.field().discretization_error);
  EXPECT_LT(*field.field().discretization_error, 0.2);
}

}  // namespace
}  // namespace delos
