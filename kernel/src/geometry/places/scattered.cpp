#include "delos/geometry/scattered.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/natural_neighbor_coordinates_2.h>

#include <Eigen/LU>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace delos {
namespace {

using PlaneKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ValueAt = CGAL::Triangulation_vertex_base_with_info_2<double, PlaneKernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<PlaneKernel,
                                   CGAL::Triangulation_data_structure_2<ValueAt>>;

constexpr std::size_t kMostPlatePoints = 3000;
constexpr double kOutside = std::numeric_limits<double>::quiet_NaN();

/// r² log r, of whose sums the thin plate is made: its double Laplacian is 8π δ.
double plate(double square) { return square > 0 ? square * std::log(square) / 2 : 0; }

PlaneKernel::Point_2 plane_point(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

}  // namespace

struct ScatteredSurface::State {
  ScatteredMethod method;
  std::vector<Eigen::Vector2d> points;
  std::vector<double> values;
  Delaunay triangles;
  Eigen::VectorXd plate_weights;  // of the points, then of 1, x, y
  double scale = 1;               // lengths are divided by it, and begin at
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();

  /// Solves [K T; Tᵀ 0] (w, c) = (v, 0) with T = (1, x, y).
  void bend_plate() {
    if (points.size() > kMostPlatePoints)
      throw std::invalid_argument("a plate of minimum curvature is of at most " +
                                  std::to_string(kMostPlatePoints) + " places");
    for (const Eigen::Vector2d& p : points)
      middle += p / static_cast<double>(points.size());
    scale = 0;
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Eigen::Vector2d& p : points) {
      scale = std::max(scale, (p - middle).norm());
      spread += (p - middle) * (p - middle).transpose();
    }
    // In one line the plane 1, x, y through the points isn't one alone.
    if (!(spread.determinant() > 1e-12 * spread.trace() * spread.trace()))
      throw std::invalid_argument(
          "a plate of minimum curvature needs points that aren't all in one line");
    const auto n = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n + 3, n + 3);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 3);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Vector2d p = scaled(points[static_cast<std::size_t>(i)]);
      for (Eigen::Index j = 0; j < i; ++j)
        M(i, j) = M(j, i) =
            plate((p - scaled(points[static_cast<std::size_t>(j)])).squaredNorm());
      M.row(i).tail<3>() << 1, p.x(), p.y();
      M.col(i).tail<3>() = M.row(i).tail<3>().transpose();
      right(i) = values[static_cast<std::size_t>(i)];
    }
    plate_weights = M.partialPivLu().solve(right);
  }

  [[nodiscard]] Eigen::Vector2d scaled(const Eigen::Vector2d& p) const {
    return (p - middle) / scale;
  }

  [[nodiscard]] double on_plate(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d p = scaled(place);
    const auto n = static_cast<Eigen::Index>(points.size());
    double sum = plate_weights(n) + plate_weights.tail<2>().dot(p);
    for (Eigen::Index i = 0; i < n; ++i)
      sum += plate_weights(i) *
             plate((p - scaled(points[static_cast<std::size_t>(i)])).squaredNorm());
    return sum;
  }

  [[nodiscard]] double by_distances(const Eigen::Vector2d& place) const {
    double sum = 0, weights = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double square = (points[i] - place).squaredNorm();
      if (square == 0) return values[i];
      sum += values[i] / square;
      weights += 1 / square;
    }
    return sum / weights;
  }

  /// Weights by area in the triangle that holds the place.
  [[nodiscard]] double in_triangle(const Eigen::Vector2d& place) const {
    if (triangles.dimension() < 2) return kOutside;
    const auto face = triangles.locate(plane_point(place));
    if (triangles.is_infinite(face)) return kOutside;
    Eigen::Matrix3d corners;
    Eigen::Vector3d at;
    for (int i = 0; i < 3; ++i) {
      const auto& p = face->vertex(i)->point();
      corners.col(i) << p.x(), p.y(), 1;
      at(i) = face->vertex(i)->info();
    }
    return at.dot(
        corners.partialPivLu().solve(Eigen::Vector3d(place.x(), place.y(), 1)));
  }

  [[nodiscard]] double by_neighbours(const Eigen::Vector2d& place) const {
    if (triangles.dimension() < 2) return kOutside;
    std::vector<std::pair<Delaunay::Vertex_handle, double>> weights;
    const auto found = CGAL::natural_neighbor_coordinates_2(
        triangles, plane_point(place), std::back_inserter(weights),
        CGAL::Identity<std::pair<Delaunay::Vertex_handle, double>>());
    if (!found.third) return kOutside;
    double sum = 0;
    for (const auto& [vertex, weight] : weights) sum += weight * vertex->info();
    return sum / found.second;
  }
};

ScatteredSurface::ScatteredSurface(const std::vector<Eigen::Vector2d>& points,
                                   const std::vector<double>& values,
                                   ScatteredMethod method)
    : state_(std::make_unique<State>()) {
  if (points.empty()) throw std::invalid_argument("a surface needs points");
  std::map<std::pair<double, double>, std::pair<double, double>> sums;
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto& [sum, count] = sums[{points[i].x(), points[i].y()}];
    sum += values[i];
    ++count;
  }
  state_->method = method;
  for (const auto& [place, of] : sums) {
    state_->points.emplace_back(place.first, place.second);
    state_->values.push_back(of.first / of.second);
  }
  if (method == ScatteredMethod::minimum_curvature) {
    state_->bend_plate();
    return;
  }
  for (std::size_t i = 0; i < state_->points.size(); ++i)
    state_->triangles.insert(plane_point(state_->points[i]))->info() =
        state_->values[i];
}

ScatteredSurface::~ScatteredSurface() = default;
ScatteredSurface::ScatteredSurface(ScatteredSurface&&) noexcept = default;
ScatteredSurface& ScatteredSurface::operator=(ScatteredSurface&&) noexcept = default;

double ScatteredSurface::at(const Eigen::Vector2d& place) const {
  switch (state_->method) {
    case ScatteredMethod::nearest:
      return state_->triangles.nearest_vertex(plane_point(place))->info();
    case ScatteredMethod::linear:
      return state_->in_triangle(place);
    case ScatteredMethod::natural_neighbour:
      return state_->by_neighbours(place);
    case ScatteredMethod::inverse_distance:
      return state_->by_distances(place);
    case ScatteredMethod::minimum_curvature:
      return state_->on_plate(place);
  }
  return kOutside;
}

}  // namespace delos
