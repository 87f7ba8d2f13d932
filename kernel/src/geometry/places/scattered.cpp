#include "delos/geometry/scattered.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/natural_neighbor_coordinates_2.h>

#include <Eigen/LU>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "delos/model/infinity.h"
#include "geometry/places/thin_plate.h"

namespace delos {
namespace {

using PlaneKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using IndexAt = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, PlaneKernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<PlaneKernel,
                                   CGAL::Triangulation_data_structure_2<IndexAt>>;

/// What is weighed at every place.
constexpr std::size_t kMostWeighed = 50'000;
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

PlaneKernel::Point_2 plane_point(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

/// Points of different places, what their values are, and their triangles.
struct Net {
  std::vector<Eigen::Vector2d> points;
  std::vector<double> values;
  std::vector<std::size_t> first;  ///< of those that were given, at each place
  Delaunay triangles;

  void add(const Eigen::Vector2d& p, double value, std::size_t index) {
    triangles.insert(plane_point(p))->info() = points.size();
    points.push_back(p);
    values.push_back(value);
    first.push_back(index);
  }

  [[nodiscard]] std::size_t nearest(const Eigen::Vector2d& place) const {
    return triangles.nearest_vertex(plane_point(place))->info();
  }

  [[nodiscard]] bool holds(const Eigen::Vector2d& place) const {
    if (triangles.dimension() < 2) return false;
    Delaunay::Locate_type where;
    int corner;
    triangles.locate(plane_point(place), where, corner);
    return where != Delaunay::OUTSIDE_CONVEX_HULL;
  }

  /// Weights by area in the triangle that holds the place.
  /// @pre holds(place)
  [[nodiscard]] double linear(const Eigen::Vector2d& place) const {
    Delaunay::Locate_type where;
    int corner;
    auto face = triangles.locate(plane_point(place), where, corner);
    // On the hull's edge the outer face may be found.
    for (int i = 0; triangles.is_infinite(face); ++i)
      if (face->vertex(i) == triangles.infinite_vertex()) face = face->neighbor(i);
    Eigen::Matrix3d corners;
    Eigen::Vector3d at;
    for (int i = 0; i < 3; ++i) {
      const std::size_t index = face->vertex(i)->info();
      corners.col(i) << points[index] - place, 1;
      at(i) = values[index];
    }
    return at.dot(corners.partialPivLu().solve(Eigen::Vector3d::UnitZ()));
  }

  /// @pre holds(place)
  [[nodiscard]] double natural(const Eigen::Vector2d& place) const {
    std::vector<std::pair<Delaunay::Vertex_handle, double>> weights;
    const auto found = CGAL::natural_neighbor_coordinates_2(
        triangles, plane_point(place), std::back_inserter(weights),
        CGAL::Identity<std::pair<Delaunay::Vertex_handle, double>>());
    double sum = 0;
    for (const auto& [vertex, weight] : weights) sum += weight * values[vertex->info()];
    return sum / found.second;
  }

  [[nodiscard]] double by_distances(const Eigen::Vector2d& place, double power,
                                    double radius) const {
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double d = (points[i] - place).norm();
      if (d == 0) return values[i];
      if (d >= radius) continue;
      const double base = std::isinf(radius) ? 1 / d : (radius - d) / (radius * d);
      const double w = power == 2 ? base * base : std::pow(base, power);
      sum += w * values[i];
      weights += w;
    }
    return weights > 0 ? sum / weights : kNothing;
  }
};

void check(const std::vector<Eigen::Vector2d>& points, const ScatteredOptions& how) {
  if (points.empty()) throw std::invalid_argument("a surface needs points");
  if (!(how.power > 0) || !(how.radius > 0))
    throw std::invalid_argument("power and radius of inverse-distance are above 0");
  if (how.method == ScatteredMethod::inverse_distance && points.size() > kMostWeighed)
    throw std::invalid_argument("inverse-distance goes through at most " +
                                std::to_string(kMostWeighed) +
                                " places; natural-neighbour takes any number");
  const bool of_planes = how.method != ScatteredMethod::nearest &&
                         how.method != ScatteredMethod::inverse_distance;
  if (of_planes && in_one_line(points))
    throw std::invalid_argument(std::string(to_string(how.method)) +
                                " needs points that aren't all in one line; nearest "
                                "and inverse-distance don't");
}

}  // namespace

const char* to_string(ScatteredMethod method) {
  switch (method) {
    case ScatteredMethod::nearest:
      return "nearest";
    case ScatteredMethod::linear:
      return "linear";
    case ScatteredMethod::natural_neighbour:
      return "natural-neighbour";
    case ScatteredMethod::inverse_distance:
      return "inverse-distance";
    case ScatteredMethod::minimum_curvature:
      return "minimum-curvature";
  }
  return "";
}

struct ScatteredSurface::State {
  ScatteredOptions how;
  Net all;
  Net seen;  ///< those that have a value
  std::optional<ThinPlate> plate;

  [[nodiscard]] double value(const Eigen::Vector2d& place) const {
    switch (how.method) {
      case ScatteredMethod::nearest:
        return seen.values[seen.nearest(place)];
      case ScatteredMethod::linear:
        return seen.holds(place) ? seen.linear(place) : beyond(place);
      case ScatteredMethod::natural_neighbour:
        return seen.holds(place) ? seen.natural(place) : beyond(place);
      case ScatteredMethod::inverse_distance:
        return seen.by_distances(place, how.power, how.radius);
      case ScatteredMethod::minimum_curvature:
        return plate ? plate->at(place) : kInfinity;
    }
    return kNothing;
  }

  /// Between points that see and blind ones it is blind; outside of both, unknown.
  [[nodiscard]] double beyond(const Eigen::Vector2d& place) const {
    return all.holds(place) ? kInfinity : kNothing;
  }
};

ScatteredSurface::ScatteredSurface(const std::vector<Eigen::Vector2d>& points,
                                   const std::vector<double>& values,
                                   const ScatteredOptions& options)
    : state_(std::make_unique<State>()) {
  check(points, options);
  struct Place {
    double sum = 0;
    std::size_t count = 0, first = 0;
  };
  std::map<std::pair<double, double>, Place> places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Place& place = places[{points[i].x(), points[i].y()}];
    if (place.count++ == 0) place.first = i;
    place.sum += values[i];
  }
  state_->how = options;
  for (const auto& [at, place] : places) {
    const Eigen::Vector2d p(at.first, at.second);
    const double mean = place.sum / static_cast<double>(place.count);
    state_->all.add(p, mean, place.first);
    if (std::isfinite(mean)) state_->seen.add(p, mean, place.first);
  }
  if (options.method == ScatteredMethod::minimum_curvature &&
      !in_one_line(state_->seen.points))
    state_->plate.emplace(state_->seen.points, state_->seen.values);
}

ScatteredSurface::~ScatteredSurface() = default;
ScatteredSurface::ScatteredSurface(ScatteredSurface&&) noexcept = default;
ScatteredSurface& ScatteredSurface::operator=(ScatteredSurface&&) noexcept = default;

double ScatteredSurface::at(const Eigen::Vector2d& place) const {
  if (!std::isfinite(state_->all.values[state_->all.nearest(place)])) {
    // What linear and natural neighbours don't reach isn't known to be blind.
    const bool reaches = state_->how.method != ScatteredMethod::linear &&
                         state_->how.method != ScatteredMethod::natural_neighbour;
    return reaches ? kInfinity : state_->beyond(place);
  }
  return state_->value(place);
}

std::size_t ScatteredSurface::nearest(const Eigen::Vector2d& place) const {
  return state_->all.first[state_->all.nearest(place)];
}

}  // namespace delos
