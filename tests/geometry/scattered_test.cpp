// Surfaces over scattered points: what is known of each interpolation by itself.
#include "delos/geometry/scattered.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace delos {
namespace {

constexpr auto kEvery = kScatteredMethods;
constexpr double kInf = std::numeric_limits<double>::infinity();

ScatteredSurface surface_by(ScatteredMethod method,
                            const std::vector<Eigen::Vector2d>& points,
                            const std::vector<double>& values) {
  return {points, values, {method}};
}

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
    const ScatteredSurface surface = surface_by(method, points, values);
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
      EXPECT_NEAR(surface_by(method, points, values).at(p), plane(p), 1e-10)
          << static_cast<int>(method);
  }
}

TEST(Scattered, NearestIsThatOfTheNearestPoint) {
  const auto points = scattered(50);
  const auto values = values_at(points, wavy);
  const ScatteredSurface surface = surface_by(ScatteredMethod::nearest, points, values);
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
  const ScatteredSurface surface =
      surface_by(ScatteredMethod::natural_neighbour, square, {1, 2, 3, 6});
  EXPECT_NEAR(surface.at({0.5, 0.5}), 3, 1e-12);
  const ScatteredSurface by_distance =
      surface_by(ScatteredMethod::inverse_distance, square, {1, 2, 3, 6});
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
        return std::abs(surface_by(method, points, values).at({x, y}) - wavy({x, y}));
      };
      plate += off(ScatteredMethod::minimum_curvature);
      planes += off(ScatteredMethod::linear);
      natural += off(ScatteredMethod::natural_neighbour);
    }
  EXPECT_LT(plate, 0.5 * planes);
  EXPECT_LT(natural, planes);
}

/// Of the corners (±1, ±1) with values 1, −1, 1, −1 in turn, by symmetry there is no
/// plane and all weights are ±a: a (φ(0) − 2 φ(2) + φ(√8)) = 1 at a corner, with
/// φ(2) = 4 ln 2 and φ(√8) = 12 ln 2, so that a = 1/(4 ln 2).
TEST(Scattered, ThePlateOfASquareIsTheClosedForm) {
  const auto plate = surface_by(ScatteredMethod::minimum_curvature,
                                {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}, {1, -1, 1, -1});
  const auto phi = [](double square) { return square / 2 * std::log(square); };
  const double a = 1 / (4 * std::log(2));
  EXPECT_NEAR(plate.at({0, 0}), 0, 1e-12);
  EXPECT_NEAR(plate.at({1, 0}), 0, 1e-12);
  EXPECT_NEAR(plate.at({0.5, 0.5}), a * (phi(0.5) - 2 * phi(2.5) + phi(4.5)), 1e-12);
  EXPECT_NEAR(plate.at({3, 2}), a * (phi(5) - phi(17) + phi(25) - phi(13)), 1e-12);
}

/// Sibson's weights are what a cell at the place takes of the others' cells: counted
/// here on a raster, whose nearest points are found by trying all.
TEST(Scattered, NaturalNeighboursShareTheCell) {
  const auto points = scattered(12);
  const auto values = values_at(points, wavy);
  const auto surface = surface_by(ScatteredMethod::natural_neighbour, points, values);
  for (const Eigen::Vector2d& place :
       {Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(0.37, 0.61)}) {
    constexpr int kRaster = 800;
    double sum = 0;
    int taken = 0;
    for (int i = 0; i < kRaster; ++i)
      for (int j = 0; j < kRaster; ++j) {
        const Eigen::Vector2d q((i + 0.5) / kRaster, (j + 0.5) / kRaster);
        std::size_t best = 0;
        for (std::size_t k = 1; k < points.size(); ++k)
          if ((points[k] - q).squaredNorm() < (points[best] - q).squaredNorm())
            best = k;
        if ((place - q).squaredNorm() > (points[best] - q).squaredNorm()) continue;
        sum += values[best];
        ++taken;
      }
    EXPECT_GT(taken, 5000);
    EXPECT_NEAR(surface.at(place), sum / taken, 4e-3);
  }
}

/// w = ((r − d)/(r d))ᵖ by hand, of points 1, 2 and 4 away.
TEST(Scattered, InverseDistanceHasAPowerAndARadius) {
  const std::vector<Eigen::Vector2d> points = {{1, 0}, {0, 2}, {-4, 0}};
  const std::vector<double> values = {1, 10, 100};
  const auto at = [&](double power, double radius) {
    return ScatteredSurface(points, values,
                            {ScatteredMethod::inverse_distance, power, radius})
        .at({0, 0});
  };
  EXPECT_NEAR(at(1, kInf), (1 + 10 / 2. + 100 / 4.) / (1 + 1 / 2. + 1 / 4.), 1e-12);
  EXPECT_NEAR(at(3, kInf), (1 + 10 / 8. + 100 / 64.) / (1 + 1 / 8. + 1 / 64.), 1e-12);
  // Of radius 3: (3 − 1)/3 and (3 − 2)/6, squared; the third one is beyond.
  EXPECT_NEAR(at(2, 3), (4 / 9. + 10 / 36.) / (4 / 9. + 1 / 36.), 1e-12);
  EXPECT_EQ(at(2, 1.5), 1);
  EXPECT_TRUE(std::isnan(at(2, 0.5))) << "nothing is near: undefined, not zero";
  EXPECT_NEAR(at(2, 1e9), at(2, kInf), 1e-6);
}

/// Nine points, the middle one blind: what is nearest to it is blind by every method,
/// whatever its neighbours have; elsewhere it is as if it weren't there.
TEST(Scattered, BlindPointsMakeTheirNeighbourhoodBlind) {
  std::vector<Eigen::Vector2d> points, rest;
  std::vector<double> values, seen;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const bool blind = i == 1 && j == 1;
      points.emplace_back(i, j);
      values.push_back(blind ? kInf : 1 + i + 2 * j * j);
      if (blind) continue;
      rest.push_back(points.back());
      seen.push_back(values.back());
    }
  for (const double without : {kInf, -kInf, std::numeric_limits<double>::quiet_NaN()}) {
    values[4] = without;
    for (const ScatteredMethod method : kEvery) {
      const auto surface = surface_by(method, points, values);
      const auto others = surface_by(method, rest, seen);
      for (const Eigen::Vector2d& p :
           {Eigen::Vector2d(1, 1), Eigen::Vector2d(0.6, 1.3), Eigen::Vector2d(1.45, 1)})
        EXPECT_EQ(surface.at(p), kInf) << to_string(method);
      for (const Eigen::Vector2d& p :
           {Eigen::Vector2d(0.4, 1), Eigen::Vector2d(0.1, 0.2),
            Eigen::Vector2d(2, 1.6)})
        EXPECT_EQ(surface.at(p), others.at(p)) << to_string(method);
    }
  }
}

/// Between points that see and blind ones there is no plane; outside of all, nothing.
TEST(Scattered, IsBlindBetweenBlindAndSeeing) {
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {1, 0}, {0, 1}, {4, 0}, {4, 4}};
  const std::vector<double> values = {1, 2, 3, kInf, kInf};
  for (const ScatteredMethod method :
       {ScatteredMethod::linear, ScatteredMethod::natural_neighbour}) {
    const auto surface = surface_by(method, points, values);
    EXPECT_NEAR(surface.at({0.25, 0.25}), 1.75, 1e-12);
    EXPECT_EQ(surface.at({1.5, 0.5}), kInf);
    EXPECT_EQ(surface.at({3.9, 1}), kInf);
    EXPECT_TRUE(std::isnan(surface.at({0, 3})));
    EXPECT_TRUE(std::isnan(surface.at({5, 2})));
    // Two that see span no plane.
    EXPECT_EQ(surface_by(method, points, {1, 2, kInf, kInf, kInf}).at({0.3, 0.1}),
              kInf);
  }
  for (const ScatteredMethod method : kEvery)
    EXPECT_EQ(surface_by(method, points, {kInf, kInf, kInf, kInf, kInf}).at({1, 0.5}),
              kInf);
}

std::string refusal_of(const std::vector<Eigen::Vector2d>& points,
                       const ScatteredOptions& options) {
  try {
    ScatteredSurface(points, std::vector<double>(points.size(), 1), options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Scattered, KnowsNothingOutsideAndRefusesWhatHasNoSurface) {
  const auto points = scattered(10);
  const auto values = values_at(points, wavy);
  const std::vector<Eigen::Vector2d> line = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  for (const ScatteredMethod method :
       {ScatteredMethod::linear, ScatteredMethod::natural_neighbour})
    EXPECT_TRUE(std::isnan(surface_by(method, points, values).at({1.1, 0.5})));
  for (const ScatteredMethod method :
       {ScatteredMethod::linear, ScatteredMethod::natural_neighbour,
        ScatteredMethod::minimum_curvature}) {
    EXPECT_NE(refusal_of(line, {method}).find("aren't all in one line"),
              std::string::npos);
    EXPECT_NE(refusal_of({{1, 1}}, {method}), "");
  }
  for (const ScatteredMethod method :
       {ScatteredMethod::nearest, ScatteredMethod::inverse_distance}) {
    EXPECT_EQ(surface_by(method, line, {1, 1, 1, 1}).at({5, 0}), 1);
    EXPECT_EQ(surface_by(method, {{1, 1}}, {7}).at({5, 0}), 7);
  }
  EXPECT_EQ(refusal_of({}, {ScatteredMethod::nearest}), "a surface needs points");
  EXPECT_NE(refusal_of(points, {ScatteredMethod::inverse_distance, 0}), "");
  EXPECT_NE(refusal_of(points, {ScatteredMethod::inverse_distance, 2, 0}), "");
  EXPECT_NE(refusal_of(scattered(3000), {ScatteredMethod::minimum_curvature})
                .find("at most 3000 places, not 3004"),
            std::string::npos);
}

/// One place twice is one with the mean, or blind where one of them is.
TEST(Scattered, TakesPointsAtOnePlaceForOne) {
  const std::vector<Eigen::Vector2d> points = {{5, 0}, {0, 0}, {0, 0}, {0, 3}};
  for (const ScatteredMethod method : kEvery) {
    EXPECT_NEAR(surface_by(method, points, {7, 1, 3, 4}).at({0, 0}), 2, 1e-12);
    EXPECT_EQ(surface_by(method, points, {7, 1, kInf, 4}).at({0, 0}), kInf);
  }
  const auto surface = surface_by(ScatteredMethod::nearest, points, {7, 1, 3, 4});
  EXPECT_EQ(surface.nearest({1, 1}), 1u) << "the first of those there";
  EXPECT_EQ(surface.nearest({4, 0}), 0u);
  EXPECT_EQ(surface.nearest({0, 2}), 3u);
}

}  // namespace
}  // namespace delos
