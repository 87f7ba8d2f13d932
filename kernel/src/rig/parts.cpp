#include "rig/parts.h"

#include <algorithm>

namespace delos {

std::vector<TriangleMesh> placed_bodies(const std::vector<OccluderEntry>& occluders,
                                        Mount mount) {
  std::vector<TriangleMesh> bodies;
  for (const OccluderEntry& entry : occluders) {
    if (entry.mount != mount) continue;
    bodies.push_back(transformed(body_mesh(entry.body), pose_of(entry.placement)));
  }
  return bodies;
}

std::vector<std::size_t> seen_sets(const std::vector<BeaconSet>& sets,
                                   const std::vector<std::string>& sees) {
  std::vector<std::size_t> seen;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const bool named = std::find(sees.begin(), sees.end(), sets[s].name) != sees.end();
    if (sees.empty() || named) seen.push_back(s);
  }
  return seen;
}

}  // namespace delos
