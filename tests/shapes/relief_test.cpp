// Height surfaces: each vertex is as high as its value.
#include "shapes/relief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace delos::shapes {
namespace {

/// Layers of 5 × 4 × 3 samples behind ten of another part.
const GridShape kGrid{{1, 2, 3}, {0.5, 0.25, 2}, {5, 4, 3}};
const SamplePart kPart{"", 10, 60, kGrid};

double value_at(const Eigen::Vector3d& p) {
  return std::exp(p.x() + 2 * p.y() - p.z());
}
double value_of(std::size_t sample) {
  const std::size_t i = sample - kPart.first;
  return value_at(kGrid.origin +
                  kGrid.step.cwiseProduct(Eigen::Vector3d(
                      double(i % 5), double(i / 5 % 4), double(i / 20))));
}

TEST(Relief, IsAsHighAsItsValues) {
  for (const bool log10 : {false, true})
    for (const int axis : {0, 1, 2}) {
      const Sheet layer =
          layer_of(kPart, kGrid, {axis, kGrid.origin[axis] + 1.2 * kGrid.step[axis]});
      const Heights heights{0.5, 800, log10, 1.5};
      const ShapeMesh shape = relief(layer, value_of, heights);
      const double base = kGrid.origin[axis] + kGrid.step[axis];
      ASSERT_EQ(shape.values.size(), std::size_t(layer.nu) * layer.nv);
      EXPECT_EQ(shape.mesh.triangles.size(), 2u * (layer.nu - 1) * (layer.nv - 1));
      for (std::size_t k = 0; k < shape.values.size(); ++k) {
        Eigen::Vector3d foot = shape.mesh.vertices[k];
        const double height = foot[axis] - base;
        foot[axis] = base;
        const double value = value_at(foot);
        EXPECT_NEAR(shape.values[k], value, 1e-12 * value);
        EXPECT_NEAR(height,
                    1.5 * (log10 ? std::log10(value / 0.5) / std::log10(800 / 0.5)
                                 : (value - 0.5) / 799.5),
                    1e-12);
        EXPECT_GT(shape.normals[k][axis], 0) << "it faces upwards";
      }
    }
}

TEST(Relief, IsAbsentAroundWhatIsBlind) {
  const Sheet layer = layer_of(kPart, kGrid, {2, 3.0});
  const std::size_t blind = kPart.first + 1 + 5 * 1;
  const ShapeMesh shape = relief(
      layer,
      [&](std::size_t i) {
        return i == blind ? std::numeric_limits<double>::infinity() : 1.0;
      },
      Heights{1, 2, false, 1});
  EXPECT_EQ(shape.values.size(), 19u);
  EXPECT_EQ(shape.mesh.triangles.size(), 2u * (12 - 4));
  EXPECT_NEAR(area_of(shape.mesh), 8 * 0.5 * 0.25, 1e-12);
}

TEST(Relief, OfASlantedPlaneStandsOnIt) {
  const PlaneShape plane{{0, 0, 1}, {0, 2, 0}, {1, 0, 1}, {3, 2}};
  const SamplePart part{"", 0, 6, plane};
  const ShapeMesh shape = relief(
      sheet_of(part, plane), [](std::size_t i) { return double(i); },
      Heights{0, 5, false, 0.5});
  // Across it, upwards: (−1, 0, 1)/√2.
  const Eigen::Vector3d up = Eigen::Vector3d(-1, 0, 1).normalized();
  for (std::size_t k = 0; k < 6; ++k) {
    const Eigen::Vector3d from = shape.mesh.vertices[k] - plane.origin;
    EXPECT_NEAR(from.dot(up), 0.1 * shape.values[k], 1e-12);
    EXPECT_GT(shape.normals[k].dot(up), 0);
  }
}

}  // namespace
}  // namespace delos::shapes
