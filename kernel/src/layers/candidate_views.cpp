#include <algorithm>
#include <atomic>
#include <set>

#include "delos/layers/candidate_information.h"
#include "delos/parallel/each.h"
#include "layers/beacon_owners.h"
#include "layers/pose_views.h"
#include "observe/beacon_sightings.h"

namespace delos {
namespace {

/// The beacons that a device sees: for each candidate, where it sees one of it.
void add_beacons(const System& system, const CandidateScene& all, std::size_t device,
                 std::span<const TargetPose> poses,
                 std::vector<std::set<std::int32_t>>& of_candidate,
                 std::vector<std::int32_t>& always) {
  const PlacedDevice& placed = system.devices[device];
  const std::vector<int> owners = beacon_owners(system, placed, all);
  BeaconSearch search;
  for (std::size_t p = 0; p < poses.size(); ++p) {
    bool anyway = false;
    for (const BeaconSighting& sighting : search.see(system, placed, poses[p]).all) {
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

/// What neighbouring candidates see, one after the other: the part of a thread's work.
struct ViewChunk {
  std::vector<std::int32_t> poses;
  std::vector<std::size_t> ends;  ///< of each candidate's
};
constexpr std::size_t kChunk = 128;

/// One list of all; each chunk goes once it is copied, since all may take gigabytes.
void join(std::vector<ViewChunk>& chunks, CandidateViews& views) {
  std::size_t size = 0;
  for (const ViewChunk& chunk : chunks) size += chunk.poses.size();
  views.poses.reserve(size);
  views.first.push_back(0);
  for (ViewChunk& chunk : chunks) {
    const std::size_t before = views.poses.size();
    views.poses.insert(views.poses.end(), chunk.poses.begin(), chunk.poses.end());
    for (const std::size_t end : chunk.ends) views.first.push_back(before + end);
    chunk = {};
  }
}

}  // namespace

CandidateViews candidate_views(const System& system, const CandidateScene& all,
                               std::span<const TargetPose> poses, int threads,
                               const std::function<bool(double)>& go_on) {
  CandidateViews views;
  views.always.assign(poses.size(), 0);
  std::vector<std::set<std::int32_t>> by_beacons(all.candidates.size());
  std::vector<std::size_t> device_of(all.candidates.size(), system.devices.size());
  std::vector<std::size_t> standing;
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    if (system.devices[i].carried() && !system.devices[i].sees_beacons())
      throw std::invalid_argument(
          system.devices[i].name +
          " measures how the target moves, from everywhere alike: leave it out of what "
          "is to be covered");
    if (system.devices[i].sees_beacons())
      add_beacons(system, all, i, poses, by_beacons, views.always);
    else if (all.of_device[i] >= 0)
      device_of[static_cast<std::size_t>(all.of_device[i])] = i;
    else
      standing.push_back(i);
  }

  const PoseTrees trees(poses);
  std::vector<ViewChunk> chunks(all.candidates.size() / kChunk + 1);
  std::atomic<bool> stopped = false;
  LoopOptions loop{.threads = threads, .stop = [&] { return stopped.load(); }};
  if (go_on)
    loop.progress = [&](std::size_t done) {
      if (!go_on(static_cast<double>(done) / static_cast<double>(chunks.size())))
        stopped = true;
    };
  each_with(chunks.size(), loop, [&] {
    return [&, own = PoseViews(system, trees)](std::size_t k) mutable {
      const std::size_t end = std::min(all.candidates.size(), (k + 1) * kChunk);
      for (std::size_t c = k * kChunk; c < end; ++c) {
        if (device_of[c] < system.devices.size())
          own.append(system.devices[device_of[c]], chunks[k].poses);
        else
          chunks[k].poses.insert(chunks[k].poses.end(), by_beacons[c].begin(),
                                 by_beacons[c].end());
        chunks[k].ends.push_back(chunks[k].poses.size());
      }
    };
  });
  if (stopped) return {};

  PoseViews own(system, trees);
  std::vector<std::int32_t> seen;
  for (const std::size_t i : standing) {
    seen.clear();
    own.append(system.devices[i], seen);
    for (const std::int32_t p : seen) ++views.always[static_cast<std::size_t>(p)];
  }
  join(chunks, views);
  return views;
}

}  // namespace delos
