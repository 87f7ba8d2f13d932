#include "observe/beacon_sightings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <span>

#include "delos/model/lanes.h"
#include "observe/answers.h"
#include "observe/beacon_choice.h"
#include "observe/lever.h"
#include "observe/whiten.h"
#include "riccati/dispatch.h"
#include "rig/sight.h"

namespace delos {
namespace {

/// What one view sees of the beacons in out.look.
struct ViewSightings {
  const System& system;
  const PlacedDevice& placed;
  const BeaconIndex& beacons;
  const TargetPose& X_WT;
  const Pose& X_WS;
  const Eigen::Matrix3d& away;  ///< −R_WS: beacons move the other way
  bool may_hide;
  int view;
  BeaconSightings& out;

  void add() const {
    const bool in_lanes = ask(placed, [&](const Device& device) {
      return device.observe_view_lanes(view, out.look.lanes, out.lane_rows);
    });
    if (in_lanes) {
      check_rows(placed, out.lane_rows);
      add_lanes();
    } else {
      add_singly();
    }
  }

 private:
  /// Whether lane l's beacon shines here, and nothing is in the way.
  [[nodiscard]] bool in_light(int l) const {
    if (out.look.reached[l] == 0) return false;
    if (!may_hide) return true;
    const Eigen::Vector3d arm = X_WS * out.candidates.cone(view).apex - X_WT.p;
    return in_sight(system, beacons[out.look.beacon[l]].p, X_WT, arm);
  }

  /// Append a sighting, whose rows fill_rows() appends.
  template <class FillRows>
  void append(int l, FillRows&& fill_rows) const {
    const std::uint32_t beacon = out.look.beacon[l];
    const auto first = static_cast<std::uint32_t>(out.rows.size());
    const Eigen::Vector3d arm = beacons[beacon].p - X_WT.p;
    fill_rows([&](const Eigen::Vector3d& h, double variance) {
      pull_row<1>(system.motion.layout, away, h.data(), arm.data(),
                  out.rows.emplace_back(SightingRow{{}, placed.noise * variance}).h);
    });
    out.all.push_back({beacon, view, out.look.distance[l], out.look.weight[l], 0, first,
                       static_cast<std::uint32_t>(out.rows.size()) - first});
  }

  void add_lanes() const {
    const RowLanes& rows = out.lane_rows;
    for (int l = 0; l < out.look.lanes.count; ++l) {
      if (rows.seen[l] == 0 || !in_light(l)) continue;
      append(l, [&](const auto& fill_row) {
        for (int r = 0; r < rows.rows; ++r) {
          const double variance = rows.variance[r][l];
          const bool noisy = is_noise(variance);
          if (!noisy) check_perfect(placed, variance);
          fill_row({rows.H[r][0][l], rows.H[r][1][l], rows.H[r][2][l]},
                   noisy ? variance : 0);
        }
      });
    }
  }

  void add_singly() const {
    const BeaconLanes& lanes = out.look.lanes;
    for (int l = 0; l < lanes.count; ++l) {
      out.target.p_ST = {lanes.p[0][l], lanes.p[1][l], lanes.p[2][l]};
      out.target.n_ST = {lanes.n[0][l], lanes.n[1][l], lanes.n[2][l]};
      const bool sees = ask(placed, [&](const Device& device) {
        return device.observe_view(view, out.target, out.observation);
      });
      if (!sees) continue;
      check_answer(placed, out.observation, 3);
      if (!in_light(l)) continue;
      append(l, [&](const auto& fill_row) {
        whiten(out.observation.H, out.observation.R,
               [&](const auto& h, double variance) {
                 fill_row(Eigen::Vector3d(h.transpose()), variance);
               });
      });
    }
  }
};

/// add_information() with the number of coordinates known to the compiler.
template <int coordinates>
bool add_rows(const BeaconSightings& sightings, double* S) {
  bool perfect = false;
  each_used_row(sightings, [&](const BeaconSighting& s, const SightingRow& row) {
    if (row.variance == 0) {
      perfect = true;
      return;
    }
    const double weight = s.share / row.variance;
    for (int i = 0; i < coordinates; ++i) {
      const double scaled = weight * row.h[i];
      for (int j = 0; j <= i; ++j) S[packed_index(i, j)] += scaled * row.h[j];
    }
  });
  return perfect;
}

}  // namespace

ViewCone cone_in_world(const PlacedDevice& placed, int view, const Pose& X_WS) {
  ViewCone cone = placed.device->view_cone(view);
  cone.apex = X_WS * cone.apex;
  cone.axis = X_WS.R * cone.axis;
  return cone;
}

void see_beacons(const System& system, const PlacedDevice& placed,
                 const TargetPose& X_WT, BeaconSightings& out) {
  out.candidates.find(placed, {&X_WT, 1});
  see_candidates(system, placed, X_WT, out);
}

void see_candidates(const System& system, const PlacedDevice& placed,
                    const TargetPose& X_WT, BeaconSightings& out) {
  out.all.clear();
  out.rows.clear();
  const TargetMount& mount = *placed.carried();
  const Pose X_WS = X_WT * mount.X_TS;
  const Eigen::Vector3d origin_S = -(X_WS.R.transpose() * X_WS.p);
  const Eigen::Matrix3d away = -X_WS.R;
  const bool may_hide = may_be_hidden(system, placed);
  for (int view = 0; view < placed.device->views(); ++view) {
    const ViewSightings sightings{system, placed,   *mount.beacons, X_WT, X_WS,
                                  away,   may_hide, view,           out};
    const auto all = out.candidates.in_cone(view, origin_S);
    for (std::size_t first = 0; first < all.size(); first += kLanes) {
      const std::size_t count = std::min<std::size_t>(kLanes, all.size() - first);
      out.candidates.look(view, all.subspan(first, count), origin_S, out.look);
      sightings.add();
    }
  }
  choose(mount.select, mount.count, system.motion.layout.coordinates(), out);
}

bool add_information(const BeaconSightings& sightings, int coordinates, double* S) {
  return riccati::with_coordinates(coordinates,
                                   [&]<int d>() { return add_rows<d>(sightings, S); });
}

}  // namespace delos
