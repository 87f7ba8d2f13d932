// Layouts: where the devices of designs stand, whichever of them is called what.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "delos/optimize/design.h"

namespace delos {

/// A kind for each device of a scene: devices of one kind are interchangeable, that is,
/// equal but for their names, where they stand, and what variables set.
[[nodiscard]] std::vector<int> device_kinds(const Scene& scene,
                                            PluginRegistry& plugins);

/// Two layouts of the same devices, matched.
struct LayoutMatch {
  std::vector<std::size_t> partner;  ///< of each device of the first, in the second
  std::vector<double> shift;         ///< metres between partners
  std::vector<double> turn;          ///< radians between their z axes
  double distance = 0;               ///< see match_layouts()
};

/// Match each device of a layout with one of its kind in another, such that
///
///   d² = mean over devices of |Δp|² + (r·turn)²
///
/// is least: with r the distance from the device to the middle of what it looks at, a
/// turn counts as much as it moves the place that is looked at.
/// @param first, second poses in the world, in the order of the kinds
/// @param middle of the samples, metres
/// @returns the match; its distance is d, metres
[[nodiscard]] LayoutMatch match_layouts(const std::vector<int>& kinds,
                                        const std::vector<Pose>& first,
                                        const std::vector<Pose>& second,
                                        const Eigen::Vector3d& middle);

/// A design and what it is worth.
struct RankedDesign {
  std::vector<double> x;  ///< in the unit cube
  double objective = 0;
};

/// One of the best layouts.
struct ConsensusLayout {
  std::size_t design = 0;  ///< of the designs that were given
  double objective = 0;
  double distance = 0;  ///< from the best layout, metres; see match_layouts()
};

/// Whether the best layouts agree about a device.
enum class Settled {
  settled,  ///< they do: its place varies less than a quarter as much as by chance
  partly,
  free,  ///< they don't: more than three fifths as much
};
[[nodiscard]] const char* to_string(Settled settled);

/// What the best layouts say of one device, as it stands in the best.
struct ConsensusDevice {
  std::string name;
  Eigen::Vector3d at;         ///< world, metres
  double shift = 0;           ///< root mean square over the layouts, metres
  double turn = 0;            ///< likewise, radians
  double part_of_chance = 0;  ///< how much it varies, relative to random designs
  Settled settled = Settled::settled;
};

/// What several good designs have in common.
struct Consensus {
  std::vector<ConsensusLayout> layouts;  ///< distinct ones, the best first
  std::vector<ConsensusDevice> devices;  ///< those that the variables move
};

/// The consensus of the `most` best distinct layouts. Two are the same where d is less
/// than a twentieth of that between random designs.
/// @param scene   with the variables that the designs are about
/// @param designs at least one
[[nodiscard]] Consensus consensus(const Scene& scene, PluginRegistry& plugins,
                                  const std::vector<RankedDesign>& designs,
                                  std::size_t most = 10, std::uint64_t seed = 1);

}  // namespace delos
