// How many cameras see a point, by trying every triangle:
// tests/shipped_scenes/visibility_oracle.py writes visibility.csv.
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <utility>

#include "shipped.h"

namespace delos::test {
namespace {

struct SeenPoint {
  Eigen::Vector3d at;
  double coverage;
};

/// Rows by scene and the target's yaw, degrees.
std::map<std::pair<std::string, double>, std::vector<SeenPoint>> visibility() {
  std::map<std::pair<std::string, double>, std::vector<SeenPoint>> scenes;
  std::ifstream file(DELOS_VISIBILITY);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "scene,x,y,z,yaw,coverage");
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string name, cell;
    std::getline(cells, name, ',');
    std::vector<double> numbers;
    while (std::getline(cells, cell, ',')) numbers.push_back(std::stod(cell));
    if (numbers.size() != 5) {
      ADD_FAILURE() << line;
      continue;
    }
    scenes[{name, numbers[3]}].push_back(
        {{numbers[0], numbers[1], numbers[2]}, numbers[4]});
  }
  return scenes;
}

Samples samples_of(const std::vector<SeenPoint>& rows) {
  Samples samples;
  for (const SeenPoint& row : rows) samples.points.push_back(row.at);
  samples.parts = {{"", 0, rows.size(), ScatteredShape{}}};
  return samples;
}

TEST(Visibility, AgreesAtEveryPoint) {
  const auto scenes = visibility();
  ASSERT_EQ(scenes.size(), 2u + 12u);  // one heading, one, twelve
  std::size_t points = 0;
  for (const auto& [key, rows] : scenes) {
    const auto& [name, yaw] = key;
    Scene scene = load(name, {{"metric", "coverage"}});
    scene.orientations = {{{0, 0, yaw * std::numbers::pi / 180}},
                          OrientationRule::worst};
    const Field field = field_of(scene, samples_of(rows));
    ASSERT_EQ(field.value.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_EQ(field.value[i], rows[i].coverage)
          << name << " at " << rows[i].at.transpose() << ", heading " << yaw;
    }
    points += rows.size();
  }
  EXPECT_EQ(points, 1156u);
}

/// Bodies matter at these points: frusta alone give other counts.
TEST(Visibility, IsOfPointsThatBodiesHide) {
  for (const auto& [key, rows] : visibility()) {
    const auto& [name, yaw] = key;
    Scene scene = load(name, {{"metric", "coverage"}});
    scene.orientations = {{{0, 0, yaw * std::numbers::pi / 180}},
                          OrientationRule::worst};
    scene.occluders.clear();
    const Field field = field_of(scene, samples_of(rows));
    std::size_t hidden = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_GE(field.value[i], rows[i].coverage);
      hidden += field.value[i] > rows[i].coverage;
    }
    EXPECT_GT(hidden, rows.size() / 4) << name << ", heading " << yaw;
  }
}

}  // namespace
}  // namespace delos::test
