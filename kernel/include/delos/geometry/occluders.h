// What hides: which sight lines are blocked, and what lies in a shadow as a whole.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "delos/api.h"
#include "delos/geometry/mesh.h"

namespace delos {

/// The triangles of several meshes in one frame. Immutable, cheap to copy, and safe to
/// ask from many threads at once. All lengths are metres.
///
/// Answers about single segments are exact for the given doubles: they are those of
/// arithmetic without rounding. Triangles without area are left
/// out, and all but one of those with the same corners.
///
/// A *convex piece* is a connected component of a mesh that is closed and convex, so
/// that a box or a cylinder is one piece; every other triangle is a piece of its own.
/// The shadow that a convex set casts from a point is convex, which is why pieces
/// decide about whole boxes.
class DELOS_API Occluders {
 public:
  using Point = Eigen::Vector3d;
  using Box = Eigen::AlignedBox3d;

  /// Nothing hides.
  Occluders();
  /// @param parts meshes, placed; each has an inside of its own where it is closed
  /// @param hollow one a part, or none: nonzero where it hides but has no inside
  /// @pre vertices finite, indices in range, fewer than 2³¹ triangles
  /// @cost n log n; the parts' vertices are copied into each triangle
  explicit Occluders(const std::vector<TriangleMesh>& parts,
                     const std::vector<char>& hollow = {});

  /// Whether a triangle meets the segment a→b shortened by `skin` at both ends.
  /// Touching is meeting. Where the segment isn't longer than 2·skin, nothing does.
  /// @pre skin ≥ 0
  [[nodiscard]] bool blocks(const Point& a, const Point& b, double skin) const;

  /// Whether something may stand between `apex` and the box: false only if no triangle
  /// meets their convex hull, so that nothing blocks a segment from the apex to any
  /// point of the box. May be true where nothing does.
  /// @pre box isn't empty; it may be flat
  [[nodiscard]] bool touches_shaft(const Point& apex, const Box& box) const;

  /// Whether the whole box is in one shadow: true only if blocks(apex, p, skin) for
  /// every p in the box, because one convex piece hides all of it. May be false where
  /// it is hidden, by several pieces say.
  /// @pre skin ≥ 0; box isn't empty; it may be flat
  [[nodiscard]] bool hides(const Point& apex, const Box& box, double skin) const;

  /// Whether p is inside, or on the surface of, a part that is closed. A part of one
  /// orientation is left where the surface winds around p no times, so that bodies may
  /// overlap or have cavities; any other is judged by the parity of crossings.
  [[nodiscard]] bool contains(const Point& p) const;

  /// Whether both are copies of the same.
  friend bool operator==(const Occluders&, const Occluders&) = default;

  [[nodiscard]] std::size_t triangles() const;  ///< those not left out
  [[nodiscard]] std::uint32_t pieces() const;   ///< convex pieces
  [[nodiscard]] Box bounds() const;             ///< of all triangles; empty without any

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace delos
