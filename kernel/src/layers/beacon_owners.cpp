#include "layers/beacon_owners.h"

#include "rig/parts.h"

namespace delos {

std::vector<int> beacon_owners(const System& system, const PlacedDevice& placed,
                               const CandidateScene& all) {
  const TargetMount& mount = *placed.carried();
  std::vector<int> listed;
  for (const std::size_t set : seen_sets(system.beacon_sets, mount.sees))
    listed.insert(listed.end(), all.of_beacon[set].begin(), all.of_beacon[set].end());
  std::vector<int> owners(mount.beacons->size());
  for (std::size_t b = 0; b < owners.size(); ++b)
    owners[b] = listed[mount.beacons->listed(b)];
  return owners;
}

}  // namespace delos
