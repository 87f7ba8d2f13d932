// Layers between the nodes of an octree.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "delos/field/adaptive.h"
#include "field/node_store.h"

namespace delos {

/// A place to interpolate at, in a leaf, or in what was a leaf a level before.
struct Query {
  Octree::Index cell;
  Eigen::Vector3d p;
};

/// What decides whether a sighting in doubt is seen.
enum class DoubtRule {
  nearest,  ///< the nearest corner of the cell
  exact,    ///< a ray
  all_seen,
  all_hidden,
};

/// Fills blocks of layers between nodes.
class Interpolation {
 public:
  /// What is passed is kept by reference.
  Interpolation(const System& system, const Sightings& sightings,
                const std::vector<Eigen::Matrix3d>& orientations, const Octree& tree,
                const CellViews& views, const NodeStore& store);

  /// From now on, nodes that hang on a coarser leaf have that leaf's values.
  void conform();

  /// Layers at up to kLanes places, at one orientation.
  void at(std::span<const Query> queries, std::size_t turn, DoubtRule doubt,
          LayerBlock& block) const;

  /// The same at nodes that the store holds, as their cells would interpolate there:
  /// what isn't interpolated, and what is seen, is taken from the nodes themselves.
  void at_nodes(std::span<const Query> queries, std::span<const Octree::Index> nodes,
                std::size_t turn, LayerBlock& block) const;

 private:
  struct Stencil;
  void fill(std::span<const Query> queries, const Octree::Index* nodes,
            std::size_t turn, DoubtRule doubt, LayerBlock& block) const;
  [[nodiscard]] const double* record(Octree::Index node, std::size_t turn) const;
  [[nodiscard]] bool interpolates(Octree::Index cell, std::size_t turn,
                                  std::size_t sighting) const;
  [[nodiscard]] bool hidden_at_nearest(const Query& query, std::size_t turn,
                                       std::size_t sighting, bool& decided) const;

  const System& system_;
  const Sightings& sightings_;
  const std::vector<Eigen::Matrix3d>& orientations_;
  const Octree& tree_;
  const CellViews& views_;
  const NodeStore& store_;
  LayerShape shape_;
  std::vector<Octree::Index> hanging_;  ///< index of a node's own record, or kNone
  std::vector<double> conforming_;      ///< records of hanging nodes
};

}  // namespace delos
