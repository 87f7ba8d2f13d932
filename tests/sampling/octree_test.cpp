// The octree's topology against what it promises, by brute force over small trees.
#include "delos/sampling/octree.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace delos {
namespace {

using Index = Octree::Index;

Eigen::AlignedBox3d box(double x, double y, double z) {
  return {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(x, y, z)};
}

/// A tree halved around one point, level by level.
Octree halved_at(const Eigen::Vector3d& p, int depth) {
  Octree tree(box(1, 1, 1), depth);
  for (int level = 1; level < depth; ++level) {
    const Index leaf = tree.leaf_at(p);
    tree.refine(tree.closed({&leaf, 1}));
  }
  return tree;
}

TEST(Octree, RootsAreNearlyCubes) {
  EXPECT_EQ(Octree(box(1, 1, 1), 3).nodes(), 27u);
  // 4 × 4 × 1 roots: (2·4 + 1)² (2·1 + 1) nodes.
  EXPECT_EQ(Octree(box(10, 10, 2.5), 3).nodes(), 9u * 9 * 3);
}

TEST(Octree, LeavesFillTheBoxOnce) {
  const Octree tree = halved_at({0.3, 0.6, 0.1}, 6);
  double volume = 0;
  for (const Index leaf : tree.leaves()) volume += tree.box_of(leaf).volume();
  EXPECT_NEAR(volume, 1, 1e-12);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d p(uniform(random), uniform(random), uniform(random));
    const Index leaf = tree.leaf_at(p);
    ASSERT_TRUE(tree.is_leaf(leaf));
    ASSERT_TRUE(tree.box_of(leaf).contains(p));
  }
  EXPECT_TRUE(tree.box_of(tree.leaf_at({1, 1, 1})).contains(Eigen::Vector3d(1, 1, 1)));
}

TEST(Octree, NodesAreSharedAndStandAtTheCornersOfTheirCells) {
  const Octree tree = halved_at({0.3, 0.6, 0.1}, 5);
  std::set<std::array<double, 3>> places;
  for (Index n = 0; n < tree.nodes(); ++n) {
    const Eigen::Vector3d p = tree.position(n);
    EXPECT_TRUE(places.insert({p.x(), p.y(), p.z()}).second)
        << "two nodes at one place";
  }
  for (const Index leaf : tree.leaves()) {
    const Octree::Corners corners = tree.corners(leaf);
    const Eigen::AlignedBox3d around = tree.box_of(leaf);
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d expected(i & 1 ? around.max().x() : around.min().x(),
                                     i & 2 ? around.max().y() : around.min().y(),
                                     i & 4 ? around.max().z() : around.min().z());
      ASSERT_EQ(tree.position(corners[static_cast<std::size_t>(i)]), expected);
    }
  }
}

// Brute force: every pair of leaves whose closed boxes meet.
TEST(Octree, LeavesThatTouchDifferByOneLevelAtMost) {
  const Octree tree = halved_at({0.49, 0.49, 0.49}, 7);
  const std::vector<Index> leaves = tree.leaves();
  int deepest = 0;
  for (const Index a : leaves) {
    deepest = std::max(deepest, tree.cells()[a].level);
    for (const Index b : leaves) {
      if (!tree.box_of(a).intersects(tree.box_of(b))) continue;
      ASSERT_LE(std::abs(tree.cells()[a].level - tree.cells()[b].level), 1);
    }
  }
  EXPECT_EQ(deepest, 7);
}

TEST(Octree, TheDeepestLevelIsNotHalved) {
  const Octree tree = halved_at({0.1, 0.1, 0.1}, 3);
  const Index leaf = tree.leaf_at({0.01, 0.01, 0.01});
  EXPECT_EQ(tree.cells()[leaf].level, 3);
  EXPECT_TRUE(tree.closed({&leaf, 1}).empty());
}

TEST(Octree, TheCoarsestLeafAtANodeIsFoundAndKnowsItsLattice) {
  const Octree tree = halved_at({0.3, 0.6, 0.1}, 5);
  int hanging = 0;
  for (Index n = 0; n < tree.nodes(); ++n) {
    const Index coarsest = tree.coarsest_leaf_at(n);
    int least = 99;
    for (const Index leaf : tree.leaves()) {
      if (tree.box_of(leaf).contains(tree.position(n)))
        least = std::min(least, tree.cells()[leaf].level);
    }
    ASSERT_EQ(tree.cells()[coarsest].level, least);
    const Octree::Family& family = tree.family_of(coarsest);
    const bool listed = std::find(family.begin(), family.end(), n) != family.end();
    ASSERT_EQ(tree.in_family_lattice(coarsest, n), listed);
    hanging += !listed;
  }
  EXPECT_GT(hanging, 0);
}

TEST(Octree, RevertTakesARefinementBack) {
  Octree tree = halved_at({0.3, 0.6, 0.1}, 5);
  const std::size_t nodes = tree.nodes(), cells = tree.cells().size();
  const std::vector<Index> leaves = tree.leaves();
  const Index leaf = tree.leaf_at({0.9, 0.9, 0.9});
  const Index first = tree.refine(tree.closed({&leaf, 1}));
  EXPECT_GT(tree.nodes(), nodes);
  tree.revert(first, nodes);
  EXPECT_EQ(tree.nodes(), nodes);
  EXPECT_EQ(tree.cells().size(), cells);
  EXPECT_EQ(tree.leaves(), leaves);
  tree.refine(tree.closed({&leaf, 1}));
  EXPECT_GT(tree.nodes(), nodes);
}

}  // namespace
}  // namespace delos
