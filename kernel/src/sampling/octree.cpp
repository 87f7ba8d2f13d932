#include "delos/sampling/octree.h"

#include <algorithm>
#include <cmath>

namespace delos {
namespace {

/// Roots are as near to cubes as at most this many along the longest axis allow.
constexpr double kMostRoots = 8;

std::uint64_t key_of(const Octree::Lattice& at) {
  return static_cast<std::uint64_t>(at.x()) | static_cast<std::uint64_t>(at.y()) << 21 |
         static_cast<std::uint64_t>(at.z()) << 42;
}

}  // namespace

Octree::Octree(const Eigen::AlignedBox3d& box, int depth) : box_(box), depth_(depth) {
  const Eigen::Vector3d sizes = box.sizes();
  const double edge = std::max(sizes.minCoeff(), sizes.maxCoeff() / kMostRoots);
  for (int i = 0; i < 3; ++i) {
    roots_(i) = std::max(1, static_cast<int>(std::lround(sizes(i) / edge)));
    extent_(i) = roots_(i) * size_of(0);
  }
  for (int k = 0; k < roots_.z(); ++k) {
    for (int j = 0; j < roots_.y(); ++j) {
      for (int i = 0; i < roots_.x(); ++i) {
        cells_.push_back({Lattice(i, j, k) * size_of(0), 0, kNone, kNone, kNone});
      }
    }
  }
  const auto roots = static_cast<Index>(cells_.size());
  for (Index c = 0; c < roots; ++c) halve(c);
}

Eigen::Vector3d Octree::place(const Lattice& at) const {
  Eigen::Vector3d p;
  for (int i = 0; i < 3; ++i) {
    // Both ends come out exactly.
    const double t = static_cast<double>(at(i)) / extent_(i);
    p(i) = (1 - t) * box_.min()(i) + t * box_.max()(i);
  }
  return p;
}

std::vector<Octree::Index> Octree::leaves() const {
  std::vector<Index> all;
  for (Index c = 0; c < cells_.size(); ++c) {
    if (is_leaf(c)) all.push_back(c);
  }
  return all;
}

Eigen::AlignedBox3d Octree::box_of(Index cell) const {
  const Cell& c = cells_[cell];
  const Lattice far = c.corner + Lattice::Constant(size_of(c.level));
  return {place(c.corner), place(far)};
}

Octree::Corners Octree::corners(Index cell) const {
  const Family& family = family_of(cell);
  const Index which = cell - cells_[cells_[cell].parent].first_child;
  const Index x = which & 1, y = which >> 1 & 1, z = which >> 2 & 1;
  Corners all;
  for (Index i = 0; i < 8; ++i) {
    all[i] = family[(x + (i & 1)) + 3 * (y + (i >> 1 & 1)) + 9 * (z + (i >> 2 & 1))];
  }
  return all;
}

Eigen::Vector3d Octree::within_family(Index cell, const Eigen::Vector3d& p) const {
  const Cell& parent = cells_[cells_[cell].parent];
  const std::int32_t half = size_of(parent.level) / 2;
  Eigen::Vector3d at;
  for (int i = 0; i < 3; ++i) {
    const double t = (p(i) - box_.min()(i)) / (box_.max()(i) - box_.min()(i));
    at(i) = (t * extent_(i) - parent.corner(i)) / half;
  }
  return at;
}

Octree::Index Octree::leaf_of(const Lattice& finest) const {
  const Lattice root = finest / size_of(0);
  auto c =
      static_cast<Index>(root.x() + roots_.x() * (root.y() + roots_.y() * root.z()));
  while (!is_leaf(c)) {
    const Cell& cell = cells_[c];
    const std::int32_t half = size_of(cell.level) / 2;
    const Lattice upper = (finest - cell.corner) / half;
    c = cell.first_child +
        static_cast<Index>(upper.x() + 2 * upper.y() + 4 * upper.z());
  }
  return c;
}

Octree::Index Octree::leaf_at(const Eigen::Vector3d& p) const {
  Lattice finest;
  for (int i = 0; i < 3; ++i) {
    const double t = (p(i) - box_.min()(i)) / (box_.max()(i) - box_.min()(i));
    const double step = std::floor(t * extent_(i));
    finest(i) = static_cast<std::int32_t>(std::clamp(step, 0.0, extent_(i) - 1.0));
  }
  return leaf_of(finest);
}

Octree::Index Octree::coarsest_leaf_at(Index node) const {
  Index coarsest = kNone;
  for (int corner = 0; corner < 8; ++corner) {
    const Lattice at =
        nodes_[node] - Lattice(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    if ((at.array() < 0).any() || (at.array() >= extent_.array()).any()) continue;
    const Index leaf = leaf_of(at);
    if (coarsest == kNone || cells_[leaf].level < cells_[coarsest].level)
      coarsest = leaf;
  }
  return coarsest;
}

bool Octree::in_family_lattice(Index cell, Index node) const {
  const Cell& parent = cells_[cells_[cell].parent];
  const std::int32_t half = size_of(parent.level) / 2;
  const Lattice from = nodes_[node] - parent.corner;
  for (int i = 0; i < 3; ++i) {
    if (from(i) < 0 || from(i) > 2 * half || from(i) % half != 0) return false;
  }
  return true;
}

std::vector<Octree::Index> Octree::closed(std::span<const Index> marked) const {
  std::vector<bool> taken(cells_.size(), false);
  std::vector<Index> all, open(marked.begin(), marked.end());
  while (!open.empty()) {
    const Index c = open.back();
    open.pop_back();
    const Cell& cell = cells_[c];
    if (cell.level >= depth_ || taken[c]) continue;
    taken[c] = true;
    all.push_back(c);
    // Its children must not touch leaves that are coarser than itself.
    const std::int32_t size = size_of(cell.level);
    for (int k = -1; k <= 1; ++k) {
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          const Lattice beside = cell.corner + Lattice(i, j, k) * size;
          if ((beside.array() < 0).any() || (beside.array() >= extent_.array()).any())
            continue;
          const Index leaf = leaf_of(beside);
          if (cells_[leaf].level < cell.level) open.push_back(leaf);
        }
      }
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

Octree::Index Octree::refine(std::span<const Index> marked) {
  const auto first = static_cast<Index>(cells_.size());
  for (const Index c : marked) halve(c);
  return first;
}

void Octree::revert(Index first_cell, std::size_t nodes) {
  for (std::size_t n = nodes; n < nodes_.size(); ++n) node_of_.erase(key_of(nodes_[n]));
  nodes_.resize(nodes);
  for (Index c = first_cell; c < cells_.size(); c += 8) {
    Cell& parent = cells_[cells_[c].parent];
    parent.first_child = parent.family = kNone;
    families_.pop_back();
  }
  cells_.resize(first_cell);
}

Octree::Index Octree::node_at(const Lattice& at) {
  const auto [entry, fresh] =
      node_of_.try_emplace(key_of(at), static_cast<Index>(nodes_.size()));
  if (fresh) nodes_.push_back(at);
  return entry->second;
}

void Octree::halve(Index cell) {
  const Lattice corner = cells_[cell].corner;
  const std::int32_t level = cells_[cell].level, half = size_of(level) / 2;
  cells_[cell].first_child = static_cast<Index>(cells_.size());
  cells_[cell].family = static_cast<Index>(families_.size());
  for (int i = 0; i < 8; ++i) {
    const Lattice offset = Lattice(i & 1, i >> 1 & 1, i >> 2 & 1) * half;
    cells_.push_back({corner + offset, level + 1, cell, kNone, kNone});
  }
  Family family;
  for (int n = 0; n < 27; ++n) {
    family[static_cast<std::size_t>(n)] =
        node_at(corner + Lattice(n % 3, n / 3 % 3, n / 9) * half);
  }
  families_.push_back(family);
}

}  // namespace delos
