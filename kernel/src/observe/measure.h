// What any device measures of a target: rows over the state.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "delos/rig/system.h"
#include "observe/answers.h"
#include "observe/beacon_sightings.h"
#include "observe/lever.h"
#include "observe/shared_noise.h"
#include "observe/state_row.h"
#include "observe/whiten.h"
#include "rig/sight.h"

namespace delos {

/// What is reused from one observation to the next, so that no loop allocates.
struct MeasureScratch {
  Target target;
  Observation observation;
  StateRow row;
  bool hidden = false;         // what stands in the answer's way
  std::vector<StateRow> rows;  // that share a part of their noise
  BeaconSearch beacons;
};

/// observe(), checked.
/// @throws DeviceFault
inline bool observe_target(const PlacedDevice& placed, Eigen::Index columns,
                           const Target& target, Observation& out) {
  if (!ask(placed, [&](const Device& device) { return device.observe(target, out); }))
    return false;
  check_answer(placed, out, columns);
  return true;
}

/// Visit every row of every sighting of a beacon that is used.
template <class Visit>
bool measure_beacons(const System& system, const PlacedDevice& placed,
                     const TargetPose& X_WT, MeasureScratch& scratch, Visit&& visit) {
  const int d = system.motion.layout.coordinates();
  const BeaconSightings& sightings = scratch.beacons.see(system, placed, X_WT);
  StateRow& row = scratch.row;
  each_used_row(sightings, [&](const BeaconSighting& s, const SightingRow& r) {
    row.h.head(d) = Eigen::Map<const Eigen::RowVectorXd>(r.h, d);
    row.variance = r.variance;
    row.share = s.share;
    row.beacon = s.beacon;
    visit(std::as_const(row));
  });
  return !sightings.all.empty();
}

/// What a row says of the device's own states: its last columns.
template <class Row>
void set_own(const PlacedDevice& placed, const Row& row, StateRow& out) {
  if (placed.own.size > 0)
    out.h.segment(placed.own.first, placed.own.size) = row.tail(placed.own.size);
}

/// A reading without sight as those that are seen: with its noise, and how often it is
/// there.
inline void weaken(const WithoutSight& without, Observation& out, double& share) {
  share = without.probability;
  out.R.diagonal().array() += without.sigma * without.sigma;
}

/// Visit every marker that is read: `visit(arm)`, with the device's answer in the
/// scratch.
template <class Visit>
bool each_marker(const System& system, const PlacedDevice& placed,
                 const TargetPose& X_WT, MeasureScratch& scratch, Visit&& visit) {
  const bool may_hide = may_be_hidden(system, placed);
  bool seen = false;
  scratch.target.R_ST.setIdentity();  // of another device before
  scratch.target.own.setZero(placed.own.size);
  for (const PlacedMarker& marker : system.markers) {
    const Eigen::Vector3d arm = X_WT.R * marker.p;
    scratch.target.p_ST = seen_at(placed.X_WS(), X_WT.p, arm);
    if (!observe_target(placed, 3 + placed.own.size, scratch.target,
                        scratch.observation))
      continue;
    scratch.hidden = may_hide && !in_sight(system, placed, X_WT, marker);
    if (scratch.hidden && !placed.without_sight.arrives()) continue;
    scratch.row.share = 1;
    if (scratch.hidden)
      weaken(placed.without_sight, scratch.observation, scratch.row.share);
    seen = true;
    visit(arm);
  }
  return seen;
}

/// A row about a marker as one over the state.
template <class Row>
void fill_point_row(const System& system, const PlacedDevice& placed,
                    const Eigen::Vector3d& arm, const Row& in_S, double variance,
                    StateRow& out) {
  const Eigen::Vector3d h = in_S.template head<3>().transpose();
  pull_row<1>(system.motion.layout, placed.X_WS().R, h.data(), arm.data(),
              out.h.data());
  set_own(placed, in_S, out);
  out.variance = placed.noise * variance;
}

/// Visit every row about a marker in view.
template <class Visit>
bool measure_points(const System& system, const PlacedDevice& placed,
                    const TargetPose& X_WT, MeasureScratch& scratch, Visit&& visit) {
  const Observation& seen = scratch.observation;
  if (shares_noise(placed)) {
    scratch.rows.clear();
    const auto add = [&](const Eigen::Vector3d& arm) {
      for (Eigen::Index r = 0; r < seen.z.size(); ++r) {
        fill_point_row(system, placed, arm, seen.H.row(r), seen.R(r, r), scratch.row);
        scratch.rows.push_back(scratch.row);
      }
    };
    const bool any = each_marker(system, placed, X_WT, scratch, add);
    part_shared_noise(placed, static_cast<std::size_t>(seen.z.size()), scratch.rows);
    for (const StateRow& row : scratch.rows) visit(row);
    return any;
  }
  return each_marker(system, placed, X_WT, scratch, [&](const Eigen::Vector3d& arm) {
    whiten(seen.H, seen.R, [&](const auto& row, double variance) {
      fill_point_row(system, placed, arm, row, variance, scratch.row);
      visit(std::as_const(scratch.row));
    });
  });
}

/// A row over pose, velocity, …, [δp, δθ] each, in S, as one over the state.
/// @param arm of the point that it is about, from the target's origin, in W, metres
/// @param orders how many of them
template <class Row>
void fill_row(const StateLayout& layout, const Eigen::Matrix3d& R_WS,
              const Eigen::Vector3d& arm, int orders, const Row& in_S, StateRow& out) {
  double* to = out.h.data();
  for (int k = 0; k < orders; ++k) {
    double in_W[kMaxCoordinates];
    for (const int half : {0, 3}) {
      const Eigen::Vector3d h = in_S.template segment<3>(6 * k + half).transpose();
      turn<1>(R_WS, h.data(), in_W + half);
    }
    Eigen::Map<Eigen::Vector3d>(in_W + 3) +=
        arm.cross(Eigen::Map<const Eigen::Vector3d>(in_W));
    for (const int coordinate : estimated(layout.pose)) *to++ = in_W[coordinate];
  }
}

/// How a device that measures more than points stands.
struct MotionView {
  Pose X_WS;
  Eigen::Vector3d arm;  ///< of what it measures, from the target's origin, in W, metres
  int columns;          ///< of its span
};

/// Ask a device that measures more than points: of the target where it stands in the
/// world, of its own motion where the target carries it.
/// @returns nullopt where it sees nothing; else its answer is in the scratch
inline std::optional<MotionView> look_at_motion(const System& system,
                                                const PlacedDevice& placed,
                                                const TargetPose& X_WT,
                                                MeasureScratch& scratch) {
  const StateLayout& layout = system.motion.layout;
  const Span span = placed.device->span();
  const TargetMount* carried = placed.carried();
  MotionView view;
  view.X_WS = carried ? X_WT * carried->X_TS : placed.X_WS();
  view.arm = carried ? Eigen::Vector3d(view.X_WS.p - X_WT.p)
                     : Eigen::Vector3d(Eigen::Vector3d::Zero());
  Target& target = scratch.target;
  target.p_ST = carried ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                        : seen_at(view.X_WS, X_WT.p, Eigen::Vector3d::Zero());
  if (carried)
    target.R_ST.setIdentity();
  else
    target.R_ST.noalias() = view.X_WS.R.transpose() * X_WT.R;
  const int n = layout.size() - static_cast<int>(system.motion.own.size());
  target.state.setZero(span == Span::state ? n : 0);
  view.columns = span == Span::pose ? 6 : span == Span::motion ? 18 : n;
  target.own.setZero(placed.own.size);
  if (!observe_target(placed, view.columns + placed.own.size, target,
                      scratch.observation))
    return std::nullopt;
  if (!carried && may_be_hidden(system, placed) &&
      !in_sight(system, placed, X_WT, PlacedMarker()))
    return std::nullopt;
  return view;
}

/// A row over a span of more than points as one over the state.
template <class Row>
void fill_motion_row(const System& system, const PlacedDevice& placed,
                     const MotionView& view, const Row& in_S, double variance,
                     StateRow& out) {
  const Span span = placed.device->span();
  if (span == Span::state)
    out.h.head(view.columns) = in_S.head(view.columns);
  else
    fill_row(system.motion.layout, view.X_WS.R, view.arm,
             span == Span::motion ? system.motion.layout.order : 1, in_S, out);
  set_own(placed, in_S, out);
  out.variance = placed.noise * variance;
}

/// Visit every row of a device that measures more than points.
template <class Visit>
bool measure_motion(const System& system, const PlacedDevice& placed,
                    const TargetPose& X_WT, MeasureScratch& scratch, Visit&& visit) {
  const auto view = look_at_motion(system, placed, X_WT, scratch);
  if (!view) return false;
  whiten(scratch.observation.H, scratch.observation.R,
         [&](const auto& in_S, double variance) {
           fill_motion_row(system, placed, *view, in_S, variance, scratch.row);
           visit(std::as_const(scratch.row));
         });
  return true;
}

/// Visit every row that a device measures of a target at X_WT: `visit(const StateRow&)`
/// with `columns` columns, information_size().
/// @returns whether the device sees any of the target.
template <class Visit>
bool measure(const System& system, const PlacedDevice& placed, const TargetPose& X_WT,
             int columns, MeasureScratch& scratch, Visit&& visit) {
  StateRow& row = scratch.row;
  row.h.setZero(columns);
  if (placed.clock) row.h(*placed.clock) = 1;
  row.share = 1;
  if (placed.device->span() != Span::point)
    return measure_motion(system, placed, X_WT, scratch, visit);
  if (placed.carried()) return measure_beacons(system, placed, X_WT, scratch, visit);
  return measure_points(system, placed, X_WT, scratch, visit);
}

}  // namespace delos
