// Surfaces at a level against planes and spheres.
#include "render/isosurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace delos::render {
namespace {

GridShape cube(double low, double high, int cells) {
  const double step = (high - low) / cells;
  return {Eigen::Vector3d::Constant(low), Eigen::Vector3d::Constant(step),
          Eigen::Matrix<std::int64_t, 3, 1>::Constant(cells + 1)};
}

Eigen::Vector3d node(const GridShape& grid, std::size_t i) {
  const auto n = static_cast<std::size_t>(grid.counts.x());
  return grid.origin + grid.step.cwiseProduct(Eigen::Vector3d(
                           double(i % n), double(i / n % n), double(i / (n * n))));
}

template <class F>
Isosurface cut(const GridShape& grid, double level, F f) {
  return isosurface(
      grid, [&](std::size_t i) { return f(node(grid, i)); }, level);
}

const auto radius = [](const Eigen::Vector3d& p) { return p.norm(); };

// The plane x + y + z = 3/2 cuts the unit cube in a regular hexagon of side 1/√2, whose
// area is 3√3/4.
TEST(Isosurface, OfALinearFieldIsThePlane) {
  for (const int cells : {2, 5}) {
    const Isosurface hexagon =
        cut(cube(0, 1, cells), 1.5, [](const Eigen::Vector3d& p) { return p.sum(); });
    EXPECT_NEAR(area_of(hexagon.mesh), 0.75 * std::sqrt(3.0), 1e-12);
    for (const Eigen::Vector3d& p : hexagon.mesh.vertices)
      EXPECT_NEAR(p.sum(), 1.5, 1e-12);
    for (const Eigen::Vector3d& n : hexagon.normals) {
      // Where a corner only touches, triangles have no area.
      if (n.norm() < 0.5) continue;
      EXPECT_NEAR(n.sum(), std::sqrt(3.0), 1e-9) << "towards larger values";
    }
  }
}

TEST(Isosurface, OfASphereIsOfSecondOrder) {
  const double r = 0.8, sphere = 4 * std::numbers::pi * r * r;
  const auto error = [&](int cells) {
    return std::abs(area_of(cut(cube(-1, 1, cells), r, radius).mesh) - sphere) / sphere;
  };
  const double coarse = error(16), middle = error(32), fine = error(64);
  EXPECT_LT(fine, 1e-3);
  EXPECT_NEAR(coarse / middle, 4, 0.8);
  EXPECT_NEAR(middle / fine, 4, 0.8);
}

TEST(Isosurface, IsClosedAndFacesLargerValues) {
  const double r = 0.8;
  const TriangleMesh mesh = cut(cube(-1, 1, 32), r, radius).mesh;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double volume = 0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
    volume +=
        mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6;
  }
  for (const auto& [edge, balance] : edges) ASSERT_EQ(balance, 0);
  const double ball = 4 * std::numbers::pi * r * r * r / 3;
  EXPECT_NEAR(volume, ball, 0.005 * ball);
}

// The node at (½, ½, ½) has no value: the eight cells around it are left out, and with
// them what the plane z = 0.45 has within [¼, ¾]².
TEST(Isosurface, EndsWhereAValueIsMissing) {
  const auto field = [](const Eigen::Vector3d& p) {
    return (p - Eigen::Vector3d::Constant(0.5)).norm() < 1e-9
               ? std::numeric_limits<double>::quiet_NaN()
               : p.z();
  };
  EXPECT_NEAR(area_of(cut(cube(0, 1, 4), 0.45, field).mesh), 0.75, 1e-12);
  EXPECT_NEAR(area_of(cut(cube(0, 1, 4), 0.1, field).mesh), 1, 1e-12);
}

}  // namespace
}  // namespace delos::render
