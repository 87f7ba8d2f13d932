// Surfaces over scattered points: a value at every place of a plane.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "delos/api.h"

namespace delos {

/// How values in between come about. All return the samples at the samples.
enum class ScatteredMethod {
  nearest,            ///< that of the nearest point
  linear,             ///< planes over Delaunay's triangles
  natural_neighbour,  ///< weights by what a cell there would take of the others' cells
  inverse_distance,   ///< Σ w v / Σ w, w falls with the distance
  minimum_curvature,  ///< the thin plate through the samples, ∫ (Δv)² least
};

inline constexpr std::array<ScatteredMethod, 5> kScatteredMethods{
    ScatteredMethod::natural_neighbour, ScatteredMethod::linear,
    ScatteredMethod::nearest, ScatteredMethod::inverse_distance,
    ScatteredMethod::minimum_curvature};

/// "nearest", "linear", "natural-neighbour", "inverse-distance", "minimum-curvature".
[[nodiscard]] DELOS_API const char* to_string(ScatteredMethod method);

struct ScatteredOptions {
  ScatteredMethod method = ScatteredMethod::natural_neighbour;
  /// Of inverse distance: w = ((r − d)₊ / (r d))ᵖ, which is 1/dᵖ where no radius r is
  /// given, and has no edge where one is.
  double power = 2;                                         ///< p > 0
  double radius = std::numeric_limits<double>::infinity();  ///< r > 0, metres
};

/// A surface through values at points of a plane. Points at one place are taken for one
/// with their mean value.
///
/// A point whose value isn't finite is blind, and so is what is nearer to it than to
/// any other point, by every method; the rest is interpolated between points that have
/// a value. Where one of several points at one place is blind, the place is.
///
/// Sources: Shepard (1968), Proc. ACM '68, 517–524 (inverse distance); Franke, Nielson
/// (1980), Int. J. Numer. Methods Eng. 15, 1691–1704 (its radius); Sibson (1981), A
/// brief description of natural neighbour interpolation; Duchon (1977), LNM 571, 85–100
/// (thin plates, which Briggs (1974), Geophysics 39, 39–48, solves on a grid).
class DELOS_API ScatteredSurface {
 public:
  /// @param points metres, finite; values one a point
  /// @throws std::invalid_argument one sentence: no points; power or radius aren't
  /// positive; linear, natural_neighbour and minimum_curvature: all points in one line;
  /// minimum_curvature: more than 3000 places; inverse_distance: more than 50,000
  ScatteredSurface(const std::vector<Eigen::Vector2d>& points,
                   const std::vector<double>& values, const ScatteredOptions& options);
  ~ScatteredSurface();
  ScatteredSurface(ScatteredSurface&&) noexcept;
  ScatteredSurface& operator=(ScatteredSurface&&) noexcept;

  /// @returns +∞ where it is blind, and where linear, natural_neighbour and
  /// minimum_curvature have no three points with a value to go by; NaN where the method
  /// says nothing: linear and natural_neighbour outside the points' convex hull,
  /// inverse_distance farther than the radius from all points
  [[nodiscard]] double at(const Eigen::Vector2d& place) const;

  /// @returns the index of the nearest point; of several at its place, the first
  [[nodiscard]] std::size_t nearest(const Eigen::Vector2d& place) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delos
