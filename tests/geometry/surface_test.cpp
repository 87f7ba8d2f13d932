// Mounting points and regions, where geometry gives the answer.
#include "delos/geometry/surface.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "delos/geometry/primitives.h"
#include "delos/geometry/region.h"

namespace delos::test {
namespace {

using Eigen::Vector3d;

TEST(Rail, IsMeasuredAlongItself) {
  // 3 m along x, a doubled point, then 1 m up: a corner at three quarters.
  const std::vector<Vector3d> rail{{0, 0, 2}, {3, 0, 2}, {3, 0, 2}, {3, 0, 3}};
  const auto expect = [&](double s, const Vector3d& p, const Vector3d& tangent) {
    EXPECT_TRUE(rail_point(rail, s).p.isApprox(p, 1e-15)) << s;
    EXPECT_EQ(rail_point(rail, s).tangent, tangent) << s;
  };
  expect(0, {0, 0, 2}, {1, 0, 0});
  expect(0.5, {2, 0, 2}, {1, 0, 0});
  expect(0.75, {3, 0, 2}, {0, 0, 1});
  expect(0.875, {3, 0, 2.5}, {0, 0, 1});
  expect(1, {3, 0, 3}, {0, 0, 1});
  expect(-1, {0, 0, 2}, {1, 0, 0});
  expect(2, {3, 0, 3}, {0, 0, 1});
  EXPECT_THROW((void)rail_point({{1, 1, 1}, {1, 1, 1}}, 0.5), std::invalid_argument);
  EXPECT_THROW((void)rail_point({}, 0.5), std::invalid_argument);
}

TEST(Patch, IsSpannedByItsSides) {
  const Patch wall{{1, 0, 0}, {0, 4, 0}, {0, 0, 2}};
  EXPECT_EQ(patch_point(wall, 0.5, 0.25).p, Vector3d(1, 2, 0.5));
  EXPECT_EQ(patch_point(wall, 0.5, 0.25).normal, Vector3d(1, 0, 0));
  EXPECT_EQ(patch_point(wall, 2, -1).p, Vector3d(1, 4, 0));
}

// The closest point of a box to a point outside is the point, limited to the box.
TEST(MountingSurface, OfABoxIsClosestWhereClampingLeads) {
  const Vector3d half(1, 2, 3);
  const MountingSurface surface(make_box(-half, half));
  std::mt19937_64 engine(6);
  std::uniform_real_distribution<double> draw(-5, 5);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p(draw(engine), draw(engine), draw(engine));
    const Vector3d clamped = p.cwiseMax(-half).cwiseMin(half);
    if (clamped == p) continue;
    const SurfacePoint at = surface.closest(p);
    ASSERT_LT((at.p - clamped).norm(), 1e-12);
    // The normal is that of one of the faces that p is beyond.
    int axis;
    ASSERT_EQ(at.normal.cwiseAbs().maxCoeff(&axis), 1);
    ASSERT_GT(p[axis] * at.normal[axis], half[axis]);
  }
  EXPECT_EQ(surface.closest({0.9, 0, 0}).p, Vector3d(1, 0, 0));  // from within
}

TEST(MountingSurface, NeedsAreaToMountOn) {
  EXPECT_THROW(MountingSurface(TriangleMesh{}), std::invalid_argument);
  EXPECT_THROW(MountingSurface({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}),
               std::invalid_argument);
}

// Outside of a box its distance is that to the point limited to it; inside, that to the
// nearest face.
TEST(Region, OfABoxHasItsDistance) {
  const Vector3d half(1, 2, 3);
  const Region region(make_box(-half, half));
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> draw(-5, 5);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d p(draw(engine), draw(engine), draw(engine));
    const Vector3d over = p.cwiseAbs() - half;
    const double expected =
        over.maxCoeff() <= 0 ? over.maxCoeff() : over.cwiseMax(0).norm();
    ASSERT_NEAR(region.signed_distance(p), expected, 1e-12);
    ASSERT_EQ(region.contains(p), expected <= 0);
  }
}

TEST(Region, OfAPrismLeavesOutTheNotch) {
  const Region region(extrude({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 2));
  EXPECT_TRUE(region.contains({0.5, 2.5, 1}));
  EXPECT_FALSE(region.contains({2, 2, 1}));
  EXPECT_DOUBLE_EQ(region.signed_distance({2, 2, 1}), 1);
  EXPECT_DOUBLE_EQ(region.signed_distance({0.5, 2, 1}), -0.5);
}

TEST(Region, NeedsAClosedMesh) {
  TriangleMesh open = make_box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_THROW(Region{open}, std::invalid_argument);
}

}  // namespace
}  // namespace delos::test
