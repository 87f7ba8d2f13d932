// Devices in pictures and maps.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace delos {

struct Scene;
struct System;

/// A device as a picture shows it.
struct Marker {
  std::string name;
  Eigen::Vector3d p;                     ///< world, metres
  std::optional<Eigen::Vector3d> faces;  ///< where it looks; nullopt: all around
};

/// The devices that stand in the world. Those that are placed without a direction look
/// all around.
[[nodiscard]] std::vector<Marker> markers_of(const Scene& scene, const System& system);

}  // namespace delos
