#include "delos/device/beacons.h"

#include <cmath>
#include <cstdint>

#include "delos/sampling/samples.h"
#include "delos/scene/scene.h"
#include "scene/beacon_grid.h"

namespace delos {
namespace {

bool is_lit(const BeaconGrid& grid, const LitBeacon& beacon) {
  const bool even_column = beacon.panel.x() % 2 == 0;
  const bool even_row = beacon.panel.y() % 2 == 0;
  switch (grid.pattern) {
    case BeaconPattern::full:
      return true;
    case BeaconPattern::half:
      return even_row;
    case BeaconPattern::columns:
      return even_column;
    case BeaconPattern::checkerboard:
      return even_row == even_column;
  }
  return true;
}

/// The places that are lit, each with what it has of its own.
std::vector<BeaconEntry> lit_entries(const BeaconSet& set) {
  if (const auto* list = std::get_if<BeaconList>(&set.layout)) return list->entries;
  std::vector<BeaconEntry> lit;
  for (const LitBeacon& beacon : lit_beacons(std::get<BeaconGrid>(set.layout)))
    lit.push_back({beacon.p, std::nullopt, 1});
  return lit;
}

}  // namespace

std::vector<LitBeacon> lit_beacons(const BeaconGrid& grid) {
  const Samples all = make_samples({{"", grid.box}});
  const auto& counts = std::get<GridShape>(all.parts.front().shape).counts;
  std::vector<LitBeacon> lit;
  for (std::size_t n = 0; n < all.points.size(); ++n) {
    const auto at = static_cast<std::int64_t>(n);
    const LitBeacon beacon{all.points[n],
                           {at % counts.x() / grid.panel.x(),
                            at / counts.x() % counts.y() / grid.panel.y()}};
    if (is_lit(grid, beacon)) lit.push_back(beacon);
  }
  return lit;
}

std::vector<Beacon> lit_beacons(const BeaconSet& set) {
  std::vector<Beacon> beacons;
  for (const BeaconEntry& entry : lit_entries(set)) {
    Beacon beacon;
    beacon.p = entry.p;
    const auto& normal = entry.normal ? entry.normal : set.normal;
    if (normal) beacon.normal = normal->stableNormalized();
    beacon.cos_emission = std::cos(set.emission);
    beacon.range = set.range;
    beacon.weight = set.weight * entry.weight;
    beacons.push_back(beacon);
  }
  return beacons;
}

}  // namespace delos
