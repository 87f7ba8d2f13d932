// One rig of cameras, and how each program would write it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "imports/calibration.h"

namespace delos::test {

/// A camera by OpenCV's conventions: p_C = R p_W + t, metres, pixels.
struct TrueCamera {
  Eigen::Vector2d f, c, size;
  std::array<double, 8> k{};  ///< k1 k2 p1 p2 k3 k4 k5 k6
  bool fisheye = false;       ///< k1 … k4 are the first four of k
  Eigen::Matrix3d R;
  Eigen::Vector3d t;

  /// Pixels of a point in the world, by the formulas of OpenCV's manual.
  [[nodiscard]] Eigen::Vector2d image(const Eigen::Vector3d& p_W) const;
};

/// Three cameras around (0, 0, 1), z up.
/// @param coefficients how many of k aren't 0, at most
[[nodiscard]] std::vector<TrueCamera> true_rig(int coefficients, bool fisheye = false);

/// What a program would write of a rig.
struct WrittenRig {
  std::string format;
  /// The file that is imported first, then others beside it: names and bytes.
  std::vector<std::pair<std::string, std::string>> files;
  imports::ImportOptions options;
  std::vector<TrueCamera> truth;
  /// X_SW: the world of the truth in the scene.
  Pose X_SW;
  bool placed = true;  ///< false: a camera without a place
};

[[nodiscard]] std::vector<WrittenRig> written_rigs();

}  // namespace delos::test
