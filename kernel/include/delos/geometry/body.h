// Solid bodies: boxes, cylinders, spheres, prisms and what stands in mesh files.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "delos/api.h"
#include "delos/geometry/mesh.h"

namespace delos {

/// A mesh in a file. Copies share what was read, and equal names and scales are equal:
/// within one scene a file is read once.
struct MeshShape {
  std::string file;  ///< as written, relative to the scene's folder; see read_mesh()
  double scale = 1;  ///< metres per unit of the file, > 0
  /// As it is in the file, in the file's unit. Never null in a loaded scene.
  std::shared_ptr<const TriangleMesh> mesh;
  friend bool operator==(const MeshShape& a, const MeshShape& b) {
    return a.file == b.file && a.scale == b.scale;
  }
};

/// Bodies in their own frame, metres.
struct BoxShape {  ///< along the axes, min < max
  Eigen::Vector3d min = Eigen::Vector3d::Zero(), max = Eigen::Vector3d::Zero();
  friend bool operator==(const BoxShape&, const BoxShape&) = default;
};
struct CylinderShape {  ///< about the z axis, from z = 0 up
  double radius = 0, height = 0;
  int sides = 32;
  friend bool operator==(const CylinderShape&, const CylinderShape&) = default;
};
struct SphereShape {  ///< about the origin
  double radius = 0;
  friend bool operator==(const SphereShape&, const SphereShape&) = default;
};
struct PrismShape {  ///< a polygon in the xy plane, from z = 0 up
  std::vector<Eigen::Vector2d> polygon;
  double height = 0;
  friend bool operator==(const PrismShape&, const PrismShape&) = default;
};
using Body = std::variant<BoxShape, CylinderShape, SphereShape, PrismShape, MeshShape>;

/// The body as triangles in its own frame, metres: scaled, not placed.
/// @pre the body came from a loaded scene, or would pass the loader's checks
[[nodiscard]] DELOS_API TriangleMesh body_mesh(const Body& body);

}  // namespace delos
