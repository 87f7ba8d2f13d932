// Bodies drawn at random, for questions such as how many cameras a crowded room needs.
#pragma once

#include <vector>

#include "delos/api.h"
#include "delos/scene/scene.h"

namespace delos {

/// The bodies of one entry. Those of a smaller count come first: more bodies move none.
///
/// A centre is uniform in the entry's box; edges of a box, or the diameter of a ball,
/// are uniform in `size`; boxes are turned about z by a uniform angle. The numbers are
/// of a 64-bit Mersenne twister with the entry's seed, the same on any machine.
[[nodiscard]] DELOS_API std::vector<OccluderEntry> drawn_bodies(
    const ClutterEntry& clutter);

/// All that hides in a scene: its occluders, then what its clutter draws.
[[nodiscard]] DELOS_API std::vector<OccluderEntry> all_occluders(const Scene& scene);

}  // namespace delos
