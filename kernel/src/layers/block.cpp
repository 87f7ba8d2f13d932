#include "layers/block.h"

#include <algorithm>

#include "delos/model/wide.h"
#include "observe/answers.h"
#include "observe/beacon_sightings.h"
#include "observe/measure.h"
#include "observe/point_rows.h"

namespace delos {
namespace {

std::vector<double> fusion_weights(const System& system) {
  std::vector<double> weights;
  for (const PlacedDevice& d : system.devices) {
    weights.push_back(information_weight(system, d));
  }
  return weights;
}

/// S = Σ hᵀ h / r over the rows of independent noise, pose by pose.
void observe_poses(const System& system, const PlacedDevice& placed, int columns,
                   std::span<const TargetPose> poses, double* layer,
                   std::uint64_t& seen, std::uint64_t& perfect) {
  MeasureScratch scratch;
  for (std::size_t lane = 0; lane < poses.size(); ++lane) {
    const std::uint64_t bit = std::uint64_t{1} << lane;
    const auto add = [&](const StateRow& row) {
      if (row.perfect()) {
        perfect |= bit;
        return;
      }
      const double weight = row.weight();
      for (int i = 0; i < columns; ++i) {
        const double scaled = weight * row.h(i);
        for (int j = 0; j <= i; ++j) {
          layer[static_cast<std::size_t>(packed_index(i, j)) * kLanes + lane] +=
              scaled * row.h(j);
        }
      }
    };
    const bool sees = measure(system, placed, poses[lane], columns, scratch, add);
    if (sees) seen |= bit;
  }
}

/// The same of a device on the target and the beacons that it sees.
void observe_beacons(const System& system, const PlacedDevice& placed, int coordinates,
                     std::span<const TargetPose> poses, double* layer,
                     std::uint64_t& seen, std::uint64_t& perfect) {
  BeaconSearch search;
  search.see_each(system, placed, poses,
                  [&](std::size_t lane, const BeaconSightings& sightings) {
                    const std::uint64_t bit = std::uint64_t{1} << lane;
                    double S[packed_index(kMaxCoordinates, 0)] = {};
                    if (!sightings.all.empty()) seen |= bit;
                    if (add_information(sightings, coordinates, S)) perfect |= bit;
                    for (int e = 0; e < packed_index(coordinates, 0); ++e)
                      layer[static_cast<std::size_t>(e) * kLanes + lane] = S[e];
                  });
}

/// The same for all poses side by side, where the device has an entry for that.
bool observe_lanes(const System& system, const PlacedDevice& placed,
                   std::span<const TargetPose> poses, double* layer,
                   std::uint64_t& seen, std::uint64_t& perfect) {
  PointRows rows;
  for (const PlacedMarker& marker : system.markers) {
    if (!observe_rows(system, placed, marker, poses, nullptr, rows)) return false;
    add_information(rows, system.motion.layout.coordinates(), rows.seen(), layer);
    seen |= rows.seen();
    perfect |= rows.perfect & rows.seen();
  }
  return true;
}

}  // namespace

LayerShape::LayerShape(const System& system)
    : devices(system.devices.size()),
      groups((devices + kGroup - 1) / kGroup),
      columns(information_size(system)),
      coordinates(system.motion.layout.coordinates()),
      prior(system.prior),
      stride(static_cast<std::size_t>(packed_index(columns, 0)) * kLanes),
      weights(fusion_weights(system)) {}

void size_block(const LayerShape& shape, int lanes, LayerBlock& block) {
  block.lanes = lanes;
  block.layers.resize(shape.devices * shape.stride);
  block.groups.resize(shape.groups * shape.stride);
  block.total.resize(shape.stride);
  block.seen.assign(shape.devices, 0);
  block.perfect.assign(shape.devices, 0);
}

void clear_block(const LayerShape& shape, int lanes, LayerBlock& block) {
  size_block(shape, lanes, block);
  std::fill(block.layers.begin(), block.layers.end(), 0.0);
}

void observe_device(const System& system, const LayerShape& shape, std::size_t device,
                    std::span<const TargetPose> poses, LayerBlock& block) {
  const PlacedDevice& placed = system.devices[device];
  double* layer = block.layers.data() + device * shape.stride;
  std::fill_n(layer, shape.stride, 0.0);
  std::uint64_t &seen = block.seen[device], &perfect = block.perfect[device];
  seen = perfect = 0;
  if (placed.sees_beacons()) {
    observe_beacons(system, placed, system.motion.layout.coordinates(), poses, layer,
                    seen, perfect);
    return;
  }
  if (observe_lanes(system, placed, poses, layer, seen, perfect)) return;
  observe_poses(system, placed, shape.columns, poses, layer, seen, perfect);
}

void sum_group(const LayerShape& shape, std::size_t group, LayerBlock& block) {
  double* sum = block.groups.data() + group * shape.stride;
  std::fill_n(sum, shape.stride, 0.0);
  const std::size_t end = std::min(shape.devices, (group + 1) * kGroup);
  in_wide_vectors([&] {
    for (std::size_t i = group * kGroup; i < end; ++i) {
      if (!block.seen[i]) continue;
      const double* layer = block.layers.data() + i * shape.stride;
      const double weight = shape.weights[i];
      for (std::size_t e = 0; e < shape.stride; ++e) sum[e] += weight * layer[e];
    }
  });
}

void sum_total(const LayerShape& shape, LayerBlock& block) {
  std::fill_n(block.total.data(), shape.stride, 0.0);
  for (int k = 0; k < shape.coordinates; ++k)
    std::fill_n(&block.total[packed_index(k, k) * kLanes], kLanes, shape.prior);
  for (std::size_t g = 0; g < shape.groups; ++g) {
    const double* sum = block.groups.data() + g * shape.stride;
    for (std::size_t e = 0; e < shape.stride; ++e) block.total[e] += sum[e];
  }
}

void check_total(const System& system, const LayerShape& shape,
                 const LayerBlock& block) {
  const auto finite = [&](const double* layer) {
    double sum = 0;
    for (std::size_t e = 0; e < shape.stride; e += kLanes) {
      for (int l = 0; l < block.lanes; ++l) sum += 0 * layer[e + l];
    }
    return sum == 0;
  };
  if (finite(block.total.data())) return;
  for (std::size_t i = 0; i < shape.devices; ++i) {
    if (block.seen[i] && !finite(block.layers.data() + i * shape.stride))
      blame(system.devices[i],
            "answers with what is beyond the range of a double: an H that is too large "
            "or isn't finite, or too little noise");
  }
}

void sum_layers(const LayerShape& shape, LayerBlock& block) {
  for (std::size_t g = 0; g < shape.groups; ++g) sum_group(shape, g, block);
  sum_total(shape, block);
}

void fill_block(const System& system, const LayerShape& shape,
                std::span<const TargetPose> poses, LayerBlock& block) {
  size_block(shape, static_cast<int>(poses.size()), block);
  for (std::size_t i = 0; i < shape.devices; ++i)
    observe_device(system, shape, i, poses, block);
  sum_layers(shape, block);
  check_total(system, shape, block);
}

}  // namespace delos
