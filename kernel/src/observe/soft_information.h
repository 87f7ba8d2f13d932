// What a device knows of a target where the edges of views and shadows are soft.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "delos/model/pose.h"
#include "delos/rig/system.h"
#include "geometry/occlusion/clearance.h"
#include "observe/measure.h"

namespace delos {

/// What hides, for soft shadows.
struct SoftOccluders {
  explicit SoftOccluders(const System& system);
  std::vector<OccluderEntry> entries;  ///< what the two below were made from
  Clearance in_world;                  ///< in W
  Clearance on_target;                 ///< in the target's frame T
};

/// A visibility by what hides and by how the marker faces, and how it changes with the
/// device's place in W.
struct Sightline {
  double visibility = -1;  ///< below 0: nobody has looked yet; 0: unseen or out of view
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
};

/// One system with edges of one width.
class SoftInformation {
 public:
  /// What is passed is kept by reference.
  SoftInformation(const System& system, const SoftOccluders& occluders, double width);

  /// S += weight · information of a device about a target, columns square.
  /// @param lines one a marker; looked along where that hasn't been done
  /// @returns how far it sees the target, 0 to 1: 1 − Π (1 − v) over the markers
  double add(const PlacedDevice& placed, const TargetPose& X_WT, double weight,
             Sightline* lines, MeasureScratch& scratch, StateMatrix& S) const;

  /// Whether slope() knows the device's slopes.
  [[nodiscard]] bool has_slopes(const PlacedDevice& placed) const;

  /// ∂(⟨G, S⟩ + g v)/∂[p, φ] of what add() adds with weight 1, and of the v that it
  /// returns.
  /// @param lines as add() left them
  /// @pre has_slopes(placed)
  [[nodiscard]] PoseSlope slope(const PlacedDevice& placed, const TargetPose& X_WT,
                                const Sightline* lines, const StateMatrix& G,
                                double g) const;

 private:
  [[nodiscard]] Sightline sightline(const PlacedDevice& placed, const TargetPose& X_WT,
                                    const PlacedMarker& marker) const;
  [[nodiscard]] Sightline facing(const PlacedDevice& placed, const TargetPose& X_WT,
                                 const PlacedMarker& marker) const;
  /// measure() of rows that an update has as far as the marker is visible.
  /// @returns as add(), or nullopt where the device has no observe_smoothly()
  template <class Visit>
  std::optional<double> measure_smoothly(const PlacedDevice& placed,
                                         const TargetPose& X_WT, Sightline* lines,
                                         StateRow& row, Visit&& visit) const;
  /// Π (1 − v) over all markers but one.
  [[nodiscard]] double unseen_by_others(const PlacedDevice& placed,
                                        const TargetPose& X_WT, const Sightline* lines,
                                        std::size_t marker) const;
  [[nodiscard]] double view(double margin) const;
  [[nodiscard]] bool out_of_view(const Device& device, const Eigen::Vector3d& p) const;

  const System& system_;
  const SoftOccluders& occluders_;
  double width_;
  double unseen_margin_;  // radians beyond the edge of a view at which nothing is left
  int columns_;
};

}  // namespace delos
