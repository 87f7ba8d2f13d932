#include "observe/soft_information.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "observe/answers.h"
#include "rig/parts.h"
#include "rig/sight.h"

namespace delos {
namespace {

/// A shadow's soft edge is this part of a view's, as an angle: shadows are small.
constexpr double kShadowPart = 1.0 / 3;
/// Clearance isn't measured in this part of a sight line at either end, where a wall
/// that carries the device, or the body that carries the marker, is always near.
constexpr double kEndPart = 0.05;

/// A visibility below this counts as none, and spares looking along the line.
constexpr double kUnseen = 1e-10;

using Lever = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor, 3, kMaxState>;

/// δp of the marker = J · (the pose's coordinates), 3×c, in W.
Lever lever(const StateLayout& layout, const Eigen::Vector3d& arm, int columns) {
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
  Lever J = Lever::Zero(3, columns);
  for (int i = 0; i < 3; ++i)
    pull_row<1>(layout, I, I.col(i).data(), arm.data(), J.row(i).data());
  return J;
}

/// Σ hᵀ h / r over the rows, 3×3, in S.
Eigen::Matrix3d information(const SmoothRows& rows) {
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (int i = 0; i < rows.rows; ++i)
    S += rows.H.row(i).transpose() * rows.H.row(i) / rows.variance(i);
  return S;
}

/// ∂⟨K, Σ hᵀ h / r⟩/∂p for a symmetric K.
Eigen::Vector3d information_slope(const SmoothRows& rows, const Eigen::Matrix3d& K) {
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  for (int i = 0; i < rows.rows; ++i) {
    const Eigen::RowVector3d h = rows.H.row(i);
    const double r = rows.variance(i), form = h * K * h.transpose();
    for (int k = 0; k < 3; ++k) {
      const double along = h * K * rows.H_slope[k].row(i).transpose();
      slope(k) += (2 * along - form * rows.variance_slope(i, k) / r) / r;
    }
  }
  return slope;
}

}  // namespace

SoftOccluders::SoftOccluders(const System& system)
    : entries(system.occluders),
      in_world(placed_bodies(system.occluders, Mount::world)),
      on_target(placed_bodies(system.occluders, Mount::target)) {}

SoftInformation::SoftInformation(const System& system, const SoftOccluders& occluders,
                                 double width)
    : system_(system),
      occluders_(occluders),
      width_(width),
      unseen_margin_(-std::log(kUnseen) * width / 4),
      columns_(information_size(system)) {}

double SoftInformation::view(double margin) const {
  if (width_ == 0) return margin >= 0 ? 1 : 0;
  const double v = 1 / (1 + std::exp(-4 * margin / width_));
  return v < kUnseen ? 0 : v;
}

/// What view() would say, without asking for rows: a ball of the radius s d about a
/// point at the distance d fills the angle asin s.
bool SoftInformation::out_of_view(const Device& device,
                                  const Eigen::Vector3d& p) const {
  return device.view_of_ball(p, unseen_margin_ * p.norm()) == View::outside;
}

// Of a cone of the half-angle α, β off its axis, n, the margin is that of a view:
//
//   m = sin(α − β), of at most a right angle,  cos β = n·w/|w|,  ∂β/∂w = −(n − cos β
//   w/|w|)/(|w| sin β)
//
// w is the way from the marker to the device.
Sightline SoftInformation::facing(const PlacedDevice& placed, const TargetPose& X_WT,
                                  const PlacedMarker& marker) const {
  if (marker.faces_all_ways()) return {1, Eigen::Vector3d::Zero()};
  const Eigen::Vector3d way = placed.X_WS().p - X_WT * marker.p,
                        normal = X_WT.R * marker.normal;
  const double distance = way.norm(), along = normal.dot(way) / distance,
               aside = normal.cross(way).norm() / distance;
  const double off = std::clamp(marker.half_angle - std::atan2(aside, along),
                                -std::numbers::pi / 2, std::numbers::pi / 2);
  const double v = view(std::sin(off));
  if (width_ == 0 || aside == 0) return {v, Eigen::Vector3d::Zero()};
  const Eigen::Vector3d turn = (normal - along / distance * way) / (distance * aside);
  return {v, 4 / width_ * v * (1 - v) * std::cos(off) * turn};
}

Sightline SoftInformation::sightline(const PlacedDevice& placed, const TargetPose& X_WT,
                                     const PlacedMarker& marker) const {
  if (!may_be_hidden(system_, placed)) return {1, Eigen::Vector3d::Zero()};
  Sightline line = facing(placed, X_WT, marker);
  const Eigen::Vector3d arm = X_WT.R * marker.p;
  if (line.visibility == 0 || !in_sight(system_, placed.X_WS().p, X_WT, arm))
    return {0, Eigen::Vector3d::Zero()};
  if (width_ == 0) return line;

  const Eigen::Vector3d device = placed.X_WS().p, place = X_WT.p + arm;
  const double length = (place - device).norm();
  const double limit = kShadowPart * width_ * length;
  const auto soften = [&](const Clearance& bodies, const Pose& X_BW) {
    if (bodies.empty()) return;
    const Eigen::Vector3d a = X_BW * device, d = X_BW * place - a;
    const Passage at = bodies.passage(a + kEndPart * d, a + (1 - kEndPart) * d, limit);
    if (!(at.distance < limit)) return;
    // x = distance/limit, and both change with the device.
    const double x = at.distance / limit;
    const double part = kEndPart + (1 - 2 * kEndPart) * at.part;
    const Eigen::Vector3d away = X_BW.R.transpose() * at.away;
    const Eigen::Vector3d x_slope =
        (1 - part) / limit * away + x / (length * length) * (place - device);
    const double v = x * x * (3 - 2 * x);
    line.slope = v * line.slope + line.visibility * 6 * x * (1 - x) * x_slope;
    line.visibility *= v;
  };
  soften(occluders_.in_world, {});
  soften(occluders_.on_target, X_WT.inverse());
  return line;
}

bool SoftInformation::has_slopes(const PlacedDevice& placed) const {
  SmoothRows rows;
  return !placed.carried() && !placed.clock && placed.own.size == 0 &&
         placed.looks_from_origin() && placed.device->span() == Span::point &&
         !shares_noise(placed) && !reads_without_sight(system_, placed) &&
         observe_smoothly(placed, {0.1, 0.2, 1.0}, rows);
}

template <class Visit>
std::optional<double> SoftInformation::measure_smoothly(const PlacedDevice& placed,
                                                        const TargetPose& X_WT,
                                                        Sightline* lines, StateRow& row,
                                                        Visit&& visit) const {
  if (placed.carried() || placed.own.size > 0 || !placed.looks_from_origin() ||
      placed.device->span() != Span::point || shares_noise(placed) ||
      reads_without_sight(system_, placed))
    return std::nullopt;
  row.h.setZero(columns_);
  if (placed.clock) row.h(*placed.clock) = 1;
  double unseen = 1;
  SmoothRows rows;
  for (std::size_t m = 0; m < system_.markers.size(); ++m) {
    const Eigen::Vector3d arm = X_WT.R * system_.markers[m].p;
    const Eigen::Vector3d p = seen_at(placed.X_WS(), X_WT.p, arm);
    Sightline& line = lines[m];
    if (line.visibility == 0 || p.isZero(0)) continue;
    if (out_of_view(*placed.device, p)) {
      line.visibility = 0;
      continue;
    }
    if (!observe_smoothly(placed, p, rows)) return std::nullopt;
    const double v = view(rows.margin);
    if (v > 0 && line.visibility < 0)
      line = sightline(placed, X_WT, system_.markers[m]);
    row.share = v * line.visibility;
    if (row.share == 0) continue;
    unseen *= 1 - row.share;
    for (int i = 0; i < rows.rows; ++i) {
      const Eigen::Vector3d h = rows.H.row(i).transpose();
      pull_row<1>(system_.motion.layout, placed.X_WS().R, h.data(), arm.data(),
                  row.h.data());
      row.variance = placed.noise * rows.variance(i);
      visit(std::as_const(row));
    }
  }
  return 1 - unseen;
}

double SoftInformation::unseen_by_others(const PlacedDevice& placed,
                                         const TargetPose& X_WT, const Sightline* lines,
                                         std::size_t marker) const {
  double unseen = 1;
  SmoothRows rows;
  for (std::size_t m = 0; m < system_.markers.size(); ++m) {
    if (m == marker || !(lines[m].visibility > 0)) continue;
    const Eigen::Vector3d p =
        seen_at(placed.X_WS(), X_WT.p, X_WT.R * system_.markers[m].p);
    if (p.isZero(0) || !observe_smoothly(placed, p, rows)) continue;
    unseen *= 1 - view(rows.margin) * lines[m].visibility;
  }
  return unseen;
}

double SoftInformation::add(const PlacedDevice& placed, const TargetPose& X_WT,
                            double weight, Sightline* lines, MeasureScratch& scratch,
                            StateMatrix& S) const {
  const auto add_row = [&](const StateRow& row) {
    if (row.perfect()) return;
    const double all = weight * row.weight();
    for (int j = 0; j < columns_; ++j) {
      const double scaled = all * row.h(j);
      for (int i = 0; i < columns_; ++i) S(i, j) += scaled * row.h(i);
    }
  };
  if (const auto seen = measure_smoothly(placed, X_WT, lines, scratch.row, add_row))
    return *seen;
  return measure(system_, placed, X_WT, columns_, scratch, add_row) ? 1 : 0;
}

// With K = R_SW J G Jᵀ R_WS, J the lever, and p = R_SW (m − p_WS), m the marker:
//
//   ⟨G, S⟩ = v ⟨K, I(p)⟩,   I = Σ hᵀ h / r
//   δp_WS:  δp = −R_SW δp_WS
//   φ:      δp = −R_SW (φ × (m − p_WS)),  δ(R_WS I R_SW) = [φ]× I_W − I_W [φ]×
//
// What is seen of a marker changes both ⟨G, S⟩, by ⟨K, I⟩, and 1 − Π (1 − v), by the
// part that the other markers leave.
PoseSlope SoftInformation::slope(const PlacedDevice& placed, const TargetPose& X_WT,
                                 const Sightline* lines, const StateMatrix& G,
                                 double g) const {
  PoseSlope total = PoseSlope::Zero();
  const Eigen::Matrix3d R_WS = placed.X_WS().R;
  SmoothRows rows;
  for (std::size_t m = 0; m < system_.markers.size(); ++m) {
    const Sightline& line = lines[m];
    if (!(line.visibility > 0)) continue;
    const Eigen::Vector3d arm = X_WT.R * system_.markers[m].p;
    const Eigen::Vector3d from = X_WT.p + arm - placed.X_WS().p;
    const Eigen::Vector3d p = seen_at(placed.X_WS(), X_WT.p, arm);
    if (p.isZero(0) || !observe_smoothly(placed, p, rows)) continue;
    const double v = view(rows.margin);
    if (v == 0) continue;

    Eigen::Matrix3d G_point;
    if (system_.motion.layout.pose == PoseState::position) {
      G_point = G.topLeftCorner<3, 3>();
    } else {
      const Lever J = lever(system_.motion.layout, arm, columns_);
      G_point = J * G * J.transpose();
    }
    const Eigen::Matrix3d K = R_WS.transpose() * G_point * R_WS;
    const Eigen::Matrix3d I = information(rows);
    const double form = K.cwiseProduct(I).sum() +
                        (g != 0 ? g * unseen_by_others(placed, X_WT, lines, m) : 0);
    const double view_slope = width_ > 0 ? 4 / width_ * v * (1 - v) : 0;
    const Eigen::Vector3d by_p =
        line.visibility *
        (v * information_slope(rows, K) + view_slope * form * rows.margin_slope);
    const Eigen::Vector3d pull = R_WS * by_p;
    const Eigen::Matrix3d I_W = R_WS * I * R_WS.transpose();
    const Eigen::Matrix3d A = v * line.visibility * (I_W * G_point - G_point * I_W);
    total.head<3>() += -pull + v * form * line.slope;
    total.tail<3>() +=
        -from.cross(pull) +
        Eigen::Vector3d(A(1, 2) - A(2, 1), A(2, 0) - A(0, 2), A(0, 1) - A(1, 0));
  }
  return total / placed.noise;
}

}  // namespace delos
