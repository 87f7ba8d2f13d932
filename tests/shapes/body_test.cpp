// Surfaces at a level and bodies between two, against planes, spheres and shells.
#include "shapes/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace delos::shapes {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = std::numbers::pi;

GridShape cube(double low, double high, int cells) {
  const double step = (high - low) / cells;
  return {Eigen::Vector3d::Constant(low), Eigen::Vector3d::Constant(step),
          Eigen::Matrix<std::int64_t, 3, 1>::Constant(cells + 1)};
}

template <class F>
ScalarGrid sampled(const GridShape& grid, F f) {
  ScalarGrid values{grid, {}};
  for (int z = 0; z < grid.counts.z(); ++z)
    for (int y = 0; y < grid.counts.y(); ++y)
      for (int x = 0; x < grid.counts.x(); ++x)
        values.value.push_back(f(Eigen::Vector3d(
            grid.origin + grid.step.cwiseProduct(Eigen::Vector3d(x, y, z)))));
  return values;
}

const auto radius = [](const Eigen::Vector3d& p) { return p.norm(); };

/// How often edges are gone along in one direction more than in the other.
int open_edges(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  int open = 0;
  for (const auto& [edge, balance] : edges) open += std::abs(balance);
  return open;
}

// The plane x + y + z = 3/2 cuts the unit cube in a regular hexagon of side 1/√2, whose
// area is 3√3/4.
TEST(Isosurface, OfALinearFieldIsThePlane) {
  for (const int cells : {2, 5}) {
    const ShapeMesh hexagon = isosurface(
        sampled(cube(0, 1, cells), [](const Eigen::Vector3d& p) { return p.sum(); }),
        1.5);
    EXPECT_NEAR(area_of(hexagon.mesh), 0.75 * std::sqrt(3.0), 1e-12);
    for (const Eigen::Vector3d& p : hexagon.mesh.vertices)
      EXPECT_NEAR(p.sum(), 1.5, 1e-12);
    for (const double value : hexagon.values) EXPECT_EQ(value, 1.5);
    for (const Eigen::Vector3d& n : hexagon.normals) {
      // Where a corner only touches, triangles have no area.
      if (n.norm() < 0.5) continue;
      EXPECT_NEAR(n.sum(), std::sqrt(3.0), 1e-9) << "towards larger values";
    }
  }
}

TEST(Isosurface, OfASphereIsOfSecondOrder) {
  const double r = 0.8, sphere = 4 * kPi * r * r;
  const auto error = [&](int cells) {
    const ScalarGrid grid = sampled(cube(-1, 1, cells), radius);
    return std::abs(area_of(isosurface(grid, r).mesh) - sphere) / sphere;
  };
  const double coarse = error(16), middle = error(32), fine = error(64);
  EXPECT_LT(fine, 1e-3);
  EXPECT_NEAR(coarse / middle, 4, 0.8);
  EXPECT_NEAR(middle / fine, 4, 0.8);
}

TEST(Isosurface, IsClosedAndFacesLargerValues) {
  const double r = 0.8, ball = 4 * kPi * r * r * r / 3;
  const ShapeMesh shape = isosurface(sampled(cube(-1, 1, 32), radius), r);
  EXPECT_EQ(open_edges(shape.mesh), 0);
  EXPECT_NEAR(volume_of(shape.mesh), ball, 0.005 * ball);
}

// The node at (½, ½, ½) has no value: the eight cells around it are left out, and with
// them what the plane z = 0.45 has within [¼, ¾]².
TEST(Isosurface, EndsWhereAValueIsMissing) {
  const ScalarGrid grid = sampled(cube(0, 1, 4), [](const Eigen::Vector3d& p) {
    return (p - Eigen::Vector3d::Constant(0.5)).norm() < 1e-9 ? kNothing : p.z();
  });
  EXPECT_NEAR(area_of(isosurface(grid, 0.45).mesh), 0.75, 1e-12);
  EXPECT_NEAR(area_of(isosurface(grid, 0.1).mesh), 1, 1e-12);
}

// Between two spheres; its volume is their difference, its area their sum.
TEST(Body, OfASphericalShellIsOfSecondOrder) {
  const double r = 0.45, R = 0.8;
  const double volume = 4 * kPi * (R * R * R - r * r * r) / 3;
  const double area = 4 * kPi * (R * R + r * r);
  const auto errors = [&](int cells) {
    const ShapeMesh shell = body_between(sampled(cube(-1, 1, cells), radius), r, R);
    EXPECT_EQ(open_edges(shell.mesh), 0);
    EXPECT_EQ(shell.caps, shell.mesh.triangles.size()) << "it ends nowhere";
    return std::pair(std::abs(volume_of(shell.mesh) / volume - 1),
                     std::abs(area_of(shell.mesh) / area - 1));
  };
  const auto coarse = errors(24), fine = errors(48);
  EXPECT_LT(fine.first, 4e-3);
  EXPECT_LT(fine.second, 4e-3);
  EXPECT_NEAR(coarse.first / fine.first, 4, 0.8);
  EXPECT_NEAR(coarse.second / fine.second, 4, 0.8);
}

// Of a linear field it is exact: the slab ¼ ≤ x + y + z ≤ 3/2 of the unit cube. Below
// 3/2 is half of the cube, and below ¼ a corner of it, ¼³/6.
TEST(Body, IsCappedWhereTheGridEnds) {
  for (const int cells : {1, 3, 4}) {
    const ShapeMesh slab = body_between(
        sampled(cube(0, 1, cells), [](const Eigen::Vector3d& p) { return p.sum(); }),
        0.25, 1.5);
    EXPECT_EQ(open_edges(slab.mesh), 0) << cells;
    EXPECT_NEAR(volume_of(slab.mesh), 0.5 - 0.25 * 0.25 * 0.25 / 6, 1e-12) << cells;
    // The hexagon, the small triangle of side √2/4, and of the faces at 0 all but what
    // is beyond 3/2, ⅛, which the faces at 1 have, and below ¼, 1/32.
    EXPECT_NEAR(area_of(slab.mesh),
                0.75 * std::sqrt(3.0) + std::sqrt(3.0) / 32 + 3 * (1 - 1 / 32.0), 1e-12)
        << cells;
    EXPECT_LT(slab.caps, slab.mesh.triangles.size());
  }
}

TEST(Body, WithoutEndsIsAllThatHasAValue) {
  const ScalarGrid grid =
      sampled(cube(0, 1, 4), [](const Eigen::Vector3d& p) { return p.x(); });
  const ShapeMesh box = body_between(grid, -kInfinity, kInfinity);
  EXPECT_EQ(open_edges(box.mesh), 0);
  EXPECT_EQ(box.caps, 0u);
  EXPECT_NEAR(volume_of(box.mesh), 1, 1e-12);
  EXPECT_NEAR(area_of(box.mesh), 6, 1e-12);
  EXPECT_TRUE(body_between(grid, 2, 3).mesh.triangles.empty());
}

// No part of a cell with a corner without a value: the box from ¼ to ¾ is left out, and
// with it an eighth of the cube. It is closed there, too, by six squares of ¼.
TEST(Body, IsNeverWhereAValueIsMissing) {
  const ScalarGrid grid = sampled(cube(0, 1, 4), [](const Eigen::Vector3d& p) {
    return (p - Eigen::Vector3d::Constant(0.5)).norm() < 1e-9 ? kNothing : p.z();
  });
  const ShapeMesh body = body_between(grid, -kInfinity, 0.6);
  EXPECT_EQ(open_edges(body.mesh), 0);
  EXPECT_NEAR(volume_of(body.mesh), 0.6 - 0.25 * 0.35, 1e-12);
  const Eigen::AlignedBox3d blind(Eigen::Vector3d::Constant(0.26),
                                  Eigen::Vector3d::Constant(0.74));
  for (const Eigen::Vector3d& p : body.mesh.vertices) EXPECT_FALSE(blind.contains(p));
}

// Levels that are values of nodes make triangles without an area; it stays closed.
TEST(Body, IsClosedWhereNodesHaveTheValuesOfItsEnds) {
  const ScalarGrid grid = sampled(cube(-4, 4, 8), [](const Eigen::Vector3d& p) {
    const double value = std::round(p.x() * p.y() + p.z());
    return std::abs(p.x() - 2) + std::abs(p.y()) < 0.5 ? kNothing : value;
  });
  for (const auto& [low, high] : {std::pair(-1.0, 2.0), {0.0, 0.0}, {1.0, kInfinity}}) {
    const ShapeMesh body = body_between(grid, low, high);
    EXPECT_FALSE(body.mesh.triangles.empty());
    EXPECT_EQ(open_edges(body.mesh), 0) << low << ' ' << high;
    for (const double value : body.values) EXPECT_TRUE(value >= low && value <= high);
  }
}

TEST(Body, IsGivenUp) {
  const std::atomic<bool> stop{true};
  const ScalarGrid grid = sampled(cube(-1, 1, 8), radius);
  EXPECT_TRUE(body_between(grid, 0.2, 0.5, &stop).mesh.triangles.empty());
}

}  // namespace
}  // namespace delos::shapes
