// What each device knows at the nodes of an octree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "delos/parallel/each.h"
#include "delos/sampling/octree.h"
#include "field/cell_views.h"
#include "layers/block.h"

namespace delos {

/// One sighting at one node.
struct NodeFlags {
  bool in_view : 1;  ///< the record holds numbers
  bool hidden : 1;   ///< in view, but something is in the way
  bool perfect : 1;  ///< has rows of no noise, which no record can hold
};

/// Records of all nodes at all orientations.
class NodeStore {
 public:
  /// What is passed is kept by reference.
  NodeStore(const System& system, const Sightings& sightings,
            const std::vector<Eigen::Matrix3d>& orientations);

  [[nodiscard]] std::size_t nodes() const { return nodes_; }
  [[nodiscard]] const double* record(Octree::Index node, std::size_t turn) const {
    return records_.data() + (node * turns() + turn) * sightings_.record;
  }
  [[nodiscard]] const NodeFlags* flags(Octree::Index node, std::size_t turn) const {
    return flags_.data() + (node * turns() + turn) * sightings_.all.size();
  }

  /// What is to be done with up to kLanes new nodes: both functions give, for an
  /// orientation, what was observed there.
  struct Observed {
    std::size_t first_node, count;
    std::function<const LayerBlock&(std::size_t turn)> layers;
    std::function<const TargetPose*(std::size_t turn)> poses;
  };
  using Use = std::function<void(const Observed&)>;

  /// Observe the nodes that the tree has gained, kLanes at a time.
  /// @param first_cell the cells from here on are new: what they see as a whole spares
  ///        rays
  /// @param make_use makes what each thread does with them
  /// @returns whether all were observed; where it was stopped, the store must be shrunk
  bool follow(const Octree& tree, const CellViews& views, Octree::Index first_cell,
              const LoopOptions& loop, const std::function<Use()>& make_use);

  /// Forget the nodes from `nodes` on.
  void shrink(std::size_t nodes);

  [[nodiscard]] std::uint64_t rays() const { return rays_; }
  [[nodiscard]] std::uint64_t rays_saved() const { return rays_saved_; }

 private:
  [[nodiscard]] std::size_t turns() const { return orientations_.size(); }
  void observe(std::size_t first_node, std::size_t turn,
               const std::vector<TargetPose>& poses, const Sight* known,
               LayerBlock& block, std::uint64_t& rays, std::uint64_t& saved);

  const System& system_;
  const Sightings& sightings_;
  const std::vector<Eigen::Matrix3d>& orientations_;
  LayerShape shape_;
  std::size_t nodes_ = 0;
  std::vector<double> records_;
  std::vector<NodeFlags> flags_;
  std::uint64_t rays_ = 0, rays_saved_ = 0;
};

}  // namespace delos
