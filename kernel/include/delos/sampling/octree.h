// An octree over a box: cells, and the nodes that they share.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "delos/api.h"

namespace delos {

/// Cells of a box, each halved along x, y and z where somebody asks for it; what
/// touches differs by one level at most. Positions are whole numbers of the finest
/// step, so that neighbours share their nodes exactly.
///
/// A *family* is the eight children of a cell: their corners are a lattice of 3×3×3
/// nodes, on which triquadratic functions are given. The roots are halved from the
/// start, so that every leaf belongs to a family.
class DELOS_API Octree {
 public:
  using Index = std::uint32_t;
  using Lattice = Eigen::Matrix<std::int32_t, 3, 1>;  ///< in finest steps
  static constexpr Index kNone = ~Index{0};
  /// Nodes of a family, and corners of a cell: x varies fastest.
  using Family = std::array<Index, 27>;
  using Corners = std::array<Index, 8>;

  struct Cell {
    Lattice corner;          ///< its least corner
    std::int32_t level = 0;  ///< halvings of a root
    Index parent = kNone;
    Index first_child = kNone;  ///< the eight stand together; none: a leaf
    Index family = kNone;       ///< of its children
  };

  /// @param box metres, not empty along any axis
  /// @param depth the most halvings, 1 to kMaxDepth
  Octree(const Eigen::AlignedBox3d& box, int depth);
  static constexpr int kMaxDepth = 12;

  [[nodiscard]] const Eigen::AlignedBox3d& box() const { return box_; }
  [[nodiscard]] int depth() const { return depth_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  [[nodiscard]] bool is_leaf(Index cell) const {
    return cells_[cell].first_child == kNone;
  }
  [[nodiscard]] std::vector<Index> leaves() const;

  [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }
  [[nodiscard]] const Lattice& node(Index n) const { return nodes_[n]; }
  [[nodiscard]] Eigen::Vector3d position(Index n) const { return place(nodes_[n]); }

  /// The box of a cell, metres.
  [[nodiscard]] Eigen::AlignedBox3d box_of(Index cell) const;
  [[nodiscard]] Corners corners(Index cell) const;
  /// The lattice of a leaf's family. @pre cell isn't a root
  [[nodiscard]] const Family& family_of(Index cell) const {
    return families_[cells_[cells_[cell].parent].family];
  }
  /// Where p is within the lattice of a leaf's family, 0 to 2 along each axis.
  [[nodiscard]] Eigen::Vector3d within_family(Index cell,
                                              const Eigen::Vector3d& p) const;

  /// The leaf that holds p; of several that touch it, one. @pre p is in the box
  [[nodiscard]] Index leaf_at(const Eigen::Vector3d& p) const;
  /// The largest leaf that touches a node.
  [[nodiscard]] Index coarsest_leaf_at(Index node) const;
  /// Whether a node is one of the lattice of a leaf's family.
  [[nodiscard]] bool in_family_lattice(Index cell, Index node) const;

  /// These leaves and those that must be halved with them, ascending. Leaves of the
  /// deepest level are left out.
  [[nodiscard]] std::vector<Index> closed(std::span<const Index> marked) const;
  /// Halve leaves. @param marked what closed() returned
  /// @returns the first of the new cells, which stand together to the end
  Index refine(std::span<const Index> marked);
  /// Take the last refine() back. @param nodes how many there were before it
  void revert(Index first_cell, std::size_t nodes);

 private:
  [[nodiscard]] Eigen::Vector3d place(const Lattice& at) const;
  [[nodiscard]] Index leaf_of(const Lattice& finest) const;
  [[nodiscard]] std::int32_t size_of(int level) const {
    return 1 << (depth_ + 1 - level);
  }
  Index node_at(const Lattice& at);
  void halve(Index cell);

  Eigen::AlignedBox3d box_;
  int depth_;
  Lattice roots_;   ///< along each axis
  Lattice extent_;  ///< the box in finest steps
  std::vector<Cell> cells_;
  std::vector<Family> families_;
  std::vector<Lattice> nodes_;
  std::unordered_map<std::uint64_t, Index> node_of_;
};

}  // namespace delos
