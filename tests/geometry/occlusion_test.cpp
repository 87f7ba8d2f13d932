// Which segments are blocked: against every triangle in exact integers, and closed
// forms.
#include <gtest/gtest.h>

#include <numbers>

#include "delos/geometry/occluders.h"
#include "delos/geometry/primitives.h"
#include "geometry/integer_meshes.h"

namespace delos::test {
namespace {

/// A star with dents, so that nothing about it is convex.
TriangleMesh star() {
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < 14; ++i) {
    const double angle = 2 * std::numbers::pi * i / 14, r = i % 2 == 0 ? 1 : 0.4;
    corners.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return extrude(corners, 0.7);
}

/// Triangles that have nothing to do with each other.
TriangleMesh confetti() {
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> draw(-1, 1);
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Eigen::Vector3d at(draw(engine), draw(engine), draw(engine));
    for (int k = 0; k < 3; ++k) {
      mesh.vertices.push_back(
          at + 0.3 * Eigen::Vector3d(draw(engine), draw(engine), draw(engine)));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

struct Case {
  const char* name;
  TriangleMesh mesh;
};

void PrintTo(const Case& c, std::ostream* os) { *os << c.name; }

class BruteForce : public testing::TestWithParam<Case> {};

/// A segment: anywhere; or with ends on corners, on edges' midpoints, or in the plane
/// of a triangle, where an answer by rounded numbers would be luck.
std::pair<IntPoint, IntPoint> draw_segment(IntDraw& draw, const IntMesh& m,
                                           std::int64_t reach) {
  const auto some_triangle = [&] {
    return m.triangles[draw.between(0, std::ssize(m.triangles) - 1)];
  };
  // From v through u and on by as much again.
  const auto beyond = [](const IntPoint& u, const IntPoint& v) { return u - (v - u); };
  const IntPoint p = draw.point(reach), q = draw.point(reach);
  const auto [a, b, c] = some_triangle();
  switch (draw.between(0, 6)) {
    case 0:
      return {p, a};  // ends on a corner
    case 1:
      return {p, beyond(a, p)};  // passes through a corner
    case 2:
      return {beyond(a, b), beyond(b, a)};  // along an edge and past it
    case 3:
      return {beyond(a, b), beyond(c, b)};  // in the triangle's plane
    case 4:
      return {beyond(a, c), some_triangle()[1]};  // from that plane to a corner
    default:
      return {p, q};
  }
}

// 20,000 segments a mesh: 5,000 at each of four sizes, from a millimetre to ten
// kilometres. On the coarse grids, 12 units across, even a segment drawn anywhere often
// meets corners and edges; on the fine one there are near misses.
TEST_P(BruteForce, GivesTheSameAnswers) {
  IntDraw draw(1);
  int touched = 0, blocked = 0;
  for (const auto& [size, length] : {std::pair(6.0, 1e-3), std::pair(6.0, 1e4),
                                     std::pair(4000.0, 1.0), std::pair(200.0, 1e4)}) {
    const double unit = std::exp2(std::floor(std::log2(length / size)));
    const IntMesh m = rounded(GetParam().mesh, size, unit);
    const Occluders occluders({m.mesh});
    for (int i = 0; i < 5000; ++i) {
      const auto [p, q] = draw_segment(draw, m, static_cast<std::int64_t>(2 * size));
      if (p.x == q.x && p.y == q.y && p.z == q.z) continue;
      bool expected = false, touches = true;
      for (const IntTriangle& t : m.triangles) {
        if (!segment_meets(t, p, q)) continue;
        expected = true;
        // Strictly through the inside of a triangle is more than touching.
        const int ab = side(p, q, t[0], t[1]), bc = side(p, q, t[1], t[2]),
                  ca = side(p, q, t[2], t[0]);
        if (ab != 0 && ab == bc && bc == ca) touches = false;
      }
      blocked += expected;
      touched += expected && touches;
      ASSERT_EQ(occluders.blocks(m.point(p), m.point(q), 0), expected)
          << "from " << m.point(p).transpose() << " to " << m.point(q).transpose();
      ASSERT_EQ(occluders.blocks(m.point(q), m.point(p), 0), expected);
    }
  }
  // The cases are what they are meant to be.
  EXPECT_GT(blocked, 4000);
  EXPECT_LT(blocked, 19000);
  EXPECT_GT(touched, 1000);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, BruteForce,
    testing::Values(Case{"box", make_box({-1, -0.5, -1}, {1, 0.5, 0.5})},
                    Case{"cylinder", make_cylinder(1, 1.5, 24)},
                    Case{"sphere", make_sphere(1, 3)}, Case{"star", star()},
                    Case{"confetti", confetti()}),
    [](const auto& i) { return i.param.name; });

// Boxes are kept in floats: what is too small or too large for them, or small and far
// away, is as exact. Powers of two leave the integers what they are.
TEST(Occluders, AreExactAtAnySizeAndAnywhere) {
  struct Place {
    double unit, away;  // metres; units
  };
  for (const auto& [unit, away] :
       {Place{0x1p-140, 0}, Place{0x1p-110, 0}, Place{0x1p-10, 0x1p40},
        Place{0x1p-30, 0x1p45}, Place{0x1p100, 0}, Place{0x1p130, 0}, Place{0x1p400, 0},
        Place{0x1p85, 0x1p20}}) {
    const Eigen::Vector3d offset = unit * away * Eigen::Vector3d(1, -1, 0.5);
    IntMesh m = rounded(confetti(), 200, unit);
    for (Eigen::Vector3d& p : m.mesh.vertices) p += offset;
    const Occluders occluders({m.mesh});
    IntDraw draw(5);
    int blocked = 0;
    for (int i = 0; i < 3000; ++i) {
      const auto [p, q] = draw_segment(draw, m, 400);
      if (p.x == q.x && p.y == q.y && p.z == q.z) continue;
      const Eigen::Vector3d a = m.point(p) + offset, b = m.point(q) + offset;
      const bool expected =
          std::any_of(m.triangles.begin(), m.triangles.end(),
                      [&](const IntTriangle& t) { return segment_meets(t, p, q); });
      blocked += expected;
      ASSERT_EQ(occluders.blocks(a, b, 0), expected) << "unit " << unit;
      if (expected) {
        ASSERT_TRUE(occluders.touches_shaft(a, {b, b})) << "unit " << unit;
      }
    }
    EXPECT_GT(blocked, 500);
    EXPECT_LT(blocked, 2700);
  }
}

// Determinants of coordinates this long don't fit into doubles: what is zero comes out
// as something else where it is rounded.
TEST(Occluders, AreExactWhereDoublesRound) {
  const IntMesh m = rounded(confetti(), 2e5, 1);
  const Occluders occluders({m.mesh});
  IntDraw draw(6);
  for (int i = 0; i < 10000; ++i) {
    const auto [p, q] = draw_segment(draw, m, 400000);
    const bool expected =
        std::any_of(m.triangles.begin(), m.triangles.end(),
                    [&](const IntTriangle& t) { return segment_meets(t, p, q); });
    ASSERT_EQ(occluders.blocks(m.point(p), m.point(q), 0), expected)
        << "from " << m.point(p).transpose() << " to " << m.point(q).transpose();
  }
}

// Seen from the origin, the wall x = 2, |y| ≤ 1, |z| ≤ 1 hides what is behind it and,
// by similar triangles, within |y| ≤ x/2, |z| ≤ x/2.
TEST(Shadow, OfAWallIsAPyramid) {
  TriangleMesh wall;
  wall.vertices = {{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}};
  wall.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Occluders occluders({wall});
  std::mt19937_64 engine(2);
  std::uniform_real_distribution<double> draw(-4, 4);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d p(draw(engine), draw(engine), draw(engine));
    const bool behind =
        p.x() > 2 && 2 * std::abs(p.y()) < p.x() && 2 * std::abs(p.z()) < p.x();
    ASSERT_EQ(occluders.blocks({0, 0, 0}, p, 1e-9), behind) << p.transpose();
  }
}

// A ball of radius r at distance d hides the cone of half-angle asin(r/d), behind it.
// The mesh lies between the ball through its corners and the one that touches its
// triangles from within.
TEST(Shadow, OfASphereIsACone) {
  const TriangleMesh sphere = make_sphere(1, 5);
  double inner = 1;
  for (const auto& [a, b, c] : sphere.triangles) {
    const Eigen::Vector3d n = (sphere.vertices[b] - sphere.vertices[a])
                                  .cross(sphere.vertices[c] - sphere.vertices[a])
                                  .normalized();
    inner = std::min(inner, n.dot(sphere.vertices[a]));
  }
  ASSERT_GT(inner, 0.999);
  const Occluders occluders({sphere});
  const Eigen::Vector3d apex(0, 0, 3);
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> draw(-3, 3);
  int decided = 0;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d p(draw(engine), draw(engine), -1.5 + 0.1 * draw(engine));
    const double angle = std::acos((p - apex).normalized().dot(-apex.normalized()));
    const double outer_edge = std::asin(1.0 / 3), inner_edge = std::asin(inner / 3);
    if (angle > inner_edge && angle < outer_edge) continue;
    ++decided;
    ASSERT_EQ(occluders.blocks(apex, p, 0), angle <= inner_edge) << p.transpose();
  }
  EXPECT_GT(decided, 19900);
}

TEST(Skin, LeavesOutWhatIsNearTheEnds) {
  // A triangle in the plane z = 0.25; powers of two are shortened without rounding.
  TriangleMesh sheet;
  sheet.vertices = {{-1, -1, 0.25}, {2, -1, 0.25}, {-1, 2, 0.25}};
  sheet.triangles = {{0, 1, 2}};
  const Occluders occluders({sheet});
  const Eigen::Vector3d a(0, 0, 0), b(0, 0, 1);
  EXPECT_TRUE(occluders.blocks(a, b, 0.125));
  EXPECT_TRUE(occluders.blocks(a, b, 0.25));  // touching
  EXPECT_TRUE(occluders.blocks(b, a, 0.25));
  EXPECT_FALSE(occluders.blocks(a, b, 0.375));
  EXPECT_FALSE(occluders.blocks(b, a, 0.375));
  // Nothing is left of a segment that isn't longer than both skins.
  EXPECT_FALSE(occluders.blocks({0, 0, 0}, {0, 0, 0.5}, 0.25));
  EXPECT_FALSE(occluders.blocks({0, 0, 0.25}, {0, 0, 0.25}, 0));
}

TEST(Occluders, WithoutTrianglesHideNothing) {
  for (const Occluders& nothing :
       {Occluders(), Occluders({TriangleMesh()}),
        Occluders({TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}})}) {
    EXPECT_EQ(nothing.triangles(), 0u);
    EXPECT_TRUE(nothing.bounds().isEmpty());
    EXPECT_FALSE(nothing.blocks({0, -1, 0}, {1, 1, 0}, 0));
    EXPECT_FALSE(nothing.contains({0, 0, 0}));
    const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));
    EXPECT_FALSE(nothing.touches_shaft({0, -1, 0}, box));
    EXPECT_FALSE(nothing.hides({0, -1, 0}, box, 0));
  }
}

TEST(Occluders, CountConvexBodiesAsOnePiece) {
  const TriangleMesh box = make_box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(Occluders({box}).pieces(), 1u);
  EXPECT_EQ(Occluders({make_sphere(1, 4)}).pieces(), 1u);
  EXPECT_EQ(Occluders({make_cylinder(1, 2, 40)}).pieces(), 1u);
  EXPECT_EQ(Occluders({star()}).pieces(), star().triangles.size());

  // Two boxes in one mesh, one of them inside out: two pieces.
  TriangleMesh two = box;
  for (const Eigen::Vector3d& p : box.vertices) {
    two.vertices.push_back(p + Eigen::Vector3d(3, 0, 0));
  }
  for (const auto& [a, b, c] : box.triangles) {
    two.triangles.push_back({a + 8, c + 8, b + 8});
  }
  EXPECT_EQ(Occluders({two}).pieces(), 2u);
  EXPECT_EQ(Occluders({two, box}).pieces(), 3u);

  // Without one triangle it is open; with a corner pushed in it has a dent.
  TriangleMesh open = box;
  open.triangles.pop_back();
  EXPECT_EQ(Occluders({open}).pieces(), 11u);
  TriangleMesh dented = make_sphere(1, 2);
  dented.vertices[5] *= 0.9;
  EXPECT_EQ(Occluders({dented}).pieces(), dented.triangles.size());
}

// A double pyramid whose rim runs twice around the axis before it closes. Every edge
// bends inward and the centre sees all faces from behind, but it isn't convex: it
// crosses itself.
TEST(Occluders, AreNotFooledByASurfaceThatWindsTwice) {
  TriangleMesh star_pyramid;
  for (int i = 0; i < 5; ++i) {
    const double angle = 4 * std::numbers::pi * i / 5;
    star_pyramid.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  star_pyramid.vertices.emplace_back(0, 0, 1);
  star_pyramid.vertices.emplace_back(0, 0, -1);
  for (std::uint32_t i = 0; i < 5; ++i) {
    star_pyramid.triangles.push_back({i, (i + 1) % 5, 5});
    star_pyramid.triangles.push_back({(i + 1) % 5, i, 6});
  }
  EXPECT_EQ(Occluders({star_pyramid}).pieces(), 10u);
}

}  // namespace
}  // namespace delos::test
