// The edges of an octree's leaves.
#include "shapes/leaves.h"

#include <gtest/gtest.h>

#include <set>

namespace delos::shapes {
namespace {

/// The unit cube, of which the corner at the origin is halved: seven leaves of side ½
/// and eight of side ¼.
struct Tree {
  std::vector<Eigen::Vector3d> points{Eigen::Vector3d::Constant(9)};  // of another part
  OctreeShape octree;
  SamplePart part{"", 1, 0, ScatteredShape{}};

  Tree() {
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d half = corner(i) / 2;
      if (i > 0)
        leaf(half, 0.5);
      else
        for (int j = 0; j < 8; ++j) leaf(corner(j) / 4, 0.25);
    }
    part.count = points.size() - 1;
  }
  static Eigen::Vector3d corner(int bits) {
    return {double(bits & 1), double(bits >> 1 & 1), double(bits >> 2)};
  }
  void leaf(const Eigen::Vector3d& low, double side) {
    std::array<std::uint32_t, 8> cell;
    for (int c = 0; c < 8; ++c) {
      const Eigen::Vector3d p = low + side * corner(c);
      const auto known = std::find(points.begin() + 1, points.end(), p);
      cell[static_cast<std::size_t>(c)] =
          static_cast<std::uint32_t>(known - points.begin() - 1);
      if (known == points.end()) points.push_back(p);
    }
    octree.cells.push_back(cell);
  }
  [[nodiscard]] LeafEdges edges(const std::optional<AxisPlane>& near = {}) const {
    return leaf_edges(points, part, octree, near);
  }
};

/// Lengths, and that no line is there twice.
double length_of(const LeafEdges& edges) {
  std::set<std::array<double, 6>> lines;
  double length = 0;
  for (std::size_t k = 0; k < edges.ends.size(); k += 2) {
    const Eigen::Vector3d &a = edges.ends[k], &b = edges.ends[k + 1];
    EXPECT_TRUE(lines.insert({a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}).second);
    length += (b - a).norm();
  }
  return length;
}

// Eight cubes of side ½ have 3·9 lines of length 1 in two halves each, 54 lines; the
// halved one's three edges at the origin are of no leaf of side ½, and the eight of
// side ¼ have 54 of their own.
TEST(Leaves, HaveEachEdgeOnce) {
  const LeafEdges edges = Tree().edges();
  EXPECT_EQ(edges.leaves, 15u);
  EXPECT_EQ(edges.ends.size() / 2, 54u - 3 + 54);
  EXPECT_NEAR(length_of(edges), 51 * 0.5 + 54 * 0.25, 1e-12);
}

TEST(Leaves, NearAPlaneAreThoseThatItMeets) {
  const Tree tree;
  for (const int axis : {0, 1, 2}) {
    EXPECT_EQ(tree.edges(AxisPlane{axis, 0.1}).leaves, 3u + 4);
    EXPECT_EQ(tree.edges(AxisPlane{axis, 0.25}).leaves, 3u + 4) << "the upper four";
    EXPECT_EQ(tree.edges(AxisPlane{axis, {}}).leaves, 4u) << "in the middle";
    EXPECT_EQ(tree.edges(AxisPlane{axis, 1.0}).leaves, 4u) << "at the end";
    EXPECT_EQ(tree.edges(AxisPlane{axis, 1.5}).leaves, 0u);
  }
}

}  // namespace
}  // namespace delos::shapes
