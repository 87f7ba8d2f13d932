// Meshes made bad on purpose: the counts follow from how each was made.
#include "delos/geometry/defects.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>

#include "delos/geometry/primitives.h"

namespace delos::test {
namespace {

TriangleMesh cube() { return make_box({0, 0, 0}, {1, 1, 1}); }

TEST(Defects, AreAbsentFromPrimitives) {
  for (const TriangleMesh& mesh :
       {cube(), make_cylinder(1, 2, 7), make_sphere(2, 3),
        extrude({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 2)}) {
    const MeshDefects d = find_defects(mesh);
    EXPECT_EQ(d.degenerate, 0u);
    EXPECT_EQ(d.duplicate, 0u);
    EXPECT_EQ(d.border_edges, 0u);
    EXPECT_EQ(d.non_manifold_edges, 0u);
    EXPECT_EQ(d.flipped_edges, 0u);
    EXPECT_EQ(d.self_intersections, 0u);
    EXPECT_TRUE(d.closed);
    EXPECT_FALSE(d.inverted);
  }
}

TEST(Defects, AreFoundInASoupAsInASharedMesh) {
  TriangleMesh soup;
  const TriangleMesh shared = cube();
  for (const auto& triangle : shared.triangles) {
    const auto n = static_cast<std::uint32_t>(soup.vertices.size());
    for (const std::uint32_t corner : triangle) {
      soup.vertices.push_back(shared.vertices[corner]);
    }
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  EXPECT_TRUE(find_defects(soup).closed);
  EXPECT_EQ(find_defects(soup).self_intersections, 0u);
  // Zero has two signs, and one position.
  for (Eigen::Vector3d& p : soup.vertices) {
    if (p.x() == 0 && p.y() == 0) p.x() = -0.0;
  }
  EXPECT_TRUE(find_defects(soup).closed);
}

TEST(Defects, CountTheBordersOfAHole) {
  TriangleMesh open = cube();
  open.triangles.pop_back();
  const MeshDefects d = find_defects(open);
  EXPECT_EQ(d.border_edges, 3u);
  EXPECT_FALSE(d.closed);
  EXPECT_FALSE(d.inverted);
}

TEST(Defects, CountTrianglesWithoutArea) {
  TriangleMesh mesh = cube();
  mesh.vertices.emplace_back(0.5, 0, 0);  // on the edge from corner 0 to corner 1
  mesh.triangles.push_back({0, 1, 8});
  mesh.triangles.push_back({3, 3, 5});
  mesh.triangles.push_back({2, 2, 2});
  EXPECT_EQ(find_defects(mesh).degenerate, 3u);
}

TEST(Defects, CountDuplicates) {
  TriangleMesh mesh = cube();
  const auto [a, b, c] = mesh.triangles[4];
  mesh.triangles.push_back({b, c, a});
  mesh.triangles.push_back({c, b, a});  // seen from behind, still the same corners
  const MeshDefects d = find_defects(mesh);
  EXPECT_EQ(d.duplicate, 2u);
  EXPECT_EQ(d.non_manifold_edges, 0u);
  EXPECT_EQ(d.self_intersections, 0u);
  EXPECT_TRUE(d.closed);
}

TEST(Defects, CountEdgesOfThreeTriangles) {
  TriangleMesh mesh = cube();
  mesh.vertices.emplace_back(0.5, -1, -1);
  mesh.triangles.push_back({0, 1, 8});  // a fin on the edge from corner 0 to corner 1
  const MeshDefects d = find_defects(mesh);
  EXPECT_EQ(d.non_manifold_edges, 1u);
  EXPECT_EQ(d.border_edges, 2u);
  EXPECT_FALSE(d.closed);
}

TEST(Defects, CountEdgesThatFaceBothWays) {
  TriangleMesh mesh = cube();
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  const MeshDefects d = find_defects(mesh);
  EXPECT_EQ(d.flipped_edges, 3u);
  EXPECT_TRUE(d.closed);
  EXPECT_FALSE(d.inverted) << "of two orientations, neither is the inverse";
}

TEST(Defects, TellAMeshThatIsInsideOut) {
  TriangleMesh mesh = transformed(make_sphere(1, 2), Pose{.p = {100, 0, 0}});
  EXPECT_FALSE(find_defects(mesh).inverted);
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_TRUE(find_defects(mesh).inverted);
  EXPECT_TRUE(find_defects(mesh).closed);
}

TriangleMesh pair_of(std::vector<Eigen::Vector3d> vertices,
                     std::array<std::uint32_t, 3> second) {
  return {std::move(vertices), {{0, 1, 2}, second}};
}

TEST(SelfIntersections, AreCountedInPairs) {
  using Points = std::vector<Eigen::Vector3d>;
  const Points flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto with = [&](Points more) {
    Points all = flat;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  // No common corner: pierced, touched in a point, and apart.
  EXPECT_EQ(find_defects(pair_of(with({{1, 1, -1}, {1, 1, 1}, {2, 2, 1}}), {3, 4, 5}))
                .self_intersections,
            1u);
  EXPECT_EQ(find_defects(pair_of(with({{1, 1, 0}, {1, 1, 1}, {2, 2, 1}}), {3, 4, 5}))
                .self_intersections,
            1u);
  EXPECT_EQ(find_defects(pair_of(with({{1, 1, 0.1}, {1, 1, 1}, {2, 2, 1}}), {3, 4, 5}))
                .self_intersections,
            0u);
  // One common corner: the far edges cross, the second one's pierces the first, or only
  // the corner is shared.
  EXPECT_EQ(find_defects(pair_of(with({{2, 2, -1}, {2, 2, 1}}), {0, 3, 4}))
                .self_intersections,
            1u);
  EXPECT_EQ(find_defects(pair_of(with({{1, 1, -1}, {1, 1, 1}}), {0, 3, 4}))
                .self_intersections,
            1u);
  EXPECT_EQ(find_defects(pair_of(with({{-1, -1, -1}, {-1, -1, 1}}), {0, 3, 4}))
                .self_intersections,
            0u);
  // Pierced by the first one's far edge alone, in (2, 2, 0).
  EXPECT_EQ(find_defects(pair_of(with({{3, 3, -1}, {3, 3, 1}}), {0, 3, 4}))
                .self_intersections,
            1u);
  // One common edge: folded onto it, unfolded, and bent.
  EXPECT_EQ(find_defects(pair_of(with({{1, 1, 0}}), {1, 0, 3})).self_intersections, 1u);
  EXPECT_EQ(find_defects(pair_of(with({{1, -1, 0}}), {1, 0, 3})).self_intersections,
            0u);
  EXPECT_EQ(find_defects(pair_of(with({{1, 1, 1}}), {1, 0, 3})).self_intersections, 0u);
}

// Two unit squares of two triangles each, crossing in the segment x = ½, z = 0, y in
// [0, 1]: that segment lies in both triangles of either, split where the diagonals are.
TEST(SelfIntersections, AreFoundBetweenCrossingSheets) {
  TriangleMesh sheets;
  sheets.vertices = {{0, 0, 0},      {1, 0, 0},      {1, 1, 0},     {0, 1, 0},
                     {0.5, 0, -0.5}, {0.5, 1, -0.5}, {0.5, 1, 0.5}, {0.5, 0, 0.5}};
  sheets.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  // Split at y = ½ in both: lower with lower, upper with upper, and the two that meet
  // in the one point where the diagonals cross.
  EXPECT_EQ(find_defects(sheets).self_intersections, 4u);
}

// A disk as CAD programs write it, one polygon fanned from its first corner: all pairs
// of its triangles have boxes that meet, 32 million, of which some are looked at.
TEST(SelfIntersections, AreNotCountedWhereFansHaveTooManyPairs) {
  TriangleMesh disk;
  constexpr int kCorners = 8000;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    disk.vertices.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  for (std::uint32_t i = 2; i < kCorners; ++i) disk.triangles.push_back({0, i - 1, i});
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(find_defects(disk).self_intersections, std::nullopt);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  disk.triangles.resize(200);
  EXPECT_EQ(find_defects(disk).self_intersections, 0u);
}

}  // namespace
}  // namespace delos::test
