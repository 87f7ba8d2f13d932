// A surface through samples that have no grid: points, paths, vertices of meshes.
#pragma once

#include "delos/geometry/scattered.h"
#include "session/drawn_field.h"

namespace delos::session {

/// How samples become a surface.
struct Through {
  ScatteredOptions how;
  int axis = 2;               ///< 0, 1, 2: over the plane across x, y, z
  std::size_t most = 10'000;  ///< places of the grid that it is made on, about
  /// By how much the place of the greatest value is lifted above that of the least,
  /// along the axis, metres; 0: the surface goes through the samples' own places.
  double relief = 0;
};

/// The surface through all samples of points, paths and meshes: a part "surface", whose
/// vertices are the places of a grid at which the method says something, and a part
/// "samples", those it goes through. How far along the axis a place lies is
/// interpolated as the value is. What is nearest to a sample without a value has none,
/// as ScatteredSurface says; where there is a relief, it stands where the worst value
/// would.
///
/// The summary is that of the samples, with
///
///     through: {method, over: x, y or z, grid: [·, ·], samples, places, blind, min,
///     max}
///
/// where the surface's own range may go beyond the samples' (minimum curvature), and is
/// null where it has no value.
/// @throws Refusal of the question: there are no such samples; they are in one line as
///         seen along the axis; the metric is a count, of which there is nothing
///         between, and the method isn't nearest; the
///         method says nothing anywhere; as ScatteredSurface
[[nodiscard]] DrawnField surface_through(const DrawnField& drawn,
                                         const Through& through);

}  // namespace delos::session
