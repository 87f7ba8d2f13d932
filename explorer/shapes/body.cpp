#include "shapes/body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace delos::shapes {
namespace {

/// Corners of a cell: bits 0, 1, 2 are steps along x, y, z. Of each tetrahedron they go
/// from the first to the last corner along one axis after another, so that those of
/// neighbouring cells meet in whole triangles.
struct Tetrahedron {
  std::array<std::size_t, 4> corners;
  bool right_handed;  ///< edges from the first corner
};
constexpr std::array<Tetrahedron, 6> kTetrahedra{{{{0, 1, 3, 7}, true},
                                                  {{0, 1, 5, 7}, false},
                                                  {{0, 2, 3, 7}, false},
                                                  {{0, 2, 6, 7}, true},
                                                  {{0, 4, 5, 7}, true},
                                                  {{0, 4, 6, 7}, false}}};

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Where a value is: below the lower level (0), between (1), or above the upper (2). So
/// level l lies between sides l and l + 1.
using Side = int;

struct Corner {
  std::size_t node;
  Eigen::Vector3d at;
  double value;
  Side side;
};
using Cell = std::array<Corner, 8>;

/// Makes vertices, each once. Those of a node and of the edges that begin there have
/// places of their own; only two layers of nodes are in reach of a layer of cells.
class Vertices {
 public:
  Vertices(ShapeMesh& shape, std::array<double, 2> levels, std::size_t nodes_of_layer)
      : shape_(shape), levels_(levels), nodes_(nodes_of_layer) {
    for (auto& layer : known_) layer.assign(kPlaces * nodes_, kNone);
  }

  void next_layer() {
    std::swap(known_[0], known_[1]);
    std::ranges::fill(known_[1], kNone);
    ++layer_;
  }

  std::uint32_t of_node(const Corner& corner) {
    std::uint32_t& known = place(corner.node, 0);
    if (known == kNone) known = add(corner.at, corner.value);
    return known;
  }

  /// Where an edge crosses a level. @param bits of the corners, one within the other
  std::uint32_t of_edge(const Cell& cell, std::size_t a, std::size_t b,
                        std::size_t level) {
    if (a > b) std::swap(a, b);
    const Corner &from = cell[a], &to = cell[b];
    std::uint32_t& known = place(from.node, 8 * level + (b - a));
    if (known == kNone) {
      const double t = (levels_[level] - from.value) / (to.value - from.value);
      known = add(from.at + t * (to.at - from.at), levels_[level]);
    }
    return known;
  }

 private:
  /// The node itself, and seven edges from it for each level.
  static constexpr std::size_t kPlaces = 16;

  std::uint32_t& place(std::size_t node, std::size_t which) {
    const std::size_t layer = node / nodes_ - layer_;
    return known_[layer][kPlaces * (node % nodes_) + which];
  }
  std::uint32_t add(const Eigen::Vector3d& at, double value) {
    shape_.mesh.vertices.push_back(at);
    shape_.values.push_back(value);
    return static_cast<std::uint32_t>(shape_.values.size() - 1);
  }

  ShapeMesh& shape_;
  std::array<double, 2> levels_;
  std::size_t nodes_, layer_ = 0;
  std::array<std::vector<std::uint32_t>, 2> known_;
};

class Cutter {
 public:
  Cutter(const ScalarGrid& grid, double low, double high, bool capped)
      : grid_(grid),
        low_(low),
        high_(high),
        capped_(capped),
        n_{static_cast<std::size_t>(grid.grid.counts.x()),
           static_cast<std::size_t>(grid.grid.counts.y()),
           static_cast<std::size_t>(grid.grid.counts.z())},
        strides_{1, n_[0], n_[0] * n_[1]},
        vertices_(shape_, {low, high}, strides_[2]) {}

  ShapeMesh cut(const std::atomic<bool>* stop) {
    for (std::size_t z = 0; z + 1 < n_[2] && !(stop && *stop); ++z) {
      for (std::size_t y = 0; y + 1 < n_[1]; ++y)
        for (std::size_t x = 0; x + 1 < n_[0]; ++x) cut_cell({x, y, z});
      vertices_.next_layer();
    }
    shape_.caps = shape_.mesh.triangles.size();
    shape_.mesh.triangles.insert(shape_.mesh.triangles.end(), caps_.begin(),
                                 caps_.end());
    set_normals(shape_);
    return std::move(shape_);
  }

 private:
  using Place = std::array<std::size_t, 3>;

  [[nodiscard]] std::size_t node(const Place& at) const {
    return at[0] + strides_[1] * at[1] + strides_[2] * at[2];
  }
  [[nodiscard]] std::size_t corner(std::size_t first, std::size_t bits) const {
    return first + (bits & 1) + strides_[1] * (bits >> 1 & 1) +
           strides_[2] * (bits >> 2);
  }

  /// Whether a cell has a value at all corners.
  [[nodiscard]] bool whole(std::size_t first) const {
    for (std::size_t c = 0; c < 8; ++c)
      if (!std::isfinite(grid_.value[corner(first, c)])) return false;
    return true;
  }

  [[nodiscard]] Side side_of(double value) const {
    return value < low_ ? 0 : value > high_ ? 2 : 1;
  }

  void cut_cell(const Place& place) {
    const std::size_t first = node(place);
    if (!whole(first)) return;
    Side least = 2, greatest = 0;
    for (std::size_t c = 0; c < 8; ++c) {
      const Side side = side_of(grid_.value[corner(first, c)]);
      least = std::min(least, side);
      greatest = std::max(greatest, side);
    }
    if (least == greatest && (least != 1 || !capped_)) return;
    const std::array<bool, 6> open =
        capped_ ? open_faces(place) : std::array<bool, 6>{};
    if (least == greatest && std::ranges::count(open, true) == 0) return;
    const Cell cell = cell_at(place, first);
    if (least < greatest)
      for (const Tetrahedron& t : kTetrahedra)
        for (const std::size_t level : {0u, 1u}) cut(cell, t, level);
    for (std::size_t face = 0; face < 6; ++face)
      if (open[face]) cap(cell, face / 2, face % 2 == 1);
  }

  /// Faces towards lower x, higher x, lower y, …, beyond which there is no cell.
  [[nodiscard]] std::array<bool, 6> open_faces(const Place& place) const {
    std::array<bool, 6> open;
    const std::size_t first = node(place);
    for (std::size_t k = 0; k < 3; ++k) {
      open[2 * k] = place[k] == 0 || !whole(first - strides_[k]);
      open[2 * k + 1] = place[k] + 2 >= n_[k] || !whole(first + strides_[k]);
    }
    return open;
  }

  [[nodiscard]] Cell cell_at(const Place& place, std::size_t first) const {
    Cell cell;
    for (std::size_t c = 0; c < 8; ++c) {
      cell[c].node = corner(first, c);
      cell[c].at = grid_.grid.origin +
                   Eigen::Vector3d(static_cast<double>(place[0] + (c & 1)),
                                   static_cast<double>(place[1] + (c >> 1 & 1)),
                                   static_cast<double>(place[2] + (c >> 2)))
                       .cwiseProduct(grid_.grid.step);
      cell[c].value = grid_.value[cell[c].node];
      cell[c].side = side_of(cell[c].value);
    }
    return cell;
  }

  /// The level in a tetrahedron. With lower corners before upper ones in right-handed
  /// order its triangles face upwards. Which way they face is told from the order of
  /// corners alone, so that it holds where a triangle has no area.
  void cut(const Cell& cell, const Tetrahedron& t, std::size_t level) {
    std::array<std::size_t, 4> order{};
    std::size_t lower = 0, upper = 0;
    bool upwards = t.right_handed;
    std::array<std::size_t, 4> above{};
    for (const std::size_t c : t.corners)
      if (cell[c].side <= static_cast<Side>(level)) {
        order[lower++] = c;
        if (upper % 2 == 1) upwards = !upwards;
      } else {
        above[upper++] = c;
      }
    if (lower == 0 || upper == 0) return;
    std::copy_n(above.begin(), upper, order.begin() + lower);
    const auto& [p, q, r, s] = order;
    const auto on = [&](std::size_t a, std::size_t b) {
      return vertices_.of_edge(cell, a, b, level);
    };
    // The body is above the lower level, and below the upper one.
    const bool outwards = upwards == (level == 1);
    if (lower == 1) return triangle({on(p, q), on(p, r), on(p, s)}, outwards);
    if (upper == 1) return triangle({on(p, s), on(q, s), on(r, s)}, outwards);
    const std::array<std::uint32_t, 4> quad{on(p, r), on(p, s), on(q, s), on(q, r)};
    triangle({quad[0], quad[1], quad[2]}, outwards);
    triangle({quad[0], quad[2], quad[3]}, outwards);
  }

  void triangle(std::array<std::uint32_t, 3> t, bool outwards) {
    if (!outwards) std::swap(t[1], t[2]);
    shape_.mesh.triangles.push_back(t);
  }

  /// What the body has of a face of a cell: of its two triangles the part between the
  /// levels.
  void cap(const Cell& cell, std::size_t axis, bool far) {
    const std::size_t base = far ? 1u << axis : 0, a = 1u << (axis + 1) % 3,
                      b = 1u << (axis + 2) % 3, last = base + a + b;
    for (std::array<std::size_t, 3> t :
         {std::array<std::size_t, 3>{base, base + a, last}, {base, last, base + b}}) {
      if (!far) std::swap(t[1], t[2]);
      cap(cell, t);
    }
  }

  void cap(const Cell& cell, const std::array<std::size_t, 3>& t) {
    std::array<std::uint32_t, 7> polygon;
    std::size_t n = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = t[k], b = t[(k + 1) % 3];
      const Side from = cell[a].side, to = cell[b].side;
      if (from == 1) polygon[n++] = vertices_.of_node(cell[a]);
      // The levels in the order in which they are met.
      for (Side level = from; level < to; ++level)
        polygon[n++] = vertices_.of_edge(cell, a, b, static_cast<std::size_t>(level));
      for (Side level = from - 1; level >= to; --level)
        polygon[n++] = vertices_.of_edge(cell, a, b, static_cast<std::size_t>(level));
    }
    for (std::size_t k = 2; k < n; ++k)
      caps_.push_back({polygon[0], polygon[k - 1], polygon[k]});
  }

  const ScalarGrid& grid_;
  double low_, high_;
  bool capped_;
  std::array<std::size_t, 3> n_, strides_;
  ShapeMesh shape_;
  Vertices vertices_;
  std::vector<std::array<std::uint32_t, 3>> caps_;
};

}  // namespace

ShapeMesh isosurface(const ScalarGrid& grid, double level,
                     const std::atomic<bool>* stop) {
  return Cutter(grid, -std::numeric_limits<double>::infinity(), level, false).cut(stop);
}

ShapeMesh body_between(const ScalarGrid& grid, double low, double high,
                       const std::atomic<bool>* stop) {
  return Cutter(grid, low, high, true).cut(stop);
}

}  // namespace delos::shapes
