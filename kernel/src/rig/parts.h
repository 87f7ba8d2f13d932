// What a rig makes of the parts of its scene.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "delos/scene/scene.h"

namespace delos {

/// The mesh of a body where it stands, in W or in the target's frame T.
[[nodiscard]] TriangleMesh placed_mesh(const OccluderEntry& entry);

/// The meshes of all bodies of one mount, in W or in the target's frame T.
[[nodiscard]] std::vector<TriangleMesh> placed_bodies(
    const std::vector<OccluderEntry>& occluders, Mount mount);

/// Which sets a device on the target sees: its BeaconIndex lists the beacons of one
/// after the other.
/// @param sees names; empty: all
[[nodiscard]] std::vector<std::size_t> seen_sets(const std::vector<BeaconSet>& sets,
                                                 const std::vector<std::string>& sees);

}  // namespace delos
