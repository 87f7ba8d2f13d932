// Filling a block of layers: what each device knows at up to kLanes poses, and its
// sums.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "delos/layers/layers.h"
#include "rig/sight.h"

namespace delos {

/// How the layers of a system are stored and weighted.
struct LayerShape {
  explicit LayerShape(const System& system);

  std::size_t devices;
  std::size_t groups;
  int columns;         ///< information_size() of the system
  int coordinates;     ///< of the pose, d
  double prior;        ///< of each of them, as System has it
  std::size_t stride;  ///< numbers in one layer: packed × kLanes
  std::vector<double>
      weights;  ///< one a device: 1, or 1/period for a rate of information
};

/// Whether a lane of a block has rows that are measured without noise.
[[nodiscard]] inline bool has_perfect_rows(const LayerBlock& block, int lane) {
  return std::any_of(block.perfect.begin(), block.perfect.end(),
                     [lane](std::uint64_t lanes) { return lanes >> lane & 1; });
}

/// Devices are summed in groups of this many.
inline constexpr std::size_t kGroup = 8;

/// Make room for `lanes` poses, whose layers hold any number; nothing is seen.
void size_block(const LayerShape& shape, int lanes, LayerBlock& block);

/// The same with all layers zero.
void clear_block(const LayerShape& shape, int lanes, LayerBlock& block);

/// Work out one device's layer. @pre size_block() was called with poses.size()
void observe_device(const System& system, const LayerShape& shape, std::size_t device,
                    std::span<const TargetPose> poses, LayerBlock& block);

void sum_group(const LayerShape& shape, std::size_t group, LayerBlock& block);
/// The sum of the groups, and the prior.
void sum_total(const LayerShape& shape, LayerBlock& block);
/// All groups, and the total.
void sum_layers(const LayerShape& shape, LayerBlock& block);
/// Look at the total, which shows at once what any of the layers has.
/// @throws DeviceFault a device's information isn't finite
void check_total(const System& system, const LayerShape& shape,
                 const LayerBlock& block);
/// All of it: every device's layer, and their sums.
/// @throws DeviceFault as above
void fill_block(const System& system, const LayerShape& shape,
                std::span<const TargetPose> poses, LayerBlock& block);

}  // namespace delos
