#include "observe/beacon_sightings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <span>

#include "delos/model/lanes.h"
#include "delos/model/wide.h"
#include "observe/answers.h"
#include "observe/beacon_choice.h"
#include "observe/lever.h"
#include "observe/whiten.h"
#include "riccati/dispatch.h"
#include "rig/sight.h"

namespace delos {
namespace {

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

/// One view of a device at poses that are turned alike.
struct BeaconSearch::Question {
  const System& system;
  const PlacedDevice& placed;
  std::span<const TargetPose> poses;
  Eigen::Matrix3d away;  ///< −R_WS: beacons move the other way
  bool may_hide;
  int view = 0;

  [[nodiscard]] const TargetMount& mount() const { return *placed.carried(); }
};

/// @pre candidates_ were found for these poses
std::span<const BeaconSightings> BeaconSearch::see_candidates(
    const System& system, const PlacedDevice& placed,
    std::span<const TargetPose> poses) {
  const TargetMount& mount = *placed.carried();
  const std::size_t count = poses.size();
  if (sightings_.size() < count) sightings_.resize(count);
  origins_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const Pose X_WS = poses[i] * mount.X_TS;
    origins_.emplace_back(-(X_WS.R.transpose() * X_WS.p));
    sightings_[i].all.clear();
    sightings_[i].rows.clear();
  }
  Question question{system, placed, poses, -(poses[0] * mount.X_TS).R,
                    may_be_hidden(system, placed)};
  for (; question.view < placed.device->views(); ++question.view)
    look_through(question);
  const std::span<BeaconSightings> seen(sightings_.data(), count);
  for (BeaconSightings& sightings : seen)
    choose(mount.select, mount.count, system.motion.layout.coordinates(), sightings,
           order_);
  return seen;
}

/// Through one view, from all poses: the device is asked about as many beacons at once
/// as it can be.
void BeaconSearch::look_through(const Question& question) {
  in_cone_.clear();
  for (std::size_t i = 0; i < origins_.size(); ++i)
    candidates_.append_in_cone(question.view, static_cast<std::uint32_t>(i),
                               origins_[i], in_cone_);
  const std::span<const CandidateInCone> all = in_cone_;
  for (std::size_t first = 0; first < all.size(); first += kLanes) {
    const std::size_t count = std::min<std::size_t>(kLanes, all.size() - first);
    candidates_.look(question.view, all.subspan(first, count), origins_, look_);
    const bool in_lanes = ask(question.placed, [&](const Device& device) {
      return device.observe_view_lanes(question.view, look_.lanes, lane_rows_);
    });
    if (in_lanes)
      add_lanes(question);
    else
      add_singly(question);
  }
}

/// Whether a lane's beacon shines here, and nothing is in the way.
bool BeaconSearch::in_light(const Question& question, int lane) const {
  if (look_.reached[lane] == 0) return false;
  if (!question.may_hide) return true;
  const TargetPose& X_WT = question.poses[look_.pose[lane]];
  const Eigen::Vector3d apex = candidates_.cone(question.view).apex;
  const Eigen::Vector3d arm = X_WT * question.mount().X_TS * apex - X_WT.p;
  const Beacon& beacon = (*question.mount().beacons)[look_.beacon[lane]];
  return in_sight(question.system, beacon.p, X_WT, arm);
}

/// How a beacon lies to the target's origin, in W.
Eigen::Vector3d BeaconSearch::arm(const Question& question, int lane) const {
  const Beacon& beacon = (*question.mount().beacons)[look_.beacon[lane]];
  return beacon.p - question.poses[look_.pose[lane]].p;
}

/// Append a sighting, whose rows append_rows() appends.
template <class AppendRows>
void BeaconSearch::append(const Question& question, int lane,
                          AppendRows&& append_rows) {
  auto& [all, rows] = sightings_[look_.pose[lane]];
  const auto first = static_cast<std::uint32_t>(rows.size());
  append_rows(rows);
  all.push_back({look_.beacon[lane], question.view, look_.distance[lane],
                 look_.weight[lane], 0, first,
                 static_cast<std::uint32_t>(rows.size()) - first});
}

/// All rows of the answer over the pose's coordinates, seen or not.
void BeaconSearch::pull_lanes(const Question& question) {
  const int count = look_.lanes.count;
  double arms[3][kLanes];
  for (int l = 0; l < count; ++l) {
    const Eigen::Vector3d a = arm(question, l);
    for (int i = 0; i < 3; ++i) arms[i][l] = a(i);
  }
  in_wide_vectors([&, arm = arms[0]] {
    for (int r = 0; r < lane_rows_.rows; ++r)
      pull_row<kLanes>(question.system.motion.layout, question.away, lane_rows_.H[r][0],
                       arm, h_[r][0], AsTheyAre{}, count);
  });
}

void BeaconSearch::add_lanes(const Question& question) {
  const RowLanes& answer = lane_rows_;
  check_rows(question.placed, answer);
  pull_lanes(question);
  const int coordinates = question.system.motion.layout.coordinates();
  for (int l = 0; l < look_.lanes.count; ++l) {
    if (answer.seen[l] == 0 || !in_light(question, l)) continue;
    append(question, l, [&](std::vector<SightingRow>& rows) {
      for (int r = 0; r < answer.rows; ++r) {
        const double variance = answer.variance[r][l];
        const bool noisy = is_noise(variance);
        if (!noisy) check_perfect(question.placed, variance);
        SightingRow& row = rows.emplace_back();
        for (int i = 0; i < coordinates; ++i) row.h[i] = h_[r][i][l];
        row.variance = noisy ? question.placed.noise * variance : 0;
      }
    });
  }
}

void BeaconSearch::add_singly(const Question& question) {
  const BeaconLanes& lanes = look_.lanes;
  for (int l = 0; l < lanes.count; ++l) {
    target_.p_ST = {lanes.p[0][l], lanes.p[1][l], lanes.p[2][l]};
    target_.n_ST = {lanes.n[0][l], lanes.n[1][l], lanes.n[2][l]};
    const bool sees = ask(question.placed, [&](const Device& device) {
      return device.observe_view(question.view, target_, observation_);
    });
    if (!sees) continue;
    check_answer(question.placed, observation_, 3);
    if (!in_light(question, l)) continue;
    const Eigen::Vector3d lever = arm(question, l);
    append(question, l, [&](std::vector<SightingRow>& rows) {
      whiten(observation_.H, observation_.R, [&](const auto& h_S, double variance) {
        const Eigen::Vector3d h = h_S.transpose();
        SightingRow& row =
            rows.emplace_back(SightingRow{{}, question.placed.noise * variance});
        pull_row<1>(question.system.motion.layout, question.away, h.data(),
                    lever.data(), row.h);
      });
    });
  }
}

bool add_information(const BeaconSightings& sightings, int coordinates, double* S) {
  return riccati::with_coordinates(coordinates,
                                   [&]<int d>() { return add_rows<d>(sightings, S); });
}

}  // namespace delos
