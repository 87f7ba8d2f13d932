// Simple bodies: volumes and sizes in closed form.
#include "delos/geometry/primitives.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "delos/geometry/defects.h"

namespace delos::test {
namespace {

/// Σ a · (b × c) / 6, positive where triangles face outward.
double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6;
  }
  return sum;
}

TEST(Box, HasItsVolume) {
  const TriangleMesh box = make_box({1, 2, 3}, {2, 4, 6});
  EXPECT_EQ(box.triangles.size(), 12u);
  EXPECT_NEAR(volume(box), 1 * 2 * 3, 1e-12);
}

// A regular n-gon in a circle of radius r has the area n/2 · r² · sin(2π/n).
TEST(Cylinder, HasThePrismsVolume) {
  for (const int sides : {3, 4, 32}) {
    const TriangleMesh cylinder = make_cylinder(2, 5, sides);
    EXPECT_NEAR(volume(cylinder),
                5 * sides / 2.0 * 4 * std::sin(2 * std::numbers::pi / sides), 1e-9);
    for (const Eigen::Vector3d& p : cylinder.vertices) {
      EXPECT_NEAR(p.head<2>().norm(), 2, 1e-15);
      EXPECT_TRUE(p.z() == 0 || p.z() == 5);
    }
  }
}

TEST(Sphere, ApproachesTheBall) {
  double previous = 1;
  for (int k = 0; k <= 5; ++k) {
    const TriangleMesh sphere = make_sphere(3, k);
    EXPECT_EQ(sphere.triangles.size(), 20u << (2 * k));
    for (const Eigen::Vector3d& p : sphere.vertices) EXPECT_NEAR(p.norm(), 3, 1e-14);
    // The error falls with the square of the edges, four times a level.
    const double missing = 1 - volume(sphere) / (4.0 / 3 * std::numbers::pi * 27);
    EXPECT_GT(missing, 0);
    if (k > 1) {
      EXPECT_NEAR(previous / missing, 4, 0.5);
    }
    previous = missing;
  }
}

TEST(Extrusion, FillsNonConvexPolygonsEitherWayRound) {
  // An L of area 5; then a comb, whose teeth a fan would cross.
  std::vector<Eigen::Vector2d> corners{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_NEAR(volume(extrude(corners, 2)), 10, 1e-12);
  std::reverse(corners.begin(), corners.end());
  EXPECT_NEAR(volume(extrude(corners, 2)), 10, 1e-12);

  const std::vector<Eigen::Vector2d> comb{{0, 0}, {5, 0}, {5, 3}, {4, 3},
                                          {4, 1}, {3, 1}, {3, 3}, {2, 3},
                                          {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const TriangleMesh mesh = extrude(comb, 1);
  EXPECT_NEAR(volume(mesh), 5 + 3 * 2, 1e-12);
  EXPECT_EQ(mesh.triangles.size(), 2 * 10 + 2 * 12u);
  EXPECT_TRUE(find_defects(mesh).closed);
  EXPECT_EQ(find_defects(mesh).self_intersections, 0u);
}

std::string refusal(const std::vector<Eigen::Vector2d>& polygon) {
  try {
    (void)extrude(polygon, 1);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

TEST(Extrusion, RefusesWhatIsNoPolygon) {
  EXPECT_EQ(refusal({{0, 0}, {1, 0}}), "a polygon needs at least three corners, not 2");
  EXPECT_EQ(refusal({{0, 0}, {1, 0}, {1, NAN}}),
            "corner 2 of the polygon isn't finite");
  const char* crossing = "edges of the polygon touch or cross each other";
  EXPECT_EQ(refusal({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), crossing);
  EXPECT_EQ(refusal({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), crossing);  // a corner twice
  EXPECT_EQ(refusal({{0, 0}, {2, 0}, {1, 0}}), crossing);          // no area
  EXPECT_EQ(refusal({{0, 0}, {2, 0}, {1, 1}, {0, 0}}),
            "the last corner of the polygon repeats the first; leave it out, polygons "
            "are closed anyway");
}

TEST(Transformed, ScalesThenPlaces) {
  Pose X;
  X.R = rotation_from_rpy({0, 0, std::numbers::pi / 2});
  X.p = {1, 2, 3};
  const TriangleMesh mesh = transformed(make_box({0, 0, 0}, {1, 2, 3}), X, 0.001);
  // The far corner (1, 2, 3) mm turns to (−2, 1, 3) mm.
  EXPECT_TRUE(mesh.vertices[7].isApprox(Eigen::Vector3d(0.998, 2.001, 3.003), 1e-12));
  EXPECT_NEAR(volume(mesh), 6e-9, 1e-12);
}

}  // namespace
}  // namespace delos::test
