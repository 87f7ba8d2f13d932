// Paths of targets in files.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <vector>

#include "delos/api.h"
#include "delos/document/diagnostic.h"

namespace delos {

/// One row of a path: when, and where in W.
struct PathRow {
  double t;           ///< seconds
  Eigen::Vector3d p;  ///< metres
};

/// Read a path: rows t,x,y,z of a .csv (or .ptl) as point files have them.
/// @returns two rows or more whose times rise; nullopt with findings where the file
///          isn't readable, a row is malformed, or times don't rise
[[nodiscard]] DELOS_API std::optional<std::vector<PathRow>> load_path(
    const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace delos
