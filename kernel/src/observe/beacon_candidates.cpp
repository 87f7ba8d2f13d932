#include "observe/beacon_candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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
  const Together near = together(mount.X_TS, poses, index_->patch());
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
  in_cone_.resize(beacons_.size());
  return near.count;
}

std::span<const std::uint32_t> BeaconCandidates::in_cone(
    int view, const Eigen::Vector3d& origin_S) {
  const View& v = views_[static_cast<std::size_t>(view)];
  const ConeTest test = v.test;
  const Eigen::Vector3d apex = v.cone.apex - origin_S;
  const double ax = v.cone.axis.x(), ay = v.cone.axis.y(), az = v.cone.axis.z();
  std::size_t found = 0;
  for (std::uint32_t first = v.first; first < v.last; first += kLanes) {
    const auto count =
        static_cast<int>(std::min<std::uint32_t>(kLanes, v.last - first));
    double inside[kLanes];
    for (int l = 0; l < count; ++l) {
      const std::size_t c = first + static_cast<std::size_t>(l);
      const double x = x_[c] - apex.x(), y = y_[c] - apex.y(), z = z_[c] - apex.z();
      const bool holds = test.holds(x * ax + y * ay + z * az, x * x + y * y + z * z);
      inside[l] = holds ? 1.0 : 0.0;
    }
    // Without a branch, which would often be mispredicted.
    for (int l = 0; l < count; ++l) {
      in_cone_[found] = first + static_cast<std::uint32_t>(l);
      found += inside[l] > 0;
    }
  }
  return {in_cone_.data(), found};
}

void BeaconCandidates::look(int view, std::span<const std::uint32_t> candidates,
                            const Eigen::Vector3d& origin_S, BeaconLook& out) const {
  const auto count = static_cast<int>(candidates.size());
  auto &p = out.lanes.p, &n = out.lanes.n;
  double normal[3][kLanes], cos_emission[kLanes], range[kLanes];
  out.lanes.count = count;
  for (int l = 0; l < count; ++l) {
    const std::uint32_t c = candidates[static_cast<std::size_t>(l)];
    p[0][l] = x_[c] + origin_S.x();
    p[1][l] = y_[c] + origin_S.y();
    p[2][l] = z_[c] + origin_S.z();
    const Beacon& beacon = (*index_)[beacons_[c]];
    for (int i = 0; i < 3; ++i) normal[i][l] = beacon.normal(i);
    cos_emission[l] = beacon.cos_emission;
    range[l] = beacon.range;
    out.weight[l] = beacon.weight;
    out.beacon[l] = beacons_[c];
  }
  for (int i = 0; i < 3; ++i) {
    const double rx = R_SW_(i, 0), ry = R_SW_(i, 1), rz = R_SW_(i, 2);
    for (int l = 0; l < count; ++l) {
      n[i][l] = rx * normal[0][l] + ry * normal[1][l] + rz * normal[2][l];
    }
  }
  const Eigen::Vector3d apex = cone(view).apex;
  for (int l = 0; l < count; ++l) {
    const double x = apex.x() - p[0][l], y = apex.y() - p[1][l], z = apex.z() - p[2][l];
    const double distance = std::sqrt(x * x + y * y + z * z);
    const double along = n[0][l] * x + n[1][l] * y + n[2][l] * z;
    const bool all_around = (n[0][l] == 0) & (n[1][l] == 0) & (n[2][l] == 0);
    const bool reached = (out.weight[l] > 0) & (distance <= range[l]) &
                         (all_around | (along >= cos_emission[l] * distance));
    out.distance[l] = distance;
    out.reached[l] = reached ? 1.0 : 0.0;
  }
}

}  // namespace delos
