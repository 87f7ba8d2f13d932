// Surfaces over scattered points: a value at every place of a plane.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "delos/api.h"

namespace delos {

/// How values in between come about. All return the samples at the samples.
enum class ScatteredMethod {
  nearest,            ///< that of the nearest point
  linear,             ///< planes over Delaunay's triangles
  natural_neighbour,  ///< weights by what a cell there would take of the others' cells
  inverse_distance,   ///< Σ w v / Σ w, w = 1/d²
  minimum_curvature,  ///< the thin plate through the samples, ∫ (Δv)² least
};

/// A surface through values at points of a plane. Points at one place are taken for one
/// with their mean value.
/// Sources: Shepard (1968), Proc. ACM '68, 517–524 (inverse distance); Sibson (1981),
/// A brief description of natural neighbour interpolation; Duchon (1977), LNM 571,
/// 85–100 (thin plates).
class DELOS_API ScatteredSurface {
 public:
  /// @param points metres; values one a point, finite
  /// @throws std::invalid_argument no points; minimum_curvature: of more than 3000
  /// places, or all in one line
  ScatteredSurface(const std::vector<Eigen::Vector2d>& points,
                   const std::vector<double>& values, ScatteredMethod method);
  ~ScatteredSurface();
  ScatteredSurface(ScatteredSurface&&) noexcept;
  ScatteredSurface& operator=(ScatteredSurface&&) noexcept;

  /// @returns NaN outside the points' convex hull, where linear and natural_neighbour
  /// know nothing
  [[nodiscard]] double at(const Eigen::Vector2d& place) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delos
