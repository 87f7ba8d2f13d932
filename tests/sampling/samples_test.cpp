#include "delos/sampling/samples.h"

#include <gtest/gtest.h>

#include <limits>

namespace delos {
namespace {

SampleSet volume(const Eigen::Vector3d& min, const Eigen::Vector3d& max,
                 const Eigen::Vector3d& step) {
  return {"v", VolumeSampling{min, max, step}};
}

SampleSet line(double min, double max, double step) {
  return volume({min, 0, 0}, {max, 0, 0}, {step, 1, 1});
}

TEST(SampleCount, IncludesBothEndsWhereTheStepDividesTheBox) {
  // 0.8/0.04 is 20.000000000000004 and 0.3/0.1 is 2.9999999999999996 in doubles.
  EXPECT_EQ(sample_count(line(0, 0.8, 0.04)), 21);
  EXPECT_EQ(sample_count(line(0, 0.3, 0.1)), 4);
  EXPECT_EQ(sample_count(line(-0.7, 0.7, 0.1)), 15);
  EXPECT_EQ(sample_count(line(0, 1, 1.0 / 3)), 4);
}

TEST(SampleCount, StopsBelowTheEndWhereItDoesNot) {
  EXPECT_EQ(sample_count(line(0, 1, 0.3)), 4);
  EXPECT_EQ(sample_count(line(0, 1, 0.99999)), 2);
  EXPECT_EQ(sample_count(line(0, 1, 1.00001)), 1);
  EXPECT_EQ(sample_count(line(0, 0, 0.1)), 1);
}

TEST(SampleCount, MultipliesAxes) {
  EXPECT_EQ(sample_count(volume({0, 0, 0}, {0.4, 0.4, 0.8}, {0.04, 0.04, 0.04})),
            11 * 11 * 21);
  EXPECT_EQ(sample_count({"", PlaneSampling{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 5}}}),
            15);
  EXPECT_EQ(sample_count({"", PointSampling{"", {{1, 2, 3}, {4, 5, 6}}}}), 2);
}

TEST(SampleCount, SaturatesWhereItWouldOverflow) {
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(sample_count(line(0, 1, 1e-300)), kMost);
  EXPECT_EQ(sample_count(volume({0, 0, 0}, {1, 1, 1}, {1e-9, 1e-9, 1e-9})), kMost);
}

TEST(MakeSamples, PutsGridPointsAtMinPlusMultiplesOfStep) {
  const Samples s = make_samples({volume({0, 1, 2}, {0.3, 1.5, 3}, {0.1, 0.5, 0.7})});
  ASSERT_EQ(s.points.size(), 4u * 2 * 2);
  EXPECT_EQ(s.points[0], Eigen::Vector3d(0, 1, 2));
  EXPECT_EQ(s.points[1], Eigen::Vector3d(0.1, 1, 2));  // x varies fastest
  EXPECT_EQ(s.points[3], Eigen::Vector3d(3 * 0.1, 1, 2));
  EXPECT_EQ(s.points[4], Eigen::Vector3d(0, 1.5, 2));  // then y
  EXPECT_EQ(s.points[8], Eigen::Vector3d(0, 1, 2.7));  // then z
  EXPECT_EQ(s.points[15], Eigen::Vector3d(3 * 0.1, 1.5, 2.7));

  ASSERT_EQ(s.parts.size(), 1u);
  EXPECT_EQ(s.parts[0].name, "v");
  const auto& grid = std::get<GridShape>(s.parts[0].shape);
  EXPECT_EQ(grid.origin, Eigen::Vector3d(0, 1, 2));
  EXPECT_EQ(grid.step, Eigen::Vector3d(0.1, 0.5, 0.7));
  EXPECT_EQ(grid.counts, (Eigen::Matrix<std::int64_t, 3, 1>(4, 2, 2)));
}

TEST(MakeSamples, CoversAParallelogramWithItsEdges) {
  const PlaneSampling plane{{1, 1, 1}, {2, 0, 0}, {0, 0, 6}, {3, 4}};
  const Samples s = make_samples({{"p", plane}});
  ASSERT_EQ(s.points.size(), 12u);
  EXPECT_EQ(s.points[0], Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(s.points[1], Eigen::Vector3d(2, 1, 1));  // u varies fastest
  EXPECT_EQ(s.points[2], Eigen::Vector3d(3, 1, 1));
  EXPECT_EQ(s.points[3], Eigen::Vector3d(1, 1, 3));
  EXPECT_EQ(s.points[11], Eigen::Vector3d(3, 1, 7));
  const auto& shape = std::get<PlaneShape>(s.parts[0].shape);
  EXPECT_EQ(shape.counts, Eigen::Vector2i(3, 4));
  EXPECT_EQ(shape.v, Eigen::Vector3d(0, 0, 6));
}

TEST(MakeSamples, LeavesASingleSampleOfAnEdgeAtTheOrigin) {
  const Samples s =
      make_samples({{"", PlaneSampling{{1, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 2}}}});
  ASSERT_EQ(s.points.size(), 2u);
  EXPECT_EQ(s.points[0], Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(s.points[1], Eigen::Vector3d(1, 2, 0));
}

TEST(MakeSamples, PutsPartsOneAfterTheOther) {
  const Samples s = make_samples({line(0, 1, 0.5),
                                  {"named", PointSampling{"", {{7, 8, 9}, {1, 2, 3}}}},
                                  line(5, 5, 1)});
  ASSERT_EQ(s.parts.size(), 3u);
  ASSERT_EQ(s.points.size(), 6u);
  EXPECT_EQ(s.parts[1].name, "named");
  EXPECT_EQ(s.parts[1].first, 3u);
  EXPECT_EQ(s.parts[1].count, 2u);
  EXPECT_TRUE(std::holds_alternative<ScatteredShape>(s.parts[1].shape));
  EXPECT_EQ(s.points[4], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(s.parts[2].first, 5u);
  EXPECT_EQ(s.parts[2].count, 1u);
}

TEST(MakeSamples, CountsTheCornersOfAMeshFromItsFirstVertex) {
  const auto mesh = std::make_shared<const TriangleMesh>(
      TriangleMesh{{{0, 0, 0}, {1000, 0, 0}, {0, 2000, 0}}, {{0, 1, 2}}});
  const std::vector<SampleSet> sets = {
      {"", PointSampling{"", {{7, 7, 7}}}},
      {"hull", MeshSampling{{"hull.off", 0.001, mesh}}},
  };
  EXPECT_EQ(sample_count(sets[1]), 3);
  const Samples s = make_samples(sets);
  EXPECT_EQ(s.points,
            (std::vector<Eigen::Vector3d>{{7, 7, 7}, {0, 0, 0}, {1, 0, 0}, {0, 2, 0}}));
  EXPECT_EQ(s.parts[1].first, 1u);
  EXPECT_EQ(s.parts[1].count, 3u);
  EXPECT_EQ(std::get<SurfaceShape>(s.parts[1].shape).triangles, mesh->triangles);
}

TEST(MakeSamples, RefusesAdaptiveSets) {
  AdaptiveSampling box;
  box.min = {0, 0, 0};
  box.max = {1, 1, 1};
  EXPECT_EQ(sample_count({"", box}), 0);
  EXPECT_THROW(static_cast<void>(make_samples({{"", box}})), std::invalid_argument);
}

}  // namespace
}  // namespace delos
