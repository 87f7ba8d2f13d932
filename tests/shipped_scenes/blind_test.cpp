// Where a field is blind, and why: regions that similar triangles give.
#include "delos/field/blind.h"

#include "shipped.h"

namespace delos::test {
namespace {

Scene parsed(const std::string& text) {
  Diagnostics findings;
  const auto scene = parse_scene(text, "scene.yaml", {}, plugins(), findings);
  for (const Diagnostic& finding : findings) ADD_FAILURE() << to_string(finding);
  return scene.value();
}

/// Eleven samples along x, seen from above and from the side, three metres away; a
/// third camera looks elsewhere. A screen one metre from the line hides what lies
/// beyond its edge as seen from a camera: a sample at x meets the screen's plane at 0.5
/// + 2/3 (x − 0.5), on its near face.
const std::string kRow = R"(delos: 1
name: Row
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {volume: {min: [0, 0, 0], max: [1, 0, 0], step: 0.1}}
devices:
  - {name: above, rate: 50, type: pinhole_camera, at: [0.5, 0, 3], aim: [0.5, 0, 0], params: &p {focal: 4 mm, pitch: 5 um, resolution: [1280, 1024]}}
  - {name: beside, rate: 50, type: pinhole_camera, at: [0.5, 3, 0], aim: [0.5, 0, 0], params: *p}
  - {name: away, rate: 50, type: pinhole_camera, at: [0.5, 3, 0], aim: [0.5, 9, 0], params: *p}
)";

TEST(BlindRegions, TellsWhatHidesFromWhatLooksAway) {
  const Scene scene = parsed(kRow + R"(occluders:
  - {box: {min: [0.55, 1, -1], max: [3, 1.1, 1]}}      # x ≥ 0.6 hidden from beside
  - {box: {min: [-3, -1, 1], max: [0.25, 1, 1.1]}}     # x ≤ 0.1 hidden from above
)");
  const auto regions = blind_regions(build_system(scene, plugins()), scene.orientations,
                                     field_of(scene));
  ASSERT_EQ(regions.size(), 2u);
  const BlindRegion &right = regions[0], &left = regions[1];
  EXPECT_EQ(right.samples, (std::vector<std::size_t>{6, 7, 8, 9, 10}));
  EXPECT_EQ(left.samples, (std::vector<std::size_t>{0, 1}));
  EXPECT_NEAR(right.box.min().x(), 0.6, 1e-12);
  EXPECT_NEAR(right.box.max().x(), 1.0, 1e-12);
  // One camera is left, which can't tell how far away the target is.
  EXPECT_EQ(right.least_lost, 1);
  EXPECT_EQ(right.most_lost, 1);
  EXPECT_EQ(right.unseen, 0u);
  const auto expect = [](const RegionView& view, const char* device, std::size_t sees,
                         std::size_t hidden, std::size_t beyond) {
    EXPECT_EQ(view.device, device);
    EXPECT_EQ(view.sees, sees) << device;
    EXPECT_EQ(view.hidden, hidden) << device;
    EXPECT_EQ(view.beyond, beyond) << device;
  };
  ASSERT_EQ(right.views.size(), 3u);
  expect(right.views[0], "above", 5, 0, 0);
  expect(right.views[1], "beside", 0, 5, 0);
  expect(right.views[2], "away", 0, 0, 5);
  expect(left.views[0], "above", 0, 2, 0);
  expect(left.views[1], "beside", 2, 0, 0);
}

TEST(BlindRegions, CountsWhatNobodySees) {
  const Scene scene = parsed(kRow + R"(occluders:
  - {box: {min: [-9, 1, -9], max: [9, 1.1, 9]}}
  - {box: {min: [-9, -9, 1], max: [9, 9, 1.1]}}
)");
  const auto regions = blind_regions(build_system(scene, plugins()), scene.orientations,
                                     field_of(scene));
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].unseen, 11u);
  EXPECT_EQ(regions[0].least_lost, 3);
}

TEST(BlindRegions, AreNoneWhereAllIsSeen) {
  const Scene scene = parsed(kRow);
  EXPECT_TRUE(
      blind_regions(build_system(scene, plugins()), scene.orientations, field_of(scene))
          .empty());
}

/// More points than a block has lanes.
TEST(SeenPoints, AreToldPointByPoint) {
  const Scene scene = parsed(kRow);
  const System system = build_system(scene, plugins());
  std::vector<Eigen::Vector3d> points(100, Eigen::Vector3d(0.5, 0, 0));
  points.emplace_back(0.5, 0, 50);  // behind the camera above
  const auto seen = seen_points(system, scene.orientations, points);
  ASSERT_EQ(seen.size(), 3u);
  EXPECT_EQ(std::count(seen[0].begin(), seen[0].end(), true), 100);
  EXPECT_FALSE(seen[0][100]);
}

}  // namespace
}  // namespace delos::test
