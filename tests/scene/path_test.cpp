// Samples along a path.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "delos/sampling/samples.h"
#include "scene/load.h"

namespace delos::test {
namespace {

const std::string kPathVolume =
    "volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}";

std::vector<Eigen::Vector3d> along(const std::string& path) {
  const Loaded loaded = load(good_with(kPathVolume, "path: " + path));
  if (!loaded.scene) {
    for (const std::string& finding : loaded.findings) ADD_FAILURE() << finding;
    return {};
  }
  const Scene& scene = *loaded.scene;
  EXPECT_EQ(load(write_scene(scene)).scene.value(), scene) << write_scene(scene);
  const Samples samples = make_samples(scene.samples);
  EXPECT_EQ(sample_count(scene.samples[0]),
            static_cast<std::int64_t>(samples.points.size()));
  return samples.points;
}

// Three sides of a square: 3 m; a waypoint that is given twice changes nothing.
const std::string kSquare =
    "points: [[0, 0, 1], [1, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]";

void expect_points(const std::vector<Eigen::Vector3d>& found,
                   const std::vector<Eigen::Vector3d>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_LT((found[i] - expected[i]).norm(), 1e-12) << found[i].transpose();
}

TEST(Path, HasSamplesAtEqualDistances) {
  expect_points(along("{" + kSquare + ", step: 75 cm}"),
                {{0, 0, 1}, {0.75, 0, 1}, {1, 0.5, 1}, {0.75, 1, 1}, {0, 1, 1}});
  // The last step that fits.
  expect_points(along("{" + kSquare + ", step: 1.25}"),
                {{0, 0, 1}, {1, 0.25, 1}, {0.5, 1, 1}});
  expect_points(along("{" + kSquare + ", count: 3}"),
                {{0, 0, 1}, {1, 0.5, 1}, {0, 1, 1}});
  expect_points(along("{" + kSquare + ", count: 2}"), {{0, 0, 1}, {0, 1, 1}});
  expect_points(along("{" + kSquare + "}"),
                {{0, 0, 1}, {1, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
  // 0.1 isn't a double: thirty of them are 3 m all the same.
  const auto fine = along("{" + kSquare + ", step: 0.1}");
  ASSERT_EQ(fine.size(), 31u);
  EXPECT_EQ(fine.back(), Eigen::Vector3d(0, 1, 1));
}

TEST(Path, IsReadFromAFile) {
  const Folder folder;
  const std::filesystem::path file =
      folder.write("walk.csv", "x,y,z\n0,0,1\n0,2,1\n0,2,3\n");
  expect_points(along(file.string()), {{0, 0, 1}, {0, 2, 1}, {0, 2, 3}});
  expect_points(along("{file: " + file.string() + ", count: 5}"),
                {{0, 0, 1}, {0, 1, 1}, {0, 2, 1}, {0, 2, 2}, {0, 2, 3}});
}

TEST(Path, IsRefusedWhereItMakesNoSense) {
  const auto refused = [](const std::string& path) {
    const Loaded loaded = load(good_with(kPathVolume, "path: " + path));
    EXPECT_FALSE(loaded.scene) << path;
    return loaded.findings;
  };
  using Findings = std::vector<std::string>;
  const std::string at = "scene.yaml:8:";
  EXPECT_EQ(refused("{points: [[0, 0, 0]], step: 1}"),
            Findings{at + "9: error: sample.path: a path has two waypoints or more"});
  EXPECT_EQ(refused("{points: [[0, 0, 0], [0, 0, 0]], step: 1}"),
            Findings{at + "9: error: sample.path: has no length: all its waypoints are "
                          "one"});
  EXPECT_EQ(
      refused("{step: 1}"),
      Findings{at + "9: error: sample.path: there are no waypoints; give points or "
                    "file"});
  EXPECT_EQ(refused("{points: [[0, 0, 0], [0, 0, 1]], step: 1, count: 2}"),
            Findings{at + "58: error: sample.path.count: the samples are given by "
                          "'step' already; keep one"});
  EXPECT_EQ(refused("{points: [[0, 0, 0], [0, 0, 1]], step: -1}"),
            Findings{at + "48: error: sample.path.step: must be above 0"});
  EXPECT_EQ(refused("{points: [[0, 0, 0], [0, 0, 1]], step: 1e-12}"),
            Findings{at + "48: error: sample.path.step: "
                          "1,000,000,000,001 samples would need about 40 TB; at most "
                          "50,000,000: use step 2.1e-08 or coarser"});
  EXPECT_EQ(refused("walk.txt"),
            Findings{at + "9: error: sample.path: 'walk.txt' is neither a .ptl nor a "
                          ".csv file"});
}

}  // namespace
}  // namespace delos::test
