#include "delos/geometry/occluders.h"

#include <optional>
#include <random>

#include "geometry/mesh/kernel.h"
#include "geometry/mesh/pieces.h"
#include "geometry/mesh/predicates.h"
#include "geometry/occlusion/flat_tree.h"
#include "geometry/occlusion/lane_tests.h"
#include "geometry/occlusion/segment_triangle.h"
#include "geometry/occlusion/shaft_lanes.h"

namespace delos {
namespace {

Kernel::Triangle_3 cgal_triangle(const Corners& t) {
  return {cgal_point(t[0]), cgal_point(t[1]), cgal_point(t[2])};
}

/// How a segment that ends outside of everything leaves its start through a triangle.
enum class Crossing {
  none,
  rising,     ///< from the back of the triangle to the front
  falling,    ///< from the front to the back
  at_start,   ///< the start is on the triangle
  ambiguous,  ///< through an edge or a corner
};

Crossing crossing(const Kernel::Triangle_3& t, const Kernel::Point_3& from,
                  const Kernel::Point_3& to) {
  const auto start = CGAL::orientation(t[0], t[1], t[2], from);
  if (start == CGAL::ZERO && t.has_on(from)) return Crossing::at_start;
  const auto end = CGAL::orientation(t[0], t[1], t[2], to);
  if (start == end && start != CGAL::ZERO) return Crossing::none;
  int left = 0, right = 0;
  for (int i = 0; i < 3; ++i) {
    const auto turn = CGAL::orientation(from, to, t[i], t[(i + 1) % 3]);
    left += turn != CGAL::NEGATIVE;
    right += turn != CGAL::POSITIVE;
  }
  if (left < 3 && right < 3) return Crossing::none;
  if (left + right > 3 || start == CGAL::ZERO) return Crossing::ambiguous;
  return start == CGAL::NEGATIVE ? Crossing::rising : Crossing::falling;
}

}  // namespace

struct Occluders::Tree {
  /// It holds its corners, so that a query touches no other memory.
  struct Triangle {
    Corners corners;
    std::uint32_t piece;
  };

  /// Calls visit(triangle) for items of a tree.
  template <class Visit>
  struct Visitor {
    const std::vector<Triangle>& triangles;
    const Visit& visit;

    bool operator()(std::uint32_t item) const { return visit(triangles[item]); }
    void prefetch(std::uint32_t item) const { delos::prefetch(triangles[item]); }
  };

  Tree(const std::vector<TriangleMesh>& parts, const std::vector<char>& hollow);

  FlatTree tree;                    // over the triangles
  std::vector<Triangle> triangles;  // as the tree orders them
  Box bounds;
  std::vector<std::uint32_t> part_of;  // of each piece
  std::vector<char> alone;             // whether a piece is one triangle
  std::vector<Closure> closures;       // of each part

  void add(const TriangleMesh& mesh);

  /// Calls visit(triangle), until it returns true, for those whose boxes enter(node)
  /// accepts.
  template <class Enter, class Visit>
  void walk(const Enter& enter, const Visit& visit) const {
    tree.walk(enter, Visitor<Visit>{triangles, visit});
  }

  /// Calls visit(triangle), until it returns true, for each triangle that s meets.
  template <class Visit>
  void walk_along(const Segment& s, const Visit& visit) const {
    walk(SlabTest(s, tree.origin()),
         [&](const Triangle& t) { return meets(t.corners, s) && visit(t); });
  }

  bool piece_meets(std::uint32_t piece, const Segment& s) const;
  bool piece_meets(std::uint32_t piece, const Box& box) const;
  std::optional<bool> inside_by(const Segment& s) const;
};

Occluders::Tree::Tree(const std::vector<TriangleMesh>& parts,
                      const std::vector<char>& hollow) {
  for (const TriangleMesh& part : parts) add(part);
  for (std::size_t part = 0; part < hollow.size(); ++part)
    if (hollow[part]) closures[part].closed = false;
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const auto& [corners, piece] : triangles) {
    const auto& [a, b, c] = corners;
    boxes.emplace_back(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c));
    bounds.extend(boxes.back());
  }
  tree = FlatTree(boxes);
  std::vector<Triangle> ordered;
  ordered.reserve(triangles.size());
  for (const std::uint32_t t : tree.order()) ordered.push_back(triangles[t]);
  triangles = std::move(ordered);
}

void Occluders::Tree::add(const TriangleMesh& mesh) {
  const Topology topology = topology_of(mesh);
  const Pieces pieces = convex_pieces(mesh, topology);
  const auto first_piece = static_cast<std::uint32_t>(part_of.size());
  const auto part = static_cast<std::uint32_t>(closures.size());
  closures.push_back(closure_of(topology));
  part_of.resize(first_piece + pieces.count, part);
  alone.resize(first_piece + pieces.count, true);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t piece = pieces.of_triangle[t];
    if (t > 0 && piece < pieces.of_triangle[t - 1] + 1) {
      alone[first_piece + piece] = false;
    }
    if (topology.skipped[t]) continue;
    const auto& [i, j, k] = mesh.triangles[t];
    const Corners corners = {mesh.vertices[i], mesh.vertices[j], mesh.vertices[k]};
    if (collinear(corners[0], corners[1], corners[2])) continue;
    triangles.push_back({corners, first_piece + piece});
  }
}

/// Whether a piece's surface meets s.
bool Occluders::Tree::piece_meets(std::uint32_t piece, const Segment& s) const {
  bool found = false;
  walk(SlabTest(s, tree.origin()), [&](const Triangle& t) {
    return found = t.piece == piece && meets(t.corners, s);
  });
  return found;
}

/// Whether a piece's surface meets a box.
bool Occluders::Tree::piece_meets(std::uint32_t piece, const Box& box) const {
  const CGAL::Bbox_3 query(box.min().x(), box.min().y(), box.min().z(), box.max().x(),
                           box.max().y(), box.max().z());
  bool found = false;
  walk(OverlapTest(box, tree.origin()), [&](const Triangle& t) {
    return found =
               t.piece == piece && CGAL::do_intersect(cgal_triangle(t.corners), query);
  });
  return found;
}

/// Whether the start of a segment that ends outside of everything is in a closed part;
/// nullopt where the segment meets an edge or a corner.
std::optional<bool> Occluders::Tree::inside_by(const Segment& s) const {
  const auto from = cgal_point(s.a), to = cgal_point(s.b);
  std::vector<int> winding(closures.size());
  bool on_surface = false, ambiguous = false;
  walk(SlabTest(s, tree.origin()), [&](const Triangle& t) {
    const std::uint32_t part = part_of[t.piece];
    if (!closures[part].closed) return false;
    const Crossing c = crossing(cgal_triangle(t.corners), from, to);
    winding[part] += (c == Crossing::rising) - (c == Crossing::falling);
    ambiguous |= c == Crossing::ambiguous;
    return on_surface |= c == Crossing::at_start;
  });
  if (on_surface) return true;
  if (ambiguous) return std::nullopt;
  for (std::size_t part = 0; part < winding.size(); ++part) {
    // Crossings are odd in number where their sum is odd.
    if (closures[part].oriented ? winding[part] != 0 : winding[part] % 2 != 0) {
      return true;
    }
  }
  return false;
}

Occluders::Occluders() : Occluders(std::vector<TriangleMesh>()) {}

Occluders::Occluders(const std::vector<TriangleMesh>& parts,
                     const std::vector<char>& hollow)
    : tree_(std::make_shared<Tree>(parts, hollow)) {}

bool Occluders::blocks(const Point& a, const Point& b, double skin) const {
  const auto segment = shortened(a, b, skin);
  if (!segment) return false;
  bool found = false;
  tree_->walk_along(*segment, [&](const Tree::Triangle&) { return found = true; });
  return found;
}

bool Occluders::touches_shaft(const Point& apex, const Box& box) const {
  const Shaft shaft(apex, box);
  bool found = false;
  tree_->walk(ShaftTest(shaft, tree_->tree.origin()), [&](const Tree::Triangle& t) {
    return found = shaft.may_meet(t.corners);
  });
  return found;
}

/// A convex piece that meets the segments from the apex to all corners of a box meets
/// those to every point of it. Where its surface stays farther than skin from both
/// ends, shortening takes nothing away.
///
/// Shortening rounds, though: the segment that blocks() tests misses the true one by a
/// few units in the last place, and a piece just beyond the skin magnifies that at the
/// far end by distance/skin. A box that is larger by as much makes up for it.
bool Occluders::hides(const Point& apex, const Box& box, double skin) const {
  Box around = box;
  around.extend(apex);
  const double distance = around.diagonal().norm();
  double margin = 0;
  if (skin > 0) {
    const double scale = std::max(around.min().cwiseAbs().maxCoeff(),
                                  around.max().cwiseAbs().maxCoeff());
    margin =
        16 * std::numeric_limits<double>::epsilon() * scale * (1 + distance / skin);
    if (!(margin < distance)) return false;
  }
  const auto grown = [](const Box& b, double by) {
    return Box(b.min().array() - by, b.max().array() + by);
  };
  const Box target = grown(box, margin);
  const double keep_off = skin * (1 + 1e-9) + margin;
  const Box near = grown(Box(apex, apex), keep_off), far = grown(box, keep_off);

  const auto covers = [&](const Tree::Triangle& t) {
    for (int i = 0; i < 8; ++i) {
      const Segment s{apex, target.corner(static_cast<Box::CornerType>(i))};
      if (tree_->alone[t.piece] ? !meets(t.corners, s)
                                : !tree_->piece_meets(t.piece, s)) {
        return false;
      }
    }
    return !tree_->piece_meets(t.piece, near) && !tree_->piece_meets(t.piece, far);
  };

  bool found = false;
  std::optional<std::uint32_t> refused;  // a body is met where it is entered and left
  tree_->walk_along({apex, box.center()}, [&](const Tree::Triangle& t) {
    if (t.piece == refused) return false;
    found = covers(t);
    refused = t.piece;
    return found;
  });
  return found;
}

bool Occluders::contains(const Point& p) const {
  if (!tree_->bounds.contains(p)) return false;
  // Upward, and where that meets an edge or a corner, some other way: a direction drawn
  // at random meets them hardly ever.
  Eigen::Vector3d direction(0, 0, 1);
  std::minstd_rand random;
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double length = 2 * (tree_->bounds.diagonal().norm() + p.norm());
  for (;;) {
    const auto inside = tree_->inside_by({p, p + length * direction.normalized()});
    if (inside) return *inside;
    direction = {uniform(random), uniform(random), uniform(random)};
  }
}

std::size_t Occluders::triangles() const { return tree_->triangles.size(); }
std::uint32_t Occluders::pieces() const {
  return static_cast<std::uint32_t>(tree_->part_of.size());
}
Occluders::Box Occluders::bounds() const { return tree_->bounds; }

}  // namespace delos
