// What the filter estimates: which pose coordinates, how many derivatives, what else.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "delos/api.h"

namespace delos {

/// Largest state: six pose coordinates with two derivatives, and twelve biases.
/// Fixed so that a solve never touches the heap.
inline constexpr int kMaxState = 30;

/// Most pose coordinates: [δp, δθ].
inline constexpr int kMaxCoordinates = 6;

/// Square matrix over the state, n×n with n ≤ kMaxState, stored inline.
using StateMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic,
                                  Eigen::ColMajor, kMaxState, kMaxState>;
/// Vector over the state, n×1, stored inline.
using StateVector =
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxState, 1>;
/// Square matrix over the pose coordinates, d×d with d ≤ 6, stored inline.
using CoordinateMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                  kMaxCoordinates, kMaxCoordinates>;
/// Vector over the pose coordinates, d×1, stored inline.
using CoordinateVector =
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxCoordinates, 1>;

/// True where both have the same size and the same numbers. Eigen's own == aborts where
/// sizes differ.
template <class Matrix>
[[nodiscard]] bool same_matrix(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

/// Which coordinates of the target's pose are estimated.
///
/// Position is p_WT in metres. Orientation is the small rotation δθ about the *world's*
/// axes that turns the true orientation into the estimate, R_WT ← exp(δθ) R_WT,
/// radians.
enum class PoseState {
  position,     ///< δp: x, y, z
  orientation,  ///< δθ: roll, pitch, yaw
  pose,         ///< [δp, δθ]
  planar,       ///< x, y: nothing moves the target out of its level plane, or turns it
  planar_pose,  ///< x, y, yaw: likewise, but it turns about the world's z
  none,         ///< none of them: custom motion of something else
};

/// The coordinates of a pose by their numbers, x 0 to yaw 5.
inline constexpr int kPoseCoordinates[] = {0, 1, 2, 3, 4, 5};
inline constexpr int kPlanarCoordinates[] = {0, 1, 5};

/// Which coordinates of a pose a state has, in its order.
[[nodiscard]] constexpr std::span<const int> estimated(PoseState pose) {
  const std::span<const int> all(kPoseCoordinates), planar(kPlanarCoordinates);
  switch (pose) {
    case PoseState::position:
      return all.first(3);
    case PoseState::orientation:
      return all.last(3);
    case PoseState::pose:
      return all;
    case PoseState::planar:
      return planar.first(2);
    case PoseState::planar_pose:
      return planar;
    case PoseState::none:
      break;
  }
  return {};
}

/// How the state vector is laid out: order blocks of d pose coordinates (pose,
/// velocity, acceleration), then the extra states (biases).
struct StateLayout {
  PoseState pose = PoseState::position;
  int order = 1;                   ///< 1, 2 or 3 blocks: pose, velocity, acceleration
  std::vector<std::string> extra;  ///< names of the states behind the blocks
  std::vector<std::string> extra_units = {};  ///< theirs, SI; where missing, "1"

  /// d, the number of pose coordinates: 3 or 6, in a plane 2 or 3, or 0.
  [[nodiscard]] int coordinates() const {
    return static_cast<int>(estimated(pose).size());
  }
  /// n, the size of the state.
  [[nodiscard]] int size() const {
    return coordinates() * order + static_cast<int>(extra.size());
  }
  /// Number of position coordinates, which come first: 3, 2 in a plane, or 0.
  [[nodiscard]] int positions() const {
    int count = 0;
    for (const int coordinate : estimated(pose)) count += coordinate < 3;
    return count;
  }
  /// Number of orientation coordinates: 3, 1 in a plane, or 0.
  [[nodiscard]] int turns() const { return coordinates() - positions(); }
  /// Size of the position block, or of the orientation block where that is all.
  [[nodiscard]] int block() const { return positions() > 0 ? positions() : turns(); }

  /// Names in the order of the state vector: x, y, z, roll, pitch, yaw, vx, …, vyaw,
  /// ax, …, ayaw, those that are estimated, then the extra states.
  [[nodiscard]] DELOS_API std::vector<std::string> names() const;
  /// SI units in the same order: m, rad, m/s, rad/s, m/s^2, rad/s^2; then the extra
  /// ones'.
  [[nodiscard]] DELOS_API std::vector<std::string> units() const;

  friend bool operator==(const StateLayout&, const StateLayout&) = default;
};

/// Some states that stand side by side.
struct StateBlock {
  int first = 0, size = 0;
  friend bool operator==(const StateBlock&, const StateBlock&) = default;
};

}  // namespace delos
