// Every point that SciPy has worked out: tests/shipped_scenes/oracle.py writes
// oracle.csv.
#include <fstream>
#include <map>
#include <sstream>

#include "shipped.h"

namespace delos::test {
namespace {

struct SolvedPoint {
  Eigen::Vector3d at;
  double eigmax;
};

std::map<std::string, std::vector<SolvedPoint>> oracle() {
  std::map<std::string, std::vector<SolvedPoint>> scenes;
  std::ifstream file(DELOS_ORACLE);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "scene,x,y,z,eigmax");
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string name, cell;
    std::getline(cells, name, ',');
    SolvedPoint row;
    for (double& c : row.at) {
      std::getline(cells, cell, ',');
      c = std::stod(cell);
    }
    std::getline(cells, cell);
    row.eigmax = std::stod(cell);
    scenes[name].push_back(row);
  }
  return scenes;
}

/// The general equations in six states there, their reduction here.
TEST(Oracle, AgreesAtEveryPoint) {
  const auto scenes = oracle();
  ASSERT_EQ(scenes.size(), 5u);
  for (const auto& [name, rows] : scenes) {
    EXPECT_GE(rows.size(), 35u) << name;
    Samples samples;
    for (const SolvedPoint& row : rows) samples.points.push_back(row.at);
    samples.parts = {{"", 0, rows.size(), ScatteredShape{}}};
    const Field field = field_of(load(name), samples);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double expected = rows[i].eigmax;
      EXPECT_EQ(field.observable[i] != 0, std::isfinite(expected))
          << name << " at " << rows[i].at.transpose();
      if (!std::isfinite(expected)) {
        EXPECT_EQ(field.value[i], expected) << name;
        continue;
      }
      EXPECT_NEAR(field.value[i], expected, 1e-8 * expected)
          << name << " at " << rows[i].at.transpose();
    }
  }
}

}  // namespace
}  // namespace delos::test
