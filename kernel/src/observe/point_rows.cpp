#include "observe/point_rows.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "delos/model/lanes.h"
#include "observe/answers.h"

namespace delos {
namespace {

using Vectors = double[3][kLanes];

/// arm = R_WT·marker, from the target's origin to the marker, in W.
void fill_arms(std::span<const TargetPose> poses, const Eigen::Vector3d& marker,
               Vectors& arm) {
  for (std::size_t l = 0; l < poses.size(); ++l) {
    const Eigen::Vector3d a = poses[l].R * marker;
    for (int i = 0; i < 3; ++i) arm[i][l] = a(i);
  }
}

/// p_S = R_SW (p_WT + arm − p_WS).
void fill_points(const Pose& X_WS, std::span<const TargetPose> poses,
                 const Vectors& arm, PointLanes& points) {
  Vectors from_sensor = {};
  for (std::size_t l = 0; l < poses.size(); ++l) {
    for (int i = 0; i < 3; ++i) from_sensor[i][l] = poses[l].p(i) - X_WS.p(i);
  }
  points.count = static_cast<int>(poses.size());
  for (int i = 0; i < 3; ++i) {
    const double x = X_WS.R(0, i), y = X_WS.R(1, i), z = X_WS.R(2, i);
    for (int l = 0; l < kLanes; ++l) {
      points.p[i][l] = x * (from_sensor[0][l] + arm[0][l]) +
                       y * (from_sensor[1][l] + arm[1][l]) +
                       z * (from_sensor[2][l] + arm[2][l]);
    }
  }
}

/// One row over the pose coordinates: H_W = H_S R_SW, and arm × H_W for δθ, because a
/// small turn δθ about the world's axes moves the point by δθ × arm.
void turn_row(const Pose& X_WS, const Vectors& H, const double* seen,
              const Vectors& arm, const StateLayout& layout,
              double (&row)[kMaxCoordinates][kLanes]) {
  Vectors w;
  for (int i = 0; i < 3; ++i) {
    const double x = X_WS.R(i, 0), y = X_WS.R(i, 1), z = X_WS.R(i, 2);
    for (int l = 0; l < kLanes; ++l) {
      const double turned = H[0][l] * x + H[1][l] * y + H[2][l] * z;
      w[i][l] = seen[l] > 0 ? turned : 0.0;
    }
  }
  if (layout.pose != PoseState::orientation) {
    for (int i = 0; i < 3; ++i) std::copy_n(w[i], kLanes, row[i]);
  }
  if (layout.pose == PoseState::position) return;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    double* turn = row[layout.positions() + i];
    for (int l = 0; l < kLanes; ++l) {
      turn[l] = arm[j][l] * w[k][l] - arm[k][l] * w[j][l];
    }
  }
}

std::uint64_t bits(const double* flags, int count) {
  std::uint64_t word = 0;
  for (int l = 0; l < count; ++l) word |= std::uint64_t{flags[l] > 0} << l;
  return word;
}

/// 1/r where the row is seen and has noise.
/// @returns the lanes where it is seen and has none
std::uint64_t fill_weights(const double* variance, const double* seen, int count,
                           double* weight) {
  double perfect[kLanes];
  for (int l = 0; l < kLanes; ++l) {
    const bool noisy = variance[l] >= std::numeric_limits<double>::min();
    const double inverse = noisy ? 1 / variance[l] : 0.0;
    weight[l] = seen[l] > 0 ? inverse : 0.0;
    perfect[l] = noisy ? 0.0 : seen[l];
  }
  return bits(perfect, count);
}

/// Lanes in view whose marker something hides.
void look(const System& system, const PlacedDevice& placed,
          std::span<const TargetPose> poses, const Vectors& arm, const Sight* sight,
          PointRows& out) {
  for (std::uint64_t left = out.in_view; left != 0; left &= left - 1) {
    const auto l = static_cast<std::size_t>(std::countr_zero(left));
    bool clear = sight && sight[l] == Sight::clear;
    if (!sight || sight[l] == Sight::unknown) {
      ++out.rays;
      clear =
          in_sight(system, placed.X_WS.p, poses[l], {arm[0][l], arm[1][l], arm[2][l]});
    }
    if (!clear) out.hidden |= std::uint64_t{1} << l;
  }
}

}  // namespace

bool observe_rows(const System& system, const PlacedDevice& placed,
                  const Eigen::Vector3d& marker, std::span<const TargetPose> poses,
                  const Sight* sight, PointRows& out) {
  if (placed.beacons || placed.device->span() != Span::point) return false;
  PointLanes points;
  RowLanes rows;
  Vectors arm = {};
  if (!marker.isZero(0)) fill_arms(poses, marker, arm);
  fill_points(placed.X_WS, poses, arm, points);
  if (!ask(placed,
           [&](const Device& device) { return device.observe_lanes(points, rows); }))
    return false;
  check_rows(placed, rows);
  out.rows = rows.rows;
  out.in_view = bits(rows.seen, points.count);
  out.hidden = out.perfect = out.rays = 0;
  for (int r = 0; r < rows.rows; ++r) {
    turn_row(placed.X_WS, rows.H[r], rows.seen, arm, system.motion.layout, out.h[r]);
    const std::uint64_t perfect =
        fill_weights(rows.variance[r], rows.seen, points.count, out.weight[r]);
    for (std::uint64_t left = perfect; left != 0; left &= left - 1)
      check_perfect(placed, rows.variance[r][std::countr_zero(left)]);
    out.perfect |= perfect;
  }
  if (may_be_hidden(system, placed)) look(system, placed, poses, arm, sight, out);
  return true;
}

void add_information(const PointRows& rows, int columns, std::uint64_t lanes,
                     double* layer) {
  for (int r = 0; r < rows.rows; ++r) {
    double masked[kLanes];
    const double* weight = rows.weight[r];
    if ((rows.in_view & ~lanes) != 0) {
      for (int l = 0; l < kLanes; ++l) {
        masked[l] = (lanes >> l & 1) != 0 ? rows.weight[r][l] : 0.0;
      }
      weight = masked;
    }
    for (int i = 0; i < columns; ++i) {
      double scaled[kLanes];
      for (int l = 0; l < kLanes; ++l) scaled[l] = weight[l] * rows.h[r][i][l];
      for (int j = 0; j <= i; ++j) {
        double* s = layer + packed_index(i, j) * kLanes;
        for (int l = 0; l < kLanes; ++l) s[l] += scaled[l] * rows.h[r][j][l];
      }
    }
  }
}

}  // namespace delos
