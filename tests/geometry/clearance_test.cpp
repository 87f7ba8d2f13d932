// How far segments pass from triangles: against points of both, tried one by one.
#include "geometry/occlusion/clearance.h"

#include <gtest/gtest.h>

#include <random>

#include "delos/geometry/primitives.h"

namespace delos {
namespace {

class Draw {
 public:
  double number(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  Eigen::Vector3d point(double size) {
    return {number(-size, size), number(-size, size), number(-size, size)};
  }

 private:
  std::mt19937_64 random_{11};
};

TriangleMesh one_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c) {
  return {{a, b, c}, {{0, 1, 2}}};
}

/// The least distance of points of a segment from points of a triangle, refined where
/// it is least: within 1e-6 of the truth, from above.
double brute_force(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                   const TriangleMesh& t) {
  double best = 1e300, s0 = 0.5, u0 = 0.5, v0 = 0.5;
  for (double size = 0.5; size > 1e-8; size *= 0.7) {
    constexpr int kSteps = 6;
    double s1 = s0, u1 = u0, v1 = v0;
    for (int i = -kSteps; i <= kSteps; ++i)
      for (int j = -kSteps; j <= kSteps; ++j)
        for (int k = -kSteps; k <= kSteps; ++k) {
          const double s = std::clamp(s0 + size * i / kSteps, 0.0, 1.0);
          const double u = std::clamp(u0 + size * j / kSteps, 0.0, 1.0);
          const double v = std::clamp(v0 + size * k / kSteps, 0.0, 1.0 - u);
          const Eigen::Vector3d p = a + s * (b - a);
          const Eigen::Vector3d q = t.vertices[0] +
                                    u * (t.vertices[1] - t.vertices[0]) +
                                    v * (t.vertices[2] - t.vertices[0]);
          if ((p - q).norm() < best) {
            best = (p - q).norm();
            s1 = s;
            u1 = u;
            v1 = v;
          }
        }
    s0 = s1;
    u0 = u1;
    v0 = v1;
  }
  return best;
}

TEST(Clearance, OfOneTriangleIsTheLeastDistance) {
  Draw draw;
  for (int i = 0; i < 60; ++i) {
    const TriangleMesh t = one_triangle(draw.point(1), draw.point(1), draw.point(1));
    const Eigen::Vector3d a = draw.point(2), b = draw.point(2);
    const double expected = brute_force(a, b, t);
    EXPECT_NEAR(Clearance({t}).passage(a, b, 1e9).distance, expected, 1e-5) << i;
  }
}

// Many triangles in a tree: the least over all of them, one by one.
TEST(Clearance, OfManyIsTheLeastOfAll) {
  Draw draw;
  std::vector<TriangleMesh> all;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d p = draw.point(3);
    all.push_back(one_triangle(p, p + draw.point(0.3), p + draw.point(0.3)));
  }
  const Clearance tree(all);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d a = draw.point(3), b = draw.point(3);
    double least = 0.5;
    for (const TriangleMesh& t : all)
      least = std::min(least, Clearance({t}).passage(a, b, least).distance);
    EXPECT_DOUBLE_EQ(tree.passage(a, b, 0.5).distance, least);
  }
}

// Triangles that crowd towards a corner, or that share their middle, can't be cut into
// halves by planes: the tree must stay shallow and right all the same.
TEST(Clearance, OfTrianglesThatCannotBeCutIsTheLeastOfAll) {
  Draw draw;
  std::vector<TriangleMesh> all;
  for (int i = 0; i < 400; ++i) {
    const double size = std::ldexp(1.0, -i);
    all.push_back(one_triangle({size, 0, 0}, {0, size, 0}, {size, size, size}));
  }
  for (int i = 1; i < 40; ++i) {
    const double size = i;
    all.push_back(
        one_triangle({2 * size, -size, 0}, {-size, 2 * size, 0}, {-size, -size, 0}));
  }
  const Clearance tree(all);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d a = draw.point(1), b = draw.point(1);
    double least = 0.3;
    for (const TriangleMesh& t : all)
      least = std::min(least, Clearance({t}).passage(a, b, least).distance);
    EXPECT_DOUBLE_EQ(tree.passage(a, b, 0.3).distance, least);
  }
}

TEST(Clearance, ChangesAsItsDirectionSays) {
  Draw draw;
  const Clearance box({make_box({-1, -1, -1}, {1, 1, 1})});
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d a = draw.point(4), b = draw.point(4);
    const Passage at = box.passage(a, b, 1e9);
    if (at.distance < 1e-3) continue;
    const Eigen::Vector3d step = 1e-6 * draw.point(1);
    const double slope = (box.passage(a + step, b, 1e9).distance -
                          box.passage(a - step, b, 1e9).distance) /
                         2;
    EXPECT_NEAR(slope, (1 - at.part) * at.away.dot(step), 2e-4 * step.norm()) << i;
  }
}

TEST(Clearance, IsTheLimitWhereNothingIsNear) {
  EXPECT_EQ(Clearance({}).passage({0, 0, 0}, {1, 0, 0}, 0.3).distance, 0.3);
  const Clearance box({make_box({-1, -1, -1}, {1, 1, 1})});
  EXPECT_EQ(box.passage({5, 5, 5}, {6, 5, 5}, 0.3).distance, 0.3);
  EXPECT_EQ(box.passage({-5, 0, 0}, {5, 0, 0}, 0.3).distance, 0);
}

}  // namespace
}  // namespace delos
