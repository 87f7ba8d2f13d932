#include "observe/point_rows.h"

#include <algorithm>
#include <bit>

#include "delos/model/lanes.h"
#include "delos/model/wide.h"
#include "observe/answers.h"
#include "observe/lever.h"
#include "observe/shared_noise.h"
#include "observe/whiten.h"

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

/// Where the device sees the points.
void fill_points(const Pose& X_WS, std::span<const TargetPose> poses,
                 const Vectors& arm, PointLanes& points) {
  Vectors from_device;
  for (int i = 0; i < 3; ++i) {
    for (std::size_t l = 0; l < poses.size(); ++l)
      from_device[i][l] = poses[l].p(i) - X_WS.p(i) + arm[i][l];
    std::fill(from_device[i] + poses.size(), from_device[i] + kLanes, 0.0);
  }
  points.count = static_cast<int>(poses.size());
  turn<kLanes>(X_WS.R.transpose(), from_device[0], points.p[0]);
}

std::uint64_t bits(const double* flags, int count) {
  std::uint64_t word = 0;
  for (int l = 0; l < count; ++l) word |= std::uint64_t{flags[l] > 0} << l;
  return word;
}

/// 1/r where the row is seen and has noise.
/// @param noise a factor of r
/// @returns the lanes where it is seen and has none
std::uint64_t fill_weights(const double* variance, double noise, const double* seen,
                           int count, double* weight) {
  double perfect[kLanes];
  for (int l = 0; l < kLanes; ++l) {
    const bool noisy = is_noise(variance[l]);
    const double inverse = noisy ? 1 / (noise * variance[l]) : 0.0;
    weight[l] = seen[l] > 0 ? inverse : 0.0;
    perfect[l] = noisy ? 0.0 : seen[l];
  }
  return bits(perfect, count);
}

/// Lanes in view whose marker something hides.
void look(const System& system, const PlacedDevice& placed, const PlacedMarker& marker,
          std::span<const TargetPose> poses, const Sight* sight, PointRows& out) {
  for (std::uint64_t left = out.in_view; left != 0; left &= left - 1) {
    const auto l = static_cast<std::size_t>(std::countr_zero(left));
    bool clear = sight && sight[l] == Sight::clear;
    if (!sight || sight[l] == Sight::unknown) {
      ++out.rays;
      clear = in_sight(system, placed, poses[l], marker);
    }
    if (!clear) out.hidden |= std::uint64_t{1} << l;
  }
}

/// What is read without sight, of variance r + σ² and p of the time: of the weight
/// p/(r + σ²).
void weaken_rows(const PlacedDevice& placed, PointRows& out) {
  const WithoutSight& without = placed.without_sight;
  const double more = placed.noise * without.sigma * without.sigma;
  for (std::uint64_t left = out.hidden; left != 0; left &= left - 1) {
    const int l = std::countr_zero(left);
    for (int r = 0; r < out.rows; ++r) {
      double& weight = out.weight[r][l];
      const double variance = (weight > 0 ? 1 / weight : 0) + more;
      weight = variance > 0 ? without.probability / variance : 0;
    }
  }
  if (more > 0) out.perfect &= ~out.hidden;
  out.hidden = 0;
}

/// What a device answers of one marker at up to kLanes poses.
/// @returns false where it has no entry for many points, or sees beacons
bool ask_lanes(const PlacedDevice& placed, const PlacedMarker& marker,
               std::span<const TargetPose> poses, Vectors& arm, PointLanes& points,
               RowLanes& rows) {
  if (placed.carried() || placed.device->span() != Span::point) return false;
  if (!marker.p.isZero(0)) fill_arms(poses, marker.p, arm);
  fill_points(placed.X_WS(), poses, arm, points);
  if (!ask(placed,
           [&](const Device& device) { return device.observe_lanes(points, rows); }))
    return false;
  check_rows(placed, rows);
  return true;
}

}  // namespace

bool points_in_view(const PlacedDevice& placed, const PlacedMarker& marker,
                    std::span<const TargetPose> poses, std::uint64_t& in_view) {
  PointLanes points;
  RowLanes rows;
  Vectors arm = {};
  if (!ask_lanes(placed, marker, poses, arm, points, rows)) return false;
  in_view = bits(rows.seen, points.count);
  for (int r = 0; r < rows.rows; ++r)
    for (std::uint64_t left = in_view; left != 0; left &= left - 1)
      check_perfect(placed, rows.variance[r][std::countr_zero(left)]);
  return true;
}

bool observe_rows(const System& system, const PlacedDevice& placed,
                  const PlacedMarker& marker, std::span<const TargetPose> poses,
                  const Sight* sight, PointRows& out) {
  PointLanes points;
  RowLanes rows;
  Vectors arm = {};
  if (placed.clock || placed.own.size > 0) return false;  // more columns
  if (shares_noise(placed)) return false;                 // with other markers
  if (!ask_lanes(placed, marker, poses, arm, points, rows)) return false;
  out.rows = rows.rows;
  out.in_view = bits(rows.seen, points.count);
  out.hidden = out.perfect = out.rays = 0;
  // Where nothing is seen, any number may stand.
  const auto if_seen = [&](int l, double x) { return rows.seen[l] > 0 ? x : 0.0; };
  std::uint64_t perfect[kMaxLaneRows];
  in_wide_vectors([&] {
    for (int r = 0; r < rows.rows; ++r) {
      pull_row<kLanes>(system.motion.layout, placed.X_WS().R, rows.H[r][0], arm[0],
                       out.h[r][0], if_seen);
      perfect[r] = fill_weights(rows.variance[r], placed.noise, rows.seen, points.count,
                                out.weight[r]);
    }
  });
  for (int r = 0; r < rows.rows; ++r) {
    for (std::uint64_t left = perfect[r]; left != 0; left &= left - 1)
      check_perfect(placed, rows.variance[r][std::countr_zero(left)]);
    out.perfect |= perfect[r];
  }
  if (may_be_hidden(system, placed)) look(system, placed, marker, poses, sight, out);
  if (placed.without_sight.arrives()) weaken_rows(placed, out);
  return true;
}

namespace {

/// layer += hᵀh weight, row by row.
void add_rows(const PointRows& rows, int columns, std::uint64_t lanes, double* layer) {
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

}  // namespace

void add_information(const PointRows& rows, int columns, std::uint64_t lanes,
                     double* layer) {
  in_wide_vectors([&] { add_rows(rows, columns, lanes, layer); });
}

}  // namespace delos
