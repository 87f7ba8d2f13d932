// From a device's own frame to rows over the state: frames and lever arms.
#pragma once

#include <Eigen/Core>
#include <utility>

#include "delos/rig/system.h"
#include "observe/answers.h"
#include "observe/beacon_sightings.h"
#include "observe/whiten.h"
#include "rig/sight.h"

namespace delos {

/// What is reused from one observation to the next, so that no loop allocates.
struct MeasureScratch {
  Target target;
  Observation observation;
  StateRows rows;
  BeaconSightings sightings;
};

/// Turn three columns that are a gradient in S into one in W: H_W = H_S R_SW.
inline void turn(const Observation& o, int from, const Eigen::Matrix3d& R_SW, int to,
                 StateRows& rows) {
  for (Eigen::Index i = 0; i < o.H.rows(); ++i) {
    rows.block<1, 3>(i, to).noalias() = o.H.block<1, 3>(i, from) * R_SW;
  }
}

/// observe(), checked.
/// @throws DeviceFault
inline bool observe_target(const PlacedDevice& placed, Eigen::Index columns,
                           const Target& target, Observation& out) {
  if (!ask(placed, [&](const Device& device) { return device.observe(target, out); }))
    return false;
  check_answer(placed, out, columns);
  return true;
}

/// Visit every sighting of a beacon that is used: its share makes its noise larger.
template <class Visit>
bool measure_beacons(const System& system, const PlacedDevice& placed,
                     const TargetPose& X_WT, int columns, MeasureScratch& scratch,
                     Visit&& visit) {
  const int d = system.motion.layout.coordinates();
  see_beacons(system, placed, X_WT, scratch.sightings);
  for (const BeaconSighting& s : scratch.sightings.all) {
    if (s.share == 0) continue;
    scratch.rows.setZero(s.rows, columns);
    scratch.observation.R.setZero(s.rows, s.rows);
    for (Eigen::Index i = 0; i < s.rows; ++i) {
      const SightingRow& row = scratch.sightings.rows[s.first_row + i];
      scratch.rows.row(i).head(d) = Eigen::Map<const Eigen::RowVectorXd>(row.h, d);
      scratch.observation.R(i, i) = row.variance / s.share;
    }
    visit(scratch.rows, scratch.observation.R);
  }
  return !scratch.sightings.all.empty();
}

/// Visit every observation that a device makes of a target at X_WT: `visit(rows, R)`
/// with rows m×c over the pose coordinates (or the whole state) and R m×m.
/// @returns whether the device sees any of the target.
template <class Visit>
bool measure(const System& system, const PlacedDevice& placed, const TargetPose& X_WT,
             int columns, MeasureScratch& scratch, Visit&& visit) {
  if (placed.beacons) {
    return measure_beacons(system, placed, X_WT, columns, scratch,
                           std::forward<Visit>(visit));
  }
  const StateLayout& layout = system.motion.layout;
  const int d = layout.coordinates();
  const bool position = layout.pose != PoseState::orientation;
  const bool orientation = layout.pose != PoseState::position;
  const int theta = layout.positions();  // column of δθ
  const Eigen::Matrix3d R_SW = placed.X_WS.R.transpose();
  const bool may_hide = may_be_hidden(system, placed);
  Target& target = scratch.target;
  Observation& o = scratch.observation;

  switch (placed.device->span()) {
    case Span::point: {
      bool seen = false;
      for (const Eigen::Vector3d& marker : system.markers) {
        const Eigen::Vector3d arm = X_WT.R * marker;  // in W, from the target's origin
        target.p_ST.noalias() = R_SW * (X_WT.p + arm - placed.X_WS.p);
        if (!observe_target(placed, 3, target, o)) continue;
        if (may_hide && !in_sight(system, placed.X_WS.p, X_WT, arm)) continue;
        seen = true;
        scratch.rows.resize(o.H.rows(), columns);
        if (position) turn(o, 0, R_SW, 0, scratch.rows);
        if (columns > d) scratch.rows.rightCols(columns - d).setZero();
        if (orientation) {
          // A small turn δθ about the world's axes moves the point by δθ × arm.
          const Eigen::Matrix3d lever = -R_SW * cross_matrix(arm);
          scratch.rows.middleCols<3>(theta).noalias() = o.H.middleCols<3>(0) * lever;
        }
        visit(scratch.rows, o.R);
      }
      return seen;
    }
    case Span::pose:
    case Span::motion: {
      target.p_ST.noalias() = R_SW * (X_WT.p - placed.X_WS.p);
      target.R_ST.noalias() = R_SW * X_WT.R;
      const bool pose = placed.device->span() == Span::pose;
      if (!observe_target(placed, pose ? 6 : 18, target, o)) return false;
      if (may_hide && !in_sight(system, placed.X_WS.p, X_WT, {0, 0, 0})) return false;
      scratch.rows.setZero(o.H.rows(), columns);
      const int orders = pose ? 1 : layout.order;
      for (int k = 0; k < orders; ++k) {
        if (position) turn(o, 6 * k, R_SW, d * k, scratch.rows);
        if (orientation) turn(o, 6 * k + 3, R_SW, d * k + theta, scratch.rows);
      }
      visit(scratch.rows, o.R);
      return true;
    }
    case Span::state: {
      target.p_ST.noalias() = R_SW * (X_WT.p - placed.X_WS.p);
      target.R_ST.noalias() = R_SW * X_WT.R;
      target.state.setZero(layout.size());
      if (!observe_target(placed, layout.size(), target, o)) return false;
      if (may_hide && !in_sight(system, placed.X_WS.p, X_WT, {0, 0, 0})) return false;
      scratch.rows = o.H;
      visit(scratch.rows, o.R);
      return true;
    }
  }
  return false;
}

}  // namespace delos
