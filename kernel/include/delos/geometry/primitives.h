// Simple bodies as meshes: closed, facing outward.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "delos/api.h"
#include "delos/geometry/mesh.h"

namespace delos {

/// A box along the axes, 12 triangles.
/// @param min, max opposite corners, metres; @pre min < max in every axis
[[nodiscard]] DELOS_API TriangleMesh make_box(const Eigen::Vector3d& min,
                                              const Eigen::Vector3d& max);

/// A prism about the z axis over a regular polygon, from z = 0 to z = height. The
/// corners lie on the circle, so that it is inside the true cylinder; its flat sides
/// fall short of it by radius·(1 − cos(π/sides)).
/// @param radius, height metres, > 0; @param sides ≥ 3
[[nodiscard]] DELOS_API TriangleMesh make_cylinder(double radius, double height,
                                                   int sides = 32);

/// A sphere about the origin: an icosahedron, each triangle split in four
/// `subdivisions` times, 20·4ᵏ triangles. The corners lie on the sphere. It is convex.
/// @param radius metres, > 0; @param subdivisions 0 to 9
[[nodiscard]] DELOS_API TriangleMesh make_sphere(double radius, int subdivisions = 3);

/// A prism from z = 0 to z = height over a polygon in the xy plane.
/// @param polygon corners in order, either way round, metres; may be non-convex; the
/// last
///        is joined to the first and isn't repeated
/// @param height metres, > 0
/// @throws std::invalid_argument with one sentence: fewer than three corners, a corner
///         that isn't finite, or edges that touch or cross each other
[[nodiscard]] DELOS_API TriangleMesh
extrude(const std::vector<Eigen::Vector2d>& polygon, double height);

}  // namespace delos
