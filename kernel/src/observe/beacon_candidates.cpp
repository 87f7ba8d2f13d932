#include "observe/beacon_candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "delos/model/wide.h"
#include "observe/lever.h"

namespace delos {
namespace {

/// Poses, and a ball around the device at all of them, in W.
struct Together {
  std::size_t count;
  Eigen::Vector3d middle;
  double radius;
};

/// The first poses that are turned alike and stay within a ball.
Together together(const Pose& X_TS, std::span<const TargetPose> poses, double most) {
  const auto at = [&](std::size_t i) -> Eigen::Vector3d {
    return poses[i].R * X_TS.p + poses[i].p;
  };
  Eigen::AlignedBox3d box(at(0));
  std::size_t count = 1;
  for (; count < poses.size() && poses[count].R == poses[0].R; ++count) {
    Eigen::AlignedBox3d larger = box;
    larger.extend(at(count));
    if (larger.diagonal().norm() > 2 * most) break;
    box = larger;
  }
  return {count, box.center(), box.diagonal().norm() / 2};
}

}  // namespace

std::size_t BeaconCandidates::find(const PlacedDevice& placed,
                                   std::span<const TargetPose> poses) {
  const TargetMount& mount = *placed.carried();
  index_ = mount.beacons.get();
  // The fewer poses, the fewer candidates, and the more often they are looked for.
  const Together near = together(mount.X_TS, poses, index_->patch() / 2);
  const Eigen::Matrix3d R_WS = poses[0].R * mount.X_TS.R;
  R_SW_ = R_WS.transpose();
  views_.clear();
  beacons_.clear();
  for (int view = 0; view < placed.device->views(); ++view) {
    const ViewCone in_S = placed.device->view_cone(view);
    ViewCone in_W = in_S;
    in_W.apex = near.middle + R_WS * in_S.apex;
    in_W.axis = R_WS * in_S.axis;
    const auto first = static_cast<std::uint32_t>(beacons_.size());
    index_->find_near(in_W, near.radius, beacons_);
    views_.push_back(
        {in_S, ConeTest(in_S), first, static_cast<std::uint32_t>(beacons_.size())});
  }
  for (std::vector<double>* all : {&x_, &y_, &z_}) all->resize(beacons_.size());
  for (std::size_t c = 0; c < beacons_.size(); ++c) {
    const Eigen::Vector3d p = R_SW_ * (*index_)[beacons_[c]].p;
    x_[c] = p.x(), y_[c] = p.y(), z_[c] = p.z();
  }
  return near.count;
}

std::size_t BeaconCandidates::poses_together() const {
  constexpr std::size_t kCandidates = 6 * kLanes;  // of a view in the mean
  return 1 + kCandidates * views_.size() / (beacons_.size() + 1);
}

void BeaconCandidates::append_in_cone(int view, std::uint32_t pose,
                                      const Eigen::Vector3d& origin_S,
                                      std::vector<CandidateInCone>& found) const {
  const View& v = views_[static_cast<std::size_t>(view)];
  const ConeTest test = v.test;
  const Eigen::Vector3d apex = v.cone.apex - origin_S;
  const double ax = v.cone.axis.x(), ay = v.cone.axis.y(), az = v.cone.axis.z();
  for (std::uint32_t first = v.first; first < v.last; first += kLanes) {
    const auto count =
        static_cast<int>(std::min<std::uint32_t>(kLanes, v.last - first));
    const double *px = &x_[first], *py = &y_[first], *pz = &z_[first];
    double inside[kLanes];
    in_wide_vectors([&] {
      for (int l = 0; l < count; ++l) {
        const double x = px[l] - apex.x(), y = py[l] - apex.y(), z = pz[l] - apex.z();
        const bool holds = test.holds(x * ax + y * ay + z * az, x * x + y * y + z * z);
        inside[l] = holds ? 1.0 : 0.0;
      }
    });
    // Without a branch, which would often be mispredicted.
    CandidateInCone some[kLanes];
    std::size_t some_found = 0;
    for (int l = 0; l < count; ++l) {
      some[some_found] = {first + static_cast<std::uint32_t>(l), pose};
      some_found += inside[l] > 0;
    }
    found.insert(found.end(), some, some + some_found);
  }
}

void BeaconCandidates::look(int view, std::span<const CandidateInCone> candidates,
                            std::span<const Eigen::Vector3d> origins_S,
                            BeaconLook& out) const {
  const auto count = static_cast<int>(candidates.size());
  BeaconLanes& lanes = out.lanes;
  double normal[3][kLanes], cos_emission[kLanes], range[kLanes];
  lanes.count = count;
  for (int l = 0; l < count; ++l) {
    const auto [c, pose] = candidates[static_cast<std::size_t>(l)];
    const Eigen::Vector3d& origin = origins_S[pose];
    lanes.p[0][l] = x_[c] + origin.x();
    lanes.p[1][l] = y_[c] + origin.y();
    lanes.p[2][l] = z_[c] + origin.z();
    const Beacon& beacon = (*index_)[beacons_[c]];
    for (int i = 0; i < 3; ++i) normal[i][l] = beacon.normal(i);
    cos_emission[l] = beacon.cos_emission;
    range[l] = beacon.range;
    out.weight[l] = beacon.weight;
    out.beacon[l] = beacons_[c];
    out.pose[l] = pose;
  }
  const Eigen::Vector3d& apex = cone(view).apex;
  in_wide_vectors([&, ax = apex.x(), ay = apex.y(), az = apex.z()] {
    turn<kLanes>(R_SW_, normal[0], lanes.n[0], AsTheyAre{}, count);
    for (int l = 0; l < count; ++l) {
      const double x = ax - lanes.p[0][l], y = ay - lanes.p[1][l],
                   z = az - lanes.p[2][l];
      const double nx = lanes.n[0][l], ny = lanes.n[1][l], nz = lanes.n[2][l];
      const double distance = std::sqrt(x * x + y * y + z * z);
      const double along = nx * x + ny * y + nz * z;
      const bool all_around = (nx == 0) & (ny == 0) & (nz == 0);
      const bool reached = (out.weight[l] > 0) & (distance <= range[l]) &
                           (all_around | (along >= cos_emission[l] * distance));
      out.distance[l] = distance;
      out.reached[l] = reached ? 1.0 : 0.0;
    }
  });
}

}  // namespace delos
