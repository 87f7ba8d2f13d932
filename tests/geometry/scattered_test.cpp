// Surfaces over scattered points: what is known of each interpolation by itself.
#include "delos/geometry/scattered.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace delos {
namespace {

constexpr ScatteredMethod kEvery[] = {ScatteredMethod::nearest, ScatteredMethod::linear,
                                      ScatteredMethod::natural_neighbour,
                                      ScatteredMethod::inverse_distance,
                                      ScatteredMethod::minimum_curvature};

std::vector<Eigen::Vector2d> scattered(int count, double size = 1) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> in(0, size);
  std::vector<Eigen::Vector2d> points = {{0, 0}, {size, 0}, {0, size}, {size, size}};
  for (int i = 0; i < count; ++i) {
    const double x = in(random), y = in(random);
    points.emplace_back(x, y);
  }
  return points;
}

std::vector<double> values_at(const std::vector<Eigen::Vector2d>& points,
                              double (*of)(const Eigen::Vector2d&)) {
  std::vector<double> values;
  for (const Eigen::Vector2d& p : points) values.push_back(of(p));
  return values;
}

double wavy(const Eigen::Vector2d& p) { return std::sin(3 * p.x()) + p.y() * p.y(); }
double plane(const Eigen::Vector2d& p) { return 2 + 3 * p.x() - p.y(); }

TEST(Scattered, AllReturnTheSamplesAtTheSamples) {
  const auto points = scattered(60);
  const auto values = values_at(points, wavy);
  for (const ScatteredMethod method : kEvery) {
    const ScatteredSurface surface(points, values, method);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(surface.at(points[i]), values[i], 1e-9) << static_cast<int>(method);
  }
}

TEST(Scattered, LinearNaturalAndPlateAreExactOnAPlane) {
  const auto points = scattered(40);
  const auto values = values_at(points, plane);
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> in(0.01, 0.99);
  for (int i = 0; i < 200; ++i) {
    const double x = in(random), y = in(random);
    const Eigen::Vector2d p(x, y);
    for (const ScatteredMethod method :
         {ScatteredMethod::linear, ScatteredMethod::natural_neighbour,
          ScatteredMethod::minimum_curvature})
      EXPECT_NEAR(ScatteredSurface(points, values, method).at(p), plane(p), 1e-9)
          << static_cast<int>(method);
  }
}

TEST(Scattered, NearestIsThatOfTheNearestPoint) {
  const auto points = scattered(50);
  const auto values = values_at(points, wavy);
  const ScatteredSurface surface(points, values, ScatteredMethod::nearest);
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> in(-0.5, 1.5);
  for (int i = 0; i < 100; ++i) {
    const double x = in(random), y = in(random);
    std::size_t best = 0;
    for (std::size_t k = 1; k < points.size(); ++k)
      if ((points[k] - Eigen::Vector2d(x, y)).norm() <
          (points[best] - Eigen::Vector2d(x, y)).norm())
        best = k;
    EXPECT_EQ(surface.at({x, y}), values[best]);
  }
}

/// In the middle of a square's corners all four count alike.
TEST(Scattered, OfASquareIsTheClosedForm) {
  const std::vector<Eigen::Vector2d> square = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  const ScatteredSurface surface(square, {1, 2, 3, 6},
                                 ScatteredMethod::natural_neighbour);
  EXPECT_NEAR(surface.at({0.5, 0.5}), 3, 1e-12);
  const ScatteredSurface by_distance(square, {1, 2, 3, 6},
                                     ScatteredMethod::inverse_distance);
  EXPECT_NEAR(by_distance.at({0.5, 0.5}), 3, 1e-12);
  // Squares of distances 1/16 + 1/16, 9/16 + 1/16 twice, 9/16 + 9/16.
  EXPECT_NEAR(by_distance.at({0.25, 0.25}),
              (8 * 1 + 1.6 * 2 + 1.6 * 3 + 8 / 9. * 6) / (8 + 3.2 + 8 / 9.), 1e-12);
}

/// Of all surfaces through the samples the plate bends least: a smooth function comes
/// out nearer than by planes.
TEST(Scattered, ThePlateIsSmootherThanPlanes) {
  const auto points = scattered(60);
  const auto values = values_at(points, wavy);
  double plate = 0, planes = 0, natural = 0;
  for (double x = 0.05; x < 1; x += 0.1)
    for (double y = 0.05; y < 1; y += 0.1) {
      const auto off = [&](ScatteredMethod method) {
        return std::abs(ScatteredSurface(points, values, method).at({x, y}) -
                        wavy({x, y}));
      };
      plate += off(ScatteredMethod::minimum_curvature);
      planes += off(ScatteredMethod::linear);
      natural += off(ScatteredMethod::natural_neighbour);
    }
  EXPECT_LT(plate, 0.5 * planes);
  EXPECT_LT(natural, planes);
}

TEST(Scattered, KnowsNothingOutsideAndRefusesWhatHasNoSurface) {
  const auto points = scattered(10);
  const auto values = values_at(points, wavy);
  EXPECT_TRUE(std::isnan(
      ScatteredSurface(points, values, ScatteredMethod::linear).at({1.1, 0.5})));
  EXPECT_TRUE(
      std::isnan(ScatteredSurface(points, values, ScatteredMethod::natural_neighbour)
                     .at({1.1, 0.5})));
  const std::vector<Eigen::Vector2d> line = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  EXPECT_THROW(ScatteredSurface(line, {1, 2, 3, 4}, ScatteredMethod::minimum_curvature),
               std::invalid_argument);
  EXPECT_THROW(ScatteredSurface({}, {}, ScatteredMethod::nearest),
               std::invalid_argument);
  EXPECT_TRUE(std::isnan(
      ScatteredSurface(line, {1, 2, 3, 4}, ScatteredMethod::linear).at({1, 1.5})));
  // One place twice is one with the mean.
  const ScatteredSurface twice({{0, 0}, {0, 0}, {5, 0}}, {1, 3, 7},
                               ScatteredMethod::nearest);
  EXPECT_EQ(twice.at({1, 0}), 2);
}

}  // namespace
}  // namespace delos
