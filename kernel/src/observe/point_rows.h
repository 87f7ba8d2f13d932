// What a device that sees points measures of one marker at kLanes poses, side by side.
#pragma once

#include <cstdint>
#include <span>

#include "delos/rig/system.h"
#include "rig/sight.h"

namespace delos {

/// Rows of one device over the pose coordinates, in W.
struct PointRows {
  int rows = 0;
  double h[kMaxLaneRows][kMaxCoordinates][kLanes];
  double weight[kMaxLaneRows][kLanes];  ///< 1/r; 0 where not in view, or perfect
  std::uint64_t in_view = 0;            ///< lanes that the device would see
  std::uint64_t hidden = 0;             ///< of those: something is in the way of all
  std::uint64_t perfect = 0;            ///< of those: with a row of no noise
  std::uint64_t rays = 0;               ///< sight lines that were looked along

  [[nodiscard]] std::uint64_t seen() const { return in_view & ~hidden; }
};

/// Observe one marker at up to kLanes poses.
/// @param sight one a pose, or nullptr: what is known of the sight line
/// @returns false where the device has no entry for many points, sees beacons, has a
/// clock, or markers share its noise
bool observe_rows(const System& system, const PlacedDevice& placed,
                  const PlacedMarker& marker, std::span<const TargetPose> poses,
                  const Sight* sight, PointRows& out);

/// Which of up to kLanes poses have one marker in a device's view, a bit each, whatever
/// hides it.
/// @returns false as observe_rows()
bool points_in_view(const PlacedDevice& placed, const PlacedMarker& marker,
                    std::span<const TargetPose> poses, std::uint64_t& in_view);

/// S += Σ hᵀ h / r at the lanes of a mask.
/// @param layer packed as model/lanes.h says
void add_information(const PointRows& rows, int columns, std::uint64_t lanes,
                     double* layer);

}  // namespace delos
