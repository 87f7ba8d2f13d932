// How what a device observes moves with the target's pose.
//
// A device at X_WS observes a point of the target, which is an arm from the target's
// origin, in W. Where the target moves by δp and turns by δθ about the world's axes,
//
//     p_S = R_SW (p_WT + arm − p_WS),   δp_S = R_SW (δp + δθ × arm)
//
// so that a row h over p_S becomes one over the coordinates of the pose:
//
//     [g, arm × g],   g = h R_SW
//
// of which a state has those that it estimates: all, or in a plane x, y and yaw.
//
// A device on the target sees a beacon of the world, at an arm from the target's
// origin, move the other way: g = −h R_SW.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "delos/model/pose.h"
#include "delos/model/state.h"

namespace delos {

// Of up to `lanes` of them side by side, entry i of the l-th at [i·lanes + l]; one of
// them is a plain vector or row. Inlined always: in the loops of beacons, and where
// compilers then see that arrays are apart.

/// What turn() does with results: nothing.
struct AsTheyAre {
  double operator()(int, double value) const { return value; }
};

/// out = R v, and so with R = R_WS the row v R_SW.
/// @param out apart from v
/// @param result result(l, x) stands in the place of each number x of the l-th
/// @param count how many of the lanes
template <int lanes, class Result = AsTheyAre>
[[gnu::always_inline]] inline void turn(const Eigen::Matrix3d& R, const double* v,
                                        double* out, Result&& result = {},
                                        int count = lanes) {
  for (int i = 0; i < 3; ++i) {
    const double x = R(i, 0), y = R(i, 1), z = R(i, 2);
    for (int l = 0; l < count; ++l)
      out[i * lanes + l] =
          result(l, x * v[l] + y * v[lanes + l] + z * v[2 * lanes + l]);
  }
}

/// A row over the pose coordinates, in W, of one over an observed point.
/// @param R_WS −R_WS for beacons
/// @param h over the point, in S
/// @param arm in W, metres
/// @param result of g, see turn()
template <int lanes, class Result = AsTheyAre>
[[gnu::always_inline]] inline void pull_row(const StateLayout& layout,
                                            const Eigen::Matrix3d& R_WS,
                                            const double* h, const double* arm,
                                            double* row, Result&& result = {},
                                            int count = lanes) {
  const bool whole =
      layout.pose == PoseState::position || layout.pose == PoseState::pose;
  double apart[3 * lanes];
  double* const g = whole ? row : apart;
  turn<lanes>(R_WS, h, g, result, count);
  const auto cross = [&](int i, double* of_turn) {  // (arm × g)_i
    const int j = (i + 1) % 3 * lanes, k = (i + 2) % 3 * lanes;
    for (int l = 0; l < count; ++l)
      of_turn[l] = arm[j + l] * g[k + l] - arm[k + l] * g[j + l];
  };
  switch (layout.pose) {
    case PoseState::pose:
      row += 3 * lanes;
      [[fallthrough]];
    case PoseState::orientation:
      for (int i = 0; i < 3; ++i) cross(i, row + i * lanes);
      break;
    case PoseState::planar_pose:
      cross(2, row + 2 * lanes);
      [[fallthrough]];
    case PoseState::planar:
      std::copy_n(g, 2 * lanes, row);
      break;
    case PoseState::position:
    case PoseState::none:
      break;
  }
}

/// Where a device at X_WS sees a point of a target: p_S above.
inline Eigen::Vector3d seen_at(const Pose& X_WS, const Eigen::Vector3d& p_WT,
                               const Eigen::Vector3d& arm) {
  const Eigen::Vector3d from_device = p_WT - X_WS.p + arm;
  Eigen::Vector3d p;
  turn<1>(X_WS.R.transpose(), from_device.data(), p.data());
  return p;
}

}  // namespace delos
