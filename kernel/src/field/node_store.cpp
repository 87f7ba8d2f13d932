#include "field/node_store.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "observe/point_rows.h"

namespace delos {

NodeStore::NodeStore(const System& system, const Sightings& sightings,
                     const std::vector<Eigen::Matrix3d>& orientations)
    : system_(system),
      sightings_(sightings),
      orientations_(orientations),
      shape_(system) {}

void NodeStore::shrink(std::size_t nodes) {
  nodes_ = nodes;
  records_.resize(nodes * turns() * sightings_.record);
  flags_.resize(nodes * turns() * sightings_.all.size());
}

bool NodeStore::follow(const Octree& tree, const CellViews& views,
                       Octree::Index first_cell, const LoopOptions& loop,
                       const std::function<Use()>& make_use) {
  const std::size_t first = nodes_, count = sightings_.all.size();
  const std::size_t fresh = tree.nodes() - first;
  // What the new cells know of the sight lines to their corners:
  // [node][turn][sighting].
  std::vector<Sight> known(fresh * turns() * count, Sight::unknown);
  for (auto c = first_cell; c < tree.cells().size(); ++c) {
    if (tree.cells()[c].level == 0) continue;
    for (const Octree::Index node : tree.corners(c)) {
      if (node < first) continue;
      for (std::size_t t = 0; t < turns(); ++t) {
        for (std::size_t s = 0; s < count; ++s) {
          const Sight sight = views.at(c, t, s).sight;
          if (sight == Sight::unknown) continue;
          known[((node - first) * turns() + t) * count + s] = sight;
        }
      }
    }
  }

  shrink(tree.nodes());
  const std::size_t blocks = (fresh + kLanes - 1) / kLanes;
  std::atomic<std::uint64_t> rays = 0, saved = 0;
  const bool whole = each_with(blocks, loop, [&] {
    return [&, use = make_use(), block = LayerBlock{},
            poses = std::vector<TargetPose>(),
            of_block = std::vector<Sight>(count * kLanes)](std::size_t b) mutable {
      const std::size_t begin = b * kLanes;
      const std::size_t lanes = std::min<std::size_t>(kLanes, fresh - begin);
      std::uint64_t rays_here = 0, saved_here = 0;
      const auto layers = [&](std::size_t turn) -> const LayerBlock& {
        poses.clear();
        for (std::size_t l = 0; l < lanes; ++l) {
          const auto node = static_cast<Octree::Index>(first + begin + l);
          poses.push_back({orientations_[turn], tree.position(node)});
          for (std::size_t s = 0; s < count; ++s) {
            of_block[s * kLanes + l] =
                known[((begin + l) * turns() + turn) * count + s];
          }
        }
        observe(first + begin, turn, poses, of_block.data(), block, rays_here,
                saved_here);
        return block;
      };
      use({first + begin, lanes, layers, [&](std::size_t) { return poses.data(); }});
      rays += rays_here;
      saved += saved_here;
    };
  });
  rays_ += rays;
  rays_saved_ += saved;
  return whole;
}

void NodeStore::observe(std::size_t first_node, std::size_t turn,
                        const std::vector<TargetPose>& poses, const Sight* known,
                        LayerBlock& block, std::uint64_t& rays, std::uint64_t& saved) {
  const std::size_t count = sightings_.all.size();
  const auto slot = [&](std::size_t lane) {
    return (first_node + lane) * turns() + turn;
  };
  clear_block(shape_, static_cast<int>(poses.size()), block);
  PointRows rows;
  for (std::size_t s = 0; s < count; ++s) {
    const Sighting& sighting = sightings_.all[s];
    const PlacedDevice& placed = system_.devices[sighting.device];
    double* layer = block.layers.data() + sighting.device * shape_.stride;
    if (!sighting.by_rows) {
      observe_device(system_, shape_, sighting.device, poses, block);
      if (may_be_hidden(system_, placed)) rays += poses.size();
      for (std::size_t l = 0; l < poses.size(); ++l) {
        double* record =
            records_.data() + slot(l) * sightings_.record + sighting.offset;
        for (std::size_t e = 0; e < sighting.numbers; ++e) {
          record[e] = layer[e * kLanes + l];
        }
        flags_[slot(l) * count + s] =
            NodeFlags{(block.seen[sighting.device] >> l & 1) != 0, false,
                      (block.perfect[sighting.device] >> l & 1) != 0};
      }
      continue;
    }
    observe_rows(system_, placed, sighting.marker, poses, known + s * kLanes, rows);
    add_information(rows, sighting.columns, rows.seen(), layer);
    block.seen[sighting.device] |= rows.seen();
    block.perfect[sighting.device] |= rows.perfect & rows.seen();
    rays += rows.rays;
    if (may_be_hidden(system_, placed)) {
      saved += static_cast<std::uint64_t>(std::popcount(rows.in_view)) - rows.rays;
    }
    for (std::size_t l = 0; l < poses.size(); ++l) {
      double* number = records_.data() + slot(l) * sightings_.record + sighting.offset;
      for (int r = 0; r < sighting.rows; ++r) {
        const double scale = std::sqrt(rows.weight[r][l]);
        for (int c = 0; c < sighting.columns; ++c) *number++ = scale * rows.h[r][c][l];
      }
      flags_[slot(l) * count + s] =
          NodeFlags{(rows.in_view >> l & 1) != 0, (rows.hidden >> l & 1) != 0,
                    (rows.perfect >> l & 1) != 0};
    }
  }
  sum_layers(shape_, block);
  check_total(system_, shape_, block);
}

}  // namespace delos
