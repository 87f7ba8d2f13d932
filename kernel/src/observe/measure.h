// What any device measures of a target: rows over the state.
#pragma once

#include <Eigen/Core>
#include <utility>

#include "delos/rig/system.h"
#include "observe/answers.h"
#include "observe/beacon_sightings.h"
#include "observe/lever.h"
#include "observe/state_row.h"
#include "observe/whiten.h"
#include "rig/sight.h"

namespace delos {

/// What is reused from one observation to the next, so that no loop allocates.
struct MeasureScratch {
  Target target;
  Observation observation;
  StateRow row;
  BeaconSightings sightings;
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
  see_beacons(system, placed, X_WT, scratch.sightings);
  StateRow& row = scratch.row;
  each_used_row(scratch.sightings, [&](const BeaconSighting& s, const SightingRow& r) {
    row.h.head(d) = Eigen::Map<const Eigen::RowVectorXd>(r.h, d);
    row.variance = r.variance;
    row.share = s.share;
    row.beacon = s.beacon;
    visit(std::as_const(row));
  });
  return !scratch.sightings.all.empty();
}

/// Visit every row about a marker in view.
template <class Visit>
bool measure_points(const System& system, const PlacedDevice& placed,
                    const TargetPose& X_WT, MeasureScratch& scratch, Visit&& visit) {
  const bool may_hide = may_be_hidden(system, placed);
  bool seen = false;
  scratch.target.R_ST.setIdentity();  // of another device before
  for (const Eigen::Vector3d& marker : system.markers) {
    const Eigen::Vector3d arm = X_WT.R * marker;
    scratch.target.p_ST = seen_at(placed.X_WS(), X_WT.p, arm);
    if (!observe_target(placed, 3, scratch.target, scratch.observation)) continue;
    if (may_hide && !in_sight(system, placed.X_WS().p, X_WT, arm)) continue;
    seen = true;
    whiten(scratch.observation.H, scratch.observation.R,
           [&](const auto& row, double variance) {
             const Eigen::Vector3d h = row.transpose();
             pull_row<1>(system.motion.layout, placed.X_WS().R, h.data(), arm.data(),
                         scratch.row.h.data());
             scratch.row.variance = placed.noise * variance;
             visit(std::as_const(scratch.row));
           });
  }
  return seen;
}

/// A row over pose, velocity, …, [δp, δθ] each, in S, as one over the state.
/// @param orders how many of them
template <class Row>
void fill_row(const StateLayout& layout, const Eigen::Matrix3d& R_WS, int orders,
              const Row& in_S, StateRow& out) {
  double* to = out.h.data();
  for (int k = 0; k < orders; ++k) {
    double in_W[kMaxCoordinates];
    for (const int half : {0, 3}) {
      const Eigen::Vector3d h = in_S.template segment<3>(6 * k + half).transpose();
      turn<1>(R_WS, h.data(), in_W + half);
    }
    for (const int coordinate : estimated(layout.pose)) *to++ = in_W[coordinate];
  }
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
  if (placed.carried()) return measure_beacons(system, placed, X_WT, scratch, visit);
  const Span span = placed.device->span();
  if (span == Span::point) return measure_points(system, placed, X_WT, scratch, visit);

  const StateLayout& layout = system.motion.layout;
  Target& target = scratch.target;
  target.p_ST = seen_at(placed.X_WS(), X_WT.p, Eigen::Vector3d::Zero());
  target.R_ST.noalias() = placed.X_WS().R.transpose() * X_WT.R;
  target.state.setZero(span == Span::state ? layout.size() : 0);
  const Eigen::Index of_span = span == Span::pose     ? 6
                               : span == Span::motion ? 18
                                                      : layout.size();
  if (!observe_target(placed, of_span, target, scratch.observation)) return false;
  if (may_be_hidden(system, placed) &&
      !in_sight(system, placed.X_WS().p, X_WT, {0, 0, 0}))
    return false;
  const int orders = span == Span::motion ? layout.order : 1;
  whiten(scratch.observation.H, scratch.observation.R,
         [&](const auto& in_S, double variance) {
           if (span == Span::state)
             row.h = in_S;
           else
             fill_row(layout, placed.X_WS().R, orders, in_S, row);
           row.variance = placed.noise * variance;
           visit(std::as_const(row));
         });
  return true;
}

}  // namespace delos
