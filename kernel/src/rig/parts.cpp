#include "rig/parts.h"

#include <algorithm>

namespace delos {

TriangleMesh placed_mesh(const OccluderEntry& entry) {
  return transformed(body_mesh(entry.body), pose_of(entry.placement));
}

std::vector<TriangleMesh> placed_bodies(const std::vector<OccluderEntry>& occluders,
                                        Mount mount) {
  std::vector<TriangleMesh> bodies;
  for (const OccluderEntry& entry : occluders) {
    if (entry.mount == mount) bodies.push_back(placed_mesh(entry));
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
