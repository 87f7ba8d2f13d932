// Faces in a room that devices can stick to.
#pragma once

#include <optional>
#include <string>

#include "session/loaded_scene.h"

namespace delos::session {

/// A place on a face, and which way it faces.
struct Contact {
  Eigen::Vector3d p;       ///< world, metres
  Eigen::Vector3d normal;  ///< unit, to the free side
};

/// What stands still in a room as triangles that face its free side: bodies that hide,
/// surfaces, and the walls of the box around the samples and all devices but one.
class Faces {
 public:
  /// @param but the device that is to stick
  Faces(const LoadedScene& loaded, const std::string& but);

  /// The nearest place of them all, where it is no farther than `within`, metres.
  /// @cost n log n in the triangles
  [[nodiscard]] std::optional<Contact> nearest(const Eigen::Vector3d& p,
                                               double within) const;
  /// Where a ray first meets a face from its free side.
  /// @pre along isn't 0 @cost linear in the triangles
  [[nodiscard]] std::optional<Contact> first(const Eigen::Vector3d& from,
                                             const Eigen::Vector3d& along) const;

 private:
  void add(const TriangleMesh& mesh, bool inside_free);

  TriangleMesh mesh_;  ///< world
};

/// The orientation that has its z axis along a direction and is turned to it by the
/// least angle. @param z unit
[[nodiscard]] Eigen::Matrix3d turned_to(const Eigen::Matrix3d& R,
                                        const Eigen::Vector3d& z);

}  // namespace delos::session
