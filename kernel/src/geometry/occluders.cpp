#include "delos/geometry/occluders.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include <random>

#include "geometry/kernel.h"
#include "geometry/pieces.h"
#include "geometry/segment.h"
#include "geometry/shaft.h"

namespace delos {
namespace {

/// A triangle of the tree. It holds its corners, so that a query touches no other
/// memory.
struct Primitive {
  using Id = std::uint32_t;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Triangle_3;
  using Point_reference = const Point&;
  using Datum_reference = const Datum&;

  Datum_reference datum() const { return triangle; }
  Point_reference reference_point() const { return triangle[0]; }
  Id id() const { return piece; }

  Datum triangle;
  std::uint32_t piece;
};

using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Node = CGAL::AABB_node<CGAL::AABB_traits<Kernel, Primitive>>;

CGAL::Bbox_3 bbox_of(const Occluders::Box& b) {
  return {b.min().x(), b.min().y(), b.min().z(), b.max().x(), b.max().y(), b.max().z()};
}

Eigen::Vector3d eigen_point(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

/// What the tree asks while it is walked: which nodes to enter (`Enter` of a node's
/// box), and what to do with triangles, until `Visit` says that it has seen enough.
template <class Enter, class Visit>
class Walk {
 public:
  Walk(Enter enter, Visit visit) : enter_(std::move(enter)), visit_(std::move(visit)) {}

  bool go_further() const { return !done_; }
  bool do_intersect(const Walk&, const Node& node) const {
    // Both children, nodes or triangles, lie side by side. Walking waits for memory
    // more than for anything else, so ask for them before it is known whether they
    // matter.
    const auto* children = reinterpret_cast<const char*>(&node.left_child());
    for (int line = 0; line < 3; ++line) __builtin_prefetch(children + 64 * line);
    return enter_(node.bbox());
  }
  void intersection(const Walk&, const Primitive& p) { done_ = visit_(p); }

 private:
  Enter enter_;
  Visit visit_;
  bool done_ = false;
};

bool may_meet(const SlabTest& slabs, const CGAL::Bbox_3& box) {
  return slabs.may_meet({box.xmin(), box.ymin(), box.zmin()},
                        {box.xmax(), box.ymax(), box.zmax()});
}

/// By the triangle's box: cheaper than meets(), which it spares for most triangles.
bool may_meet(const SlabTest& slabs, const Kernel::Triangle_3& t) {
  std::array<double, 3> min, max;
  for (int i = 0; i < 3; ++i) {
    min[i] = std::min({t[0][i], t[1][i], t[2][i]});
    max[i] = std::max({t[0][i], t[1][i], t[2][i]});
  }
  return slabs.may_meet(min, max);
}

bool meets(const Primitive& p, const Kernel::Segment_3& segment) {
  return CGAL::do_intersect(p.triangle, segment);
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
  AabbTree aabb;
  Box bounds;
  std::vector<std::uint32_t> part_of;  // of each piece
  std::vector<char> alone;             // whether a piece is one triangle
  std::vector<Closure> closures;       // of each part

  void add(const TriangleMesh& mesh);

  /// Calls visit(primitive), until it returns true, for each triangle that lies in
  /// nodes whose boxes enter() accepts.
  template <class Enter, class Visit>
  void walk(Enter enter, Visit visit) const {
    if (aabb.empty() || !enter(bbox_of(bounds))) return;
    Walk walk(std::move(enter), std::move(visit));
    aabb.traversal(walk, walk);
  }

  /// Calls visit(primitive), until it returns true, for each triangle that s meets.
  template <class Visit>
  void walk_along(const Segment& s, Visit visit) const {
    const Kernel::Segment_3 segment(cgal_point(s.a), cgal_point(s.b));
    const SlabTest slabs(s);
    walk([&](const CGAL::Bbox_3& box) { return may_meet(slabs, box); },
         [&](const Primitive& p) {
           return may_meet(slabs, p.triangle) && meets(p, segment) && visit(p);
         });
  }

  bool piece_meets(std::uint32_t piece, const Segment& s) const;
  bool piece_meets(std::uint32_t piece, const Box& box) const;
};

void Occluders::Tree::add(const TriangleMesh& mesh) {
  const Topology topology = topology_of(mesh);
  const Pieces pieces = convex_pieces(mesh, topology);
  const auto first = static_cast<std::uint32_t>(part_of.size());
  const auto part = static_cast<std::uint32_t>(closures.size());
  closures.push_back(closure_of(topology));
  part_of.resize(first + pieces.count, part);
  alone.resize(first + pieces.count, true);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t > 0 && pieces.of_triangle[t] < pieces.of_triangle[t - 1] + 1) {
      alone[first + pieces.of_triangle[t]] = false;
    }
    if (topology.skipped[t]) continue;
    const auto& [a, b, c] = mesh.triangles[t];
    const Kernel::Triangle_3 triangle(cgal_point(mesh.vertices[a]),
                                      cgal_point(mesh.vertices[b]),
                                      cgal_point(mesh.vertices[c]));
    if (CGAL::collinear(triangle[0], triangle[1], triangle[2])) continue;
    aabb.insert(Primitive{triangle, first + pieces.of_triangle[t]});
    for (const std::uint32_t corner : {a, b, c}) bounds.extend(mesh.vertices[corner]);
  }
}

/// Whether a piece's surface meets s.
bool Occluders::Tree::piece_meets(std::uint32_t piece, const Segment& s) const {
  bool found = false;
  walk_along(s, [&](const Primitive& p) { return found = p.piece == piece; });
  return found;
}

/// Whether a piece's surface meets a box.
bool Occluders::Tree::piece_meets(std::uint32_t piece, const Box& box) const {
  const CGAL::Bbox_3 query = bbox_of(box);
  bool found = false;
  walk([&](const CGAL::Bbox_3& node) { return CGAL::do_overlap(node, query); },
       [&](const Primitive& p) {
         return found = p.piece == piece && CGAL::do_intersect(p.triangle, query);
       });
  return found;
}

Occluders::Occluders() : Occluders(std::vector<TriangleMesh>()) {}

Occluders::Occluders(const std::vector<TriangleMesh>& parts) {
  const auto tree = std::make_shared<Tree>();
  for (const TriangleMesh& part : parts) tree->add(part);
  // CGAL would build on the first query, behind a lock.
  tree->aabb.build();
  tree_ = tree;
}

bool Occluders::blocks(const Point& a, const Point& b, double skin) const {
  const auto segment = shortened(a, b, skin);
  if (!segment) return false;
  bool found = false;
  tree_->walk_along(*segment, [&](const Primitive&) { return found = true; });
  return found;
}

std::optional<std::uint32_t> Occluders::blocking_piece(const Point& a, const Point& b,
                                                       double skin) const {
  const auto segment = shortened(a, b, skin);
  if (!segment) return std::nullopt;
  std::optional<std::uint32_t> piece;
  tree_->walk_along(*segment, [&](const Primitive& p) {
    piece = p.piece;
    return true;
  });
  return piece;
}

bool Occluders::piece_blocks(std::uint32_t piece, const Point& a, const Point& b,
                             double skin) const {
  const auto segment = shortened(a, b, skin);
  return segment && tree_->piece_meets(piece, *segment);
}

bool Occluders::touches_shaft(const Point& apex, const Box& box) const {
  const Shaft shaft(apex, box);
  bool found = false;
  tree_->walk(
      [&](const CGAL::Bbox_3& node) {
        return shaft.may_meet({node.xmin(), node.ymin(), node.zmin()},
                              {node.xmax(), node.ymax(), node.zmax()});
      },
      [&](const Primitive& p) {
        return found = shaft.may_meet({eigen_point(p.triangle[0]),
                                       eigen_point(p.triangle[1]),
                                       eigen_point(p.triangle[2])});
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

  const auto covers = [&](const Primitive& p) {
    for (int i = 0; i < 8; ++i) {
      const Segment s{apex, target.corner(static_cast<Box::CornerType>(i))};
      if (tree_->alone[p.piece]
              ? !meets(p, Kernel::Segment_3(cgal_point(s.a), cgal_point(s.b)))
              : !tree_->piece_meets(p.piece, s)) {
        return false;
      }
    }
    return !tree_->piece_meets(p.piece, near) && !tree_->piece_meets(p.piece, far);
  };

  bool found = false;
  std::optional<std::uint32_t> refused;  // a body is met where it is entered and left
  tree_->walk_along({apex, box.center()}, [&](const Primitive& p) {
    if (p.piece == refused) return false;
    found = covers(p);
    refused = p.piece;
    return found;
  });
  return found;
}

bool Occluders::contains(const Point& p) const {
  if (!tree_->bounds.contains(p)) return false;
  const double length = 2 * (tree_->bounds.diagonal().norm() + p.norm());
  struct Count {
    int winding = 0;
    bool odd = false;
  };
  std::vector<Count> counts(tree_->closures.size());
  // A direction drawn at random meets an edge or a corner hardly ever.
  std::minstd_rand random;
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (bool ambiguous = true; ambiguous;) {
    const Eigen::Vector3d direction(uniform(random), uniform(random), uniform(random));
    const Segment s{p, p + length * direction.normalized()};
    const auto from = cgal_point(s.a), to = cgal_point(s.b);
    std::fill(counts.begin(), counts.end(), Count());
    ambiguous = false;
    bool at_surface = false;
    tree_->walk(
        [slabs = SlabTest(s)](const CGAL::Bbox_3& box) { return may_meet(slabs, box); },
        [&](const Primitive& t) {
          const std::uint32_t part = tree_->part_of[t.piece];
          if (!tree_->closures[part].closed) return false;
          switch (crossing(t.triangle, from, to)) {
            case Crossing::none:
              break;
            case Crossing::rising:
              ++counts[part].winding, counts[part].odd ^= true;
              break;
            case Crossing::falling:
              --counts[part].winding, counts[part].odd ^= true;
              break;
            case Crossing::at_start:
              at_surface = true;
              break;
            case Crossing::ambiguous:
              ambiguous = true;
              break;
          }
          return at_surface;
        });
    if (at_surface) return true;
  }
  for (std::size_t part = 0; part < counts.size(); ++part) {
    if (tree_->closures[part].oriented ? counts[part].winding != 0 : counts[part].odd) {
      return true;
    }
  }
  return false;
}

std::size_t Occluders::triangles() const { return tree_->aabb.size(); }
std::uint32_t Occluders::pieces() const {
  return static_cast<std::uint32_t>(tree_->part_of.size());
}
Occluders::Box Occluders::bounds() const { return tree_->bounds; }

}  // namespace delos
