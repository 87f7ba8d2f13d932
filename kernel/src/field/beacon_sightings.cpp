#include "field/beacon_sightings.h"

#include <Eigen/Geometry>

#include "delos/model/lanes.h"
#include "field/beacon_choice.h"
#include "field/sight.h"
#include "field/whiten.h"

namespace delos {
namespace {

/// How a change of the pose moves what a device on the target sees.
///
/// A beacon at b is seen at p_S = R_SW (b − p_WS). Where the target moves by δp and
/// turns by δθ about the world's axes, in its own frame the beacon moves by
///
///   δp_S = R_SW (−δp + (b − p_WT) × δθ)
///
/// so that a row H over p_S becomes [−g, g × (b − p_WT)] with g = H R_SW.
struct PoseRow {
  const StateLayout& layout;
  const Eigen::Matrix3d& R_WS;
  Eigen::Vector3d arm;  ///< b − p_WT

  template <class Row>
  void fill(const Row& H, SightingRow& row) const {
    const Eigen::Vector3d g =
        R_WS.col(0) * H(0) + R_WS.col(1) * H(1) + R_WS.col(2) * H(2);
    if (layout.pose != PoseState::orientation) {
      for (int i = 0; i < 3; ++i) row.h[i] = -g(i);
    }
    if (layout.pose == PoseState::position) return;
    const Eigen::Vector3d turn = g.cross(arm);
    for (int i = 0; i < 3; ++i) row.h[layout.positions() + i] = turn(i);
  }
};

}  // namespace

ViewCone cone_in_world(const PlacedDevice& placed, int view, const Pose& X_WS) {
  ViewCone cone = placed.device->view_cone(view);
  cone.apex = X_WS * cone.apex;
  cone.axis = X_WS.R * cone.axis;
  return cone;
}

void see_beacons(const System& system, const PlacedDevice& placed,
                 const TargetPose& X_WT, BeaconSightings& out) {
  out.all.clear();
  out.rows.clear();
  const BeaconIndex& beacons = *placed.beacons;
  const Pose X_WS = X_WT * placed.X_TS;
  const bool may_hide = may_be_hidden(system, placed);
  for (int view = 0; view < placed.device->views(); ++view) {
    const ViewCone cone = cone_in_world(placed, view, X_WS);
    out.in_cone.clear();
    beacons.find(cone, out.in_cone);
    for (const std::uint32_t b : out.in_cone) {
      const Beacon& beacon = beacons[b];
      if (beacon.weight == 0) continue;
      out.target.p_ST.noalias() = X_WS.R.transpose() * (beacon.p - X_WS.p);
      out.target.n_ST.noalias() = X_WS.R.transpose() * beacon.normal;
      if (!placed.device->observe_view(view, out.target, out.observation)) continue;
      if (!beacon.reaches(cone.apex)) continue;
      if (may_hide && !in_sight(system, beacon.p, X_WT, cone.apex - X_WT.p)) continue;
      const auto first = static_cast<std::uint32_t>(out.rows.size());
      const PoseRow pose_row{system.motion.layout, X_WS.R, beacon.p - X_WT.p};
      whiten(
          out.observation.H, out.observation.R,
          [&](const auto& H, double variance) {
            pose_row.fill(H, out.rows.emplace_back(SightingRow{{}, variance}));
          },
          [&](const auto& H) {
            pose_row.fill(H, out.rows.emplace_back(SightingRow{{}, 0}));
          });
      out.all.push_back({b, view, (beacon.p - cone.apex).norm(), beacon.weight, 0,
                         first, static_cast<std::uint32_t>(out.rows.size()) - first});
    }
  }
  choose(placed.select, placed.count, system.motion.layout.coordinates(), out);
}

bool add_information(const BeaconSightings& sightings, int coordinates, double* S) {
  bool perfect = false;
  for (const BeaconSighting& s : sightings.all) {
    if (s.share == 0) continue;
    for (std::uint32_t r = s.first_row; r < s.first_row + s.rows; ++r) {
      const SightingRow& row = sightings.rows[r];
      if (row.variance == 0) {
        perfect = true;
        continue;
      }
      const double weight = s.share / row.variance;
      for (int i = 0; i < coordinates; ++i) {
        const double scaled = weight * row.h[i];
        for (int j = 0; j <= i; ++j) S[packed_index(i, j)] += scaled * row.h[j];
      }
    }
  }
  return perfect;
}

}  // namespace delos
