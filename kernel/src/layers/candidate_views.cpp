#include <omp.h>

#include <algorithm>
#include <bit>
#include <set>

#include "delos/layers/candidate_information.h"
#include "delos/model/lanes.h"
#include "layers/beacon_owners.h"
#include "observe/measure.h"
#include "observe/point_rows.h"
#include "parallel/first_failure.h"

namespace delos {
namespace {

/// Poses that a device sees, one bit each.
class Views {
 public:
  explicit Views(const System& system) : system_(system) {}

  std::uint64_t of_block(const PlacedDevice& placed,
                         std::span<const TargetPose> poses) {
    std::uint64_t seen = 0;
    for (const Eigen::Vector3d& marker : system_.markers) {
      if (!observe_rows(system_, placed, marker, poses, nullptr, rows_))
        return one_by_one(placed, poses);
      seen |= rows_.seen();
    }
    return seen;
  }

 private:
  std::uint64_t one_by_one(const PlacedDevice& placed,
                           std::span<const TargetPose> poses) {
    const int columns = information_size(system_);
    std::uint64_t seen = 0;
    for (std::size_t p = 0; p < poses.size(); ++p)
      if (measure(system_, placed, poses[p], columns, scratch_, [](const StateRow&) {}))
        seen |= std::uint64_t{1} << p;
    return seen;
  }

  const System& system_;
  PointRows rows_;
  MeasureScratch scratch_;
};

std::vector<std::int32_t> poses_of(Views& views, const PlacedDevice& placed,
                                   std::span<const TargetPose> poses) {
  std::vector<std::int32_t> seen;
  for (std::size_t first = 0; first < poses.size(); first += kLanes) {
    const auto block =
        poses.subspan(first, std::min<std::size_t>(kLanes, poses.size() - first));
    for (std::uint64_t bits = views.of_block(placed, block); bits; bits &= bits - 1)
      seen.push_back(static_cast<std::int32_t>(
          first + static_cast<std::size_t>(std::countr_zero(bits))));
  }
  return seen;
}

/// The beacons that a device sees: for each candidate, where it sees one of it.
void add_beacons(const System& system, const CandidateScene& all, std::size_t device,
                 std::span<const TargetPose> poses,
                 std::vector<std::set<std::int32_t>>& of_candidate,
                 std::vector<std::int32_t>& always) {
  const PlacedDevice& placed = system.devices[device];
  const std::vector<int> owners = beacon_owners(system, placed, all);
  BeaconSightings sightings;
  for (std::size_t p = 0; p < poses.size(); ++p) {
    see_beacons(system, placed, poses[p], sightings);
    bool anyway = false;
    for (const BeaconSighting& sighting : sightings.all) {
      int owner = owners[sighting.beacon];
      if (owner < 0) owner = all.of_device[device];
      if (owner < 0)
        anyway = true;
      else
        of_candidate[static_cast<std::size_t>(owner)].insert(
            static_cast<std::int32_t>(p));
    }
    always[p] += anyway;
  }
}

}  // namespace

CandidateViews candidate_views(const System& system, const CandidateScene& all,
                               std::span<const TargetPose> poses, int threads) {
  CandidateViews views;
  views.always.assign(poses.size(), 0);
  std::vector<std::set<std::int32_t>> by_beacons(all.candidates.size());
  std::vector<std::vector<std::int32_t>> of_device(system.devices.size());
  FirstFailure failure;
  const int count = threads > 0 ? threads : omp_get_max_threads();
#pragma omp parallel num_threads(count)
  {
    Views own(system);
#pragma omp for schedule(dynamic, 16)
    for (std::size_t i = 0; i < system.devices.size(); ++i) {
      failure.guard([&] {
        if (!system.devices[i].carried())
          of_device[i] = poses_of(own, system.devices[i], poses);
      });
    }
  }
  failure.rethrow();

  std::vector<std::size_t> device_of(all.candidates.size(), system.devices.size());
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    if (system.devices[i].carried()) {
      add_beacons(system, all, i, poses, by_beacons, views.always);
    } else if (all.of_device[i] >= 0) {
      device_of[static_cast<std::size_t>(all.of_device[i])] = i;
    } else {
      for (const std::int32_t p : of_device[i])
        ++views.always[static_cast<std::size_t>(p)];
    }
  }
  views.first.push_back(0);
  for (std::size_t c = 0; c < all.candidates.size(); ++c) {
    if (device_of[c] < system.devices.size())
      views.poses.insert(views.poses.end(), of_device[device_of[c]].begin(),
                         of_device[device_of[c]].end());
    else
      views.poses.insert(views.poses.end(), by_beacons[c].begin(), by_beacons[c].end());
    views.first.push_back(views.poses.size());
  }
  return views;
}

}  // namespace delos
