// Surfaces through samples without a grid: where they lie, and what they never claim.
#include "session/surface_through.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "designs.h"
#include "session/refusal.h"

namespace delos::session {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// σ over points of a plane: 2 + x + 3 y, blind where it is below 0.
DrawnField points_over(const std::vector<Eigen::Vector3d>& points) {
  Field field;
  field.metric = "rms";
  field.unit = "m";
  field.samples.points = points;
  for (const Eigen::Vector3d& p : points) {
    const double value = 2 + p.x() + 3 * p.y();
    field.value.push_back(value > 0 ? value : kInf);
    field.observable.push_back(value > 0);
    field.lost.push_back(0);
  }
  field.samples.parts = {{"", 0, points.size(), ScatteredShape{}}};
  return drawn_over(std::move(field));
}

const std::vector<Eigen::Vector3d> kTilted = {
    {0, 0, 1}, {4, 0, 3}, {4, 2, 3}, {0, 2, 1}, {1, 1, 1.5}};  // z = 1 + x/2

struct Parts {
  const SamplePart& surface;
  const SamplePart& samples;
  const SurfaceShape& shape;
};
Parts parts_of(const DrawnField& drawn) {
  const auto& parts = drawn.field.samples.parts;
  EXPECT_EQ(parts.size(), 2u);
  return {parts.at(0), parts.at(1), std::get<SurfaceShape>(parts.at(0).shape)};
}

double area_of(const DrawnField& drawn) {
  double area = 0;
  for (const auto& t : parts_of(drawn).shape.triangles) {
    const auto& p = drawn.field.samples.points;
    area += (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm() / 2;
  }
  return area;
}

/// Over a plane that the points lie in, linear values come out exactly, at places of
/// that plane, to the points' own edge.
TEST(SurfaceThrough, LiesInThePointsPlaneAndHasItsValues) {
  for (const ScatteredMethod method :
       {ScatteredMethod::linear, ScatteredMethod::natural_neighbour,
        ScatteredMethod::minimum_curvature}) {
    const DrawnField drawn = surface_through(points_over(kTilted), {{method}});
    const auto [surface, samples, shape] = parts_of(drawn);
    EXPECT_GT(surface.count, 9000u);
    for (std::size_t i = 0; i < surface.count; ++i) {
      const Eigen::Vector3d& p = drawn.field.samples.points[i];
      EXPECT_EQ(drawn.mask[i], Drawn::value);
      EXPECT_NEAR(p.z(), 1 + p.x() / 2, 1e-10) << to_string(method);
      EXPECT_NEAR(drawn.field.value[i], 2 + p.x() + 3 * p.y(), 1e-10);
    }
    EXPECT_NEAR(area_of(drawn), 8 * std::sqrt(1.25), 1e-9);
    for (std::size_t k = 0; k < kTilted.size(); ++k)
      EXPECT_EQ(drawn.field.samples.points[samples.first + k], kTilted[k]);
    const Json& of = drawn.summary["through"];
    EXPECT_EQ(of["method"], to_string(method));
    EXPECT_EQ(of["over"], "z");
    EXPECT_EQ(of["samples"], 5);
    EXPECT_NEAR(of["min"], 2, 1e-10);
    EXPECT_NEAR(of["max"], 12, 1e-10);
    EXPECT_EQ(of["blind"], 0);
    EXPECT_EQ(drawn.summary["max"]["value"], 12) << "the samples' own";
  }
}

TEST(SurfaceThrough, RisesByItsRelief) {
  Through through{{ScatteredMethod::linear}};
  through.relief = 0.5;
  const DrawnField drawn = surface_through(points_over(kTilted), through);
  for (std::size_t i = 0; i < drawn.field.value.size(); ++i) {
    const Eigen::Vector3d& p = drawn.field.samples.points[i];
    EXPECT_NEAR(p.z(), 1 + p.x() / 2 + 0.05 * (drawn.field.value[i] - 2), 1e-10);
  }
}

/// Seen along x, the points' y and z are its plane.
TEST(SurfaceThrough, GoesOverAnyAxis) {
  Through through{{ScatteredMethod::linear}};
  through.axis = 0;
  const DrawnField drawn = surface_through(points_over(kTilted), through);
  for (std::size_t i = 0; i < parts_of(drawn).surface.count; ++i) {
    const Eigen::Vector3d& p = drawn.field.samples.points[i];
    EXPECT_NEAR(p.x(), 2 * (p.z() - 1), 1e-9);
  }
  through.axis = 1;
  std::vector<Eigen::Vector3d> level = kTilted;
  for (Eigen::Vector3d& p : level) p.z() = 1;
  try {
    surface_through(points_over(level), through);
    FAIL() << "a line is no surface";
  } catch (const Refusal& refusal) {
    EXPECT_NE(
        std::string(refusal.what()).find("seen along y all samples are in one line"),
        std::string::npos);
  }
}

/// What is nearest to a blind sample is blind, and stands where the worst would.
TEST(SurfaceThrough, NeverDrawsBlindAsGood) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) points.emplace_back(i, j, 0);
  DrawnField of = points_over(points);
  of.field.value[12] = kInf;  // (2, 2)
  of.mask[12] = Drawn::blind;
  of.field.value[6] = 3;  // (1, 1) is within a solid
  of.mask[6] = Drawn::inside;
  for (const ScatteredMethod method : kScatteredMethods) {
    Through through{{method}};
    through.relief = 1;
    const DrawnField drawn = surface_through(of, through);
    std::size_t blind = 0;
    for (std::size_t i = 0; i < parts_of(drawn).surface.count; ++i) {
      const Eigen::Vector2d p = drawn.field.samples.points[i].head<2>();
      const auto cell = [&](double x, double y, double half) {
        return (p - Eigen::Vector2d(x, y)).cwiseAbs().maxCoeff() < half;
      };
      if (cell(2, 2, 0.499)) {
        EXPECT_EQ(drawn.mask[i], Drawn::blind) << to_string(method);
        EXPECT_EQ(drawn.field.samples.points[i].z(), 1);
        ++blind;
      } else if (cell(1, 1, 0.499)) {
        EXPECT_EQ(drawn.mask[i], Drawn::inside) << to_string(method);
      } else if (!cell(2, 2, 0.501) && !cell(1, 1, 0.501)) {
        EXPECT_EQ(drawn.mask[i], Drawn::value) << to_string(method);
      }
    }
    // 25 by 25 places, 4 cm apart.
    EXPECT_EQ(blind, 625u);
    EXPECT_GE(drawn.summary["through"]["blind"], blind);
  }
}

/// Where nothing is known there is no surface: a triangle leaves
/// half of its box free.
TEST(SurfaceThrough, EndsWhereTheMethodSaysNothing) {
  const DrawnField of = points_over({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
  const DrawnField drawn = surface_through(of, {{ScatteredMethod::linear}});
  EXPECT_NEAR(area_of(drawn), 2, 0.05);
  EXPECT_NEAR(area_of(surface_through(of, {{ScatteredMethod::nearest}})), 4, 1e-9);
  Through near{{ScatteredMethod::inverse_distance, 2, 0.3}};
  const double discs = area_of(surface_through(of, near));  // three quarters of π r²
  EXPECT_NEAR(discs, 0.75 * 3.14159265 * 0.09, 0.03);
  near.how.radius = 1e-3;
  EXPECT_THROW(surface_through(of, near), Refusal);
}

TEST(SurfaceThrough, RefusesWhatItCantBe) {
  const Design grid = design_of("01-acoustic");
  EXPECT_THROW(surface_through(draw_field(grid.loaded(), 500, {}), {}), Refusal);
  DrawnField counts = points_over(kTilted);
  counts.field.metric = "coverage";
  EXPECT_THROW(surface_through(counts, {}), Refusal);
  EXPECT_NO_THROW(surface_through(counts, {{ScatteredMethod::nearest}}));
}

/// The torso's 1730 vertices: the same bytes of any number of threads.
TEST(SurfaceThrough, IsTheSameOfAnyNumberOfThreads) {
  const Design design = design_of("07-torso");
  const auto bytes = [&](int threads) {
    FieldOptions options;
    options.threads = threads;
    DrawnField drawn = draw_field(design.loaded(), 0, options);
    drawn.summary.erase("seconds");
    drawn.summary.erase("threads");
    Through through{{ScatteredMethod::natural_neighbour}};
    through.axis = 1;
    return packed(surface_through(drawn, through), 1);
  };
  EXPECT_EQ(bytes(1), bytes(3));
}

}  // namespace
}  // namespace delos::session
