// What is inside a closed mesh, where the answer is known in closed form.
#include <gtest/gtest.h>

#include <random>

#include "delos/geometry/occluders.h"
#include "delos/geometry/primitives.h"

namespace delos::test {
namespace {

using Eigen::Vector3d;

TriangleMesh inside_out(TriangleMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// Two meshes as one part.
TriangleMesh both(TriangleMesh a, const TriangleMesh& b) {
  const auto n = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [p, q, r] : b.triangles)
    a.triangles.push_back({p + n, q + n, r + n});
  return a;
}

std::vector<Vector3d> points(int count, double reach) {
  std::mt19937_64 engine(5);
  std::uniform_real_distribution<double> draw(-reach, reach);
  std::vector<Vector3d> result;
  for (int i = 0; i < count; ++i) {
    result.emplace_back(draw(engine), draw(engine), draw(engine));
  }
  return result;
}

/// A hollow box hides as a full one, has no inside, and leaves a solid beside it alone.
TEST(Inside, OfAHollowBoxIsNothing) {
  const TriangleMesh room = make_box({-2, -2, -2}, {2, 2, 2}),
                     cupboard = make_box({1, 1, 1}, {1.5, 1.5, 1.5});
  const Occluders solid({room, cupboard}), hollow({room, cupboard}, {true, false});
  const Vector3d middle(0.1, 0.2, 0.3), shelf(1.2, 1.2, 1.2), outside(3, 0.1, 0.2);
  EXPECT_TRUE(solid.contains(middle));
  EXPECT_FALSE(hollow.contains(middle));
  EXPECT_TRUE(hollow.contains(shelf));
  EXPECT_FALSE(hollow.contains(outside));
  EXPECT_TRUE(hollow.blocks(middle, outside, 1e-3));
  EXPECT_FALSE(hollow.blocks(middle, {0.5, 0.5, 0.5}, 1e-3));
  // Seen from inside, a box of points within is clear, one without hidden.
  EXPECT_FALSE(hollow.hides(middle, {Vector3d(-1, -1, -1), Vector3d(0, 0, 0)}, 1e-3));
  EXPECT_TRUE(hollow.hides(middle, {Vector3d(3, 0, 0), Vector3d(4, 1, 1)}, 1e-3));
}

TEST(Inside, OfABoxIsItsInequalities) {
  const Vector3d half(1, 0.5, 0.25);
  for (const TriangleMesh& box :
       {make_box(-half, half), inside_out(make_box(-half, half))}) {
    const Occluders occluders({box});
    for (const Vector3d& p : points(5000, 1.2)) {
      ASSERT_EQ(occluders.contains(p), (p.cwiseAbs().array() <= half.array()).all())
          << p.transpose();
    }
  }
}

// On a grid that the faces, edges and corners of the box are part of: the surface
// counts.
TEST(Inside, IncludesTheSurface) {
  const Occluders occluders({make_box({-1, -1, -1}, {1, 1, 1})});
  for (double x = -1.5; x <= 1.5; x += 0.25) {
    for (double y = -1.5; y <= 1.5; y += 0.25) {
      for (double z = -1.5; z <= 1.5; z += 0.25) {
        const Vector3d p(x, y, z);
        ASSERT_EQ(occluders.contains(p), p.lpNorm<Eigen::Infinity>() <= 1)
            << p.transpose();
      }
    }
  }
}

// Between the ball through the corners and the one within the triangles nothing is
// known.
TEST(Inside, OfASphereIsItsRadius) {
  const Occluders occluders({make_sphere(1, 4)});
  for (const Vector3d& p : points(5000, 1.2)) {
    if (p.norm() < 0.995) {
      ASSERT_TRUE(occluders.contains(p));
    } else if (p.norm() > 1) {
      ASSERT_FALSE(occluders.contains(p));
    }
  }
}

TEST(Inside, DoesNotExistInAnOpenMesh) {
  TriangleMesh open = make_box({-1, -1, -1}, {1, 1, 1});
  open.triangles.pop_back();
  const Occluders occluders({open});
  EXPECT_FALSE(occluders.contains({0, 0, 0}));
  // The closed box beside it in the same tree keeps its own.
  const Occluders two({open, make_box({0, 0, 0}, {3, 3, 3})});
  EXPECT_FALSE(two.contains({-0.5, 0, 0}));
  EXPECT_TRUE(two.contains({0.5, 0.5, 0.5}));
}

TEST(Inside, LeavesOutCavities) {
  const TriangleMesh outer = make_box({-2, -2, -2}, {2, 2, 2}),
                     inner = make_sphere(1, 2);
  const Occluders hollow({both(outer, inside_out(inner))});
  EXPECT_FALSE(hollow.contains({0, 0, 0}));
  EXPECT_TRUE(hollow.contains({1.5, 0, 0}));
  EXPECT_FALSE(hollow.contains({2.5, 0, 0}));
}

TEST(Inside, KeepsWhatBodiesOfOnePartShare) {
  const Occluders overlap(
      {both(make_box({0, 0, 0}, {2, 2, 2}), make_box({1, 1, 1}, {3, 3, 3}))});
  EXPECT_TRUE(overlap.contains({0.5, 0.5, 0.5}));
  EXPECT_TRUE(overlap.contains({1.5, 1.5, 1.5}));
  EXPECT_TRUE(overlap.contains({2.5, 2.5, 2.5}));
  EXPECT_FALSE(overlap.contains({2.5, 0.5, 0.5}));
}

// Some modellers turn faces at random; the parity of crossings doesn't mind.
TEST(Inside, SurvivesFacesTurnedAtRandom) {
  TriangleMesh box = make_box({-1, -1, -1}, {1, 1, 1});
  for (std::size_t t = 0; t < box.triangles.size(); t += 3) {
    std::swap(box.triangles[t][0], box.triangles[t][1]);
  }
  const Occluders occluders({box});
  for (const Vector3d& p : points(500, 1.5)) {
    ASSERT_EQ(occluders.contains(p), p.lpNorm<Eigen::Infinity>() <= 1);
  }
}

}  // namespace
}  // namespace delos::test
