// Every device that reads a place: fields by lanes, slopes in all parameters, certified
// selections and covers, each against the slow way to the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <sstream>

#include "delos/field/point.h"
#include "delos/optimize/cover_scene.h"
#include "delos/optimize/problem.h"
#include "delos/optimize/select.h"
#include "optimizers/scenes.h"

namespace delos::test {
namespace {

/// How six devices stand around what they look at.
enum class Facing {
  towards,  ///< their z axes point at it
  turned,   ///< their z axes are along x, y and z by turns
};

struct Numbered {
  const char* name;
  double value;
};

struct DeviceCase {
  const char* name;
  const char* id;
  std::vector<Numbered> numbers;  ///< parameters that are varied
  const char* others = "";        ///< and those that aren't
  Facing facing = Facing::towards;
  const char* state = "position";
};

void PrintTo(const DeviceCase& c, std::ostream* out) { *out << c.name; }

constexpr int kDevices = 6;

/// A scene of some of the six. @param which one bit each
std::string scene_text(const DeviceCase& c, unsigned which, const std::string& more) {
  const double at[kDevices][3] = {{-0.3, -0.4, 2.1}, {2.2, -0.3, 1.7}, {2.4, 2.1, 2.2},
                                  {-0.2, 2.3, 1.8},  {1.1, -0.7, 2.4}, {0.8, 2.5, 2.0}};
  const char* turns[3] = {"[0, 0, 0]", "[90 deg, 0, 0]", "[0, 90 deg, 0]"};
  const bool pose = std::string(c.state) == "pose";
  std::ostringstream text;
  text.precision(17);
  text << "delos: 1\nmotion: {type: position_velocity, state: " << c.state
       << ", q: [0.4" << (pose ? ", 0.4, 0.3, 0.5, 0.6, 0.7" : ", 0.4, 0.3")
       << "]}\nfusion: stacked\nmetric: sigma_position\n"
          "sample: {volume: {min: [0.33, 0.35, 0.3], max: [1.53, 1.55, 1.1], step: "
          "0.4}}\ndevices:\n";
  for (int d = 0; d < kDevices; ++d) {
    if (!(which >> d & 1)) continue;
    text << "  - {name: d" << d << ", type: " << c.id << ", rate: 50 Hz, at: ["
         << at[d][0] << ", " << at[d][1] << ", " << at[d][2] << "], "
         << (c.facing == Facing::towards ? "aim: [1, 1.03, 0.6]"
                                         : "rpy: " + std::string(turns[d % 3]))
         << ", params: {";
    const char* comma = "";
    for (const Numbered& number : c.numbers) {
      text << comma << number.name << ": " << number.value;
      comma = ", ";
    }
    text << (c.numbers.empty() || !*c.others ? "" : ", ") << c.others << "}}\n";
  }
  return text.str() + more;
}

constexpr unsigned kAll = (1u << kDevices) - 1;

class EveryDevice : public ::testing::TestWithParam<DeviceCase> {};

/// `point` asks devices one by one, and sums no information.
TEST_P(EveryDevice, FieldsInLanesAreThoseOfPointsOneByOne) {
  const Scene scene = parse(scene_text(GetParam(), kAll, ""));
  const System system = build_system(scene, plugins());
  const auto metric =
      std::get<Metric>(parse_metric("sigma_position", system.motion.layout));
  const Field field =
      evaluate_field(system, make_samples(scene.samples), {}, metric, {.threads = 1});
  std::size_t seen = 0;
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    const PointReport report = evaluate_point(
        system, {Eigen::Matrix3d::Identity(), field.samples.points[i]}, metric);
    for (const MetricValue& of : report.metrics) {
      if (of.metric.name != "sigma_position") continue;
      ASSERT_EQ(std::isfinite(field.value[i]), std::isfinite(of.value)) << i;
      if (std::isfinite(of.value)) {
        EXPECT_NEAR(field.value[i] / of.value, 1, 1e-9) << i;
      }
    }
    seen += field.observable[i];
  }
  EXPECT_GT(seen, field.value.size() / 2);
}

/// Against central differences of the soft score.
TEST_P(EveryDevice, SlopesInAllParametersAreThoseOfDifferences) {
  const DeviceCase& c = GetParam();
  std::ostringstream variables;
  variables << "variables: [{path: devices.*.at, lower: -3, upper: 5}";
  if (c.facing == Facing::towards)
    variables << ", {path: devices.d0.aim, lower: -1, upper: 3}";
  for (const Numbered& number : c.numbers)
    variables << ", {path: devices.*.params." << number.name
              << ", lower: " << std::min(0.8 * number.value, 1.25 * number.value)
              << ", upper: " << std::max(0.8 * number.value, 1.25 * number.value)
              << "}";
  variables << "]\nobjective: {minimize: mean, of: sigma_position, guess: 1 m}\n";
  Problem problem(parse(scene_text(c, kAll, variables.str())), plugins(), {30, 1});
  ASSERT_EQ(problem.slope_problem(), "");
  const std::size_t n = problem.design().size();
  const std::vector<double> x = problem.design().start();
  std::vector<double> slope(n);
  for (const double width : {0.3, 0.05}) {
    const Score score = problem.score_with_slopes(x, width, slope.data(), nullptr);
    ASSERT_TRUE(std::isfinite(score.objective));
    const double size = Eigen::Map<Eigen::VectorXd>(slope.data(), n).norm();
    EXPECT_GT(size, 0);
    constexpr double kStep = 2e-6;
    for (std::size_t v = 0; v < n; ++v) {
      std::vector<double> up = x, down = x;
      up[v] += kStep;
      down[v] -= kStep;
      const double difference = (problem.soft_score(up, width).objective -
                                 problem.soft_score(down, width).objective) /
                                (2 * kStep);
      EXPECT_NEAR(slope[v], difference, 1e-5 * size) << v << ", width " << width;
    }
  }
}

/// Four of six against all fifteen.
TEST_P(EveryDevice, SelectionsAreTheBestOfAll) {
  const DeviceCase& c = GetParam();
  double least = std::numeric_limits<double>::infinity();
  for (unsigned which = 0; which <= kAll; ++which) {
    if (std::popcount(which) != 4) continue;
    const Field field = field_of(parse(scene_text(c, which, "")));
    double sum = 0;
    for (const double value : field.value) sum += value * value;
    least = std::min(least, std::sqrt(sum / static_cast<double>(field.value.size())));
  }
  SelectOptions options;
  options.gap = 0;
  options.threads = 1;
  const SelectResult result = select(
      parse(scene_text(c, kAll,
                       "objective: {minimize: mean, of: sigma_position}\n"
                       "selection: {count: 4, candidates: [{devices: \"*\"}]}\n")),
      plugins(), options);
  ASSERT_TRUE(std::isfinite(least));
  EXPECT_EQ(result.blind, 0u);
  EXPECT_EQ(result.chosen.size(), 4u);
  EXPECT_NEAR(result.value / least, 1, 1e-9);
  EXPECT_NEAR(result.lower_bound / least, 1, 1e-6);
}

/// The fewest that all samples are seen by twice, of all 64 choices.
TEST_P(EveryDevice, CoversAreTheFewest) {
  const DeviceCase& c = GetParam();
  std::vector<std::vector<char>> seen;
  for (int d = 0; d < kDevices; ++d) {
    Scene one = parse(scene_text(c, 1u << d, ""));
    one.metric = "coverage";
    const Field field = field_of(one);
    seen.emplace_back();
    for (const double value : field.value) seen.back().push_back(value > 0.5);
  }
  int fewest = kDevices + 1;
  for (unsigned which = 0; which <= kAll; ++which) {
    bool covers = true;
    for (std::size_t i = 0; i < seen[0].size() && covers; ++i) {
      int count = 0;
      for (int d = 0; d < kDevices; ++d)
        count += (which >> d & 1) && seen[static_cast<std::size_t>(d)][i];
      covers = count >= 2;
    }
    if (covers) fewest = std::min(fewest, std::popcount(which));
  }
  ASSERT_LE(fewest, kDevices);
  SelectOptions options;
  options.seconds = 10;
  options.threads = 1;
  const SceneCover cover = cover_scene(
      parse(scene_text(c, kAll,
                       "selection: {cover: 2, candidates: [{devices: \"*\"}]}\n")),
      plugins(), options);
  EXPECT_EQ(cover.chosen.size(), static_cast<std::size_t>(fewest));
  EXPECT_EQ(cover.lower_bound, fewest);
}

const std::vector<DeviceCase>& device_cases() {
  static const std::vector<DeviceCase> all = {
      {"acoustic", "acoustic_range", {{"r", 0.005}, {"reach", 3.2}}},
      {"bearing",
       "bearing",
       {{"sigma", 0.02}, {"elevation", 1.2}, {"reach", 3.4}},
       "",
       Facing::turned},
      {"camera",
       "camera",
       {{"f_x", 900},
        {"f_y", 910},
        {"c_x", 640},
        {"c_y", 480},
        {"k1", -0.1},
        {"k2", 0.02},
        {"p1", 0.001},
        {"p2", -0.001},
        {"sigma", 0.2}},
       "resolution: [1280, 960]"},
      {"fisheye",
       "camera",
       {{"field_of_view", 2.6}, {"half_angle", 1.2}, {"sigma", 0.2}},
       "resolution: [1280, 960], distortion: fisheye"},
      {"custom",
       "custom",
       {},
       "reading: \"sqrt(x^2 + y^2 + z^2)\", sigma: \"0.1 + 0.01*z\", inside: \"30 - "
       "sqrt(x^2 + y^2 + z^2)\", beyond: smooth"},
      {"depth",
       "depth_camera",
       {{"field_of_view", 1.3}, {"sigma", 0.3}, {"depth_sigma", 0.01}, {"far", 4}},
       "resolution: [1280, 960]"},
      {"stereo",
       "depth_camera",
       {{"f_x", 800}, {"sigma", 0.3}, {"baseline", 0.1}, {"subpixel", 0.2}},
       "resolution: [1280, 960]"},
      {"goniometer",
       "goniometer",
       {{"sigma_azimuth", 0.01},
        {"sigma_elevation", 0.02},
        {"half_angle", 0.9},
        {"reach", 4}}},
      {"lighthouse",
       "lighthouse",
       {{"sigma", 1e-3}, {"across", 1.9}, {"down", 1.8}},
       "generation: v1, common: 0"},
      {"lighthouse_tilted",
       "lighthouse",
       {{"sigma", 1e-3}, {"across", 1.9}, {"down", 1.8}},
       "generation: v2, common: 0"},
      {"linkage", "linkage", {{"upper", 2}, {"fore", 1.7}, {"sigma", 1e-3}}},
      {"pinhole",
       "pinhole_camera",
       {{"focal", 0.006}, {"pitch", 7.4e-6}, {"sigma", 0.2}},
       "resolution: [1280, 960]"},
      {"range",
       "range",
       {{"sigma", 0.05}, {"growth", 0.02}, {"cone", 1}, {"reach", 4}}},
      {"uwb", "uwb_range", {{"sigma", 0.1}}},
      {"fiducial",
       "fiducial",
       {{"f_x", 900}, {"sigma", 0.3}, {"size", 0.2}},
       "resolution: [1280, 960], tag_half_angle: 1.4",
       Facing::towards,
       "pose"},
  };
  return all;
}

INSTANTIATE_TEST_SUITE_P(Devices, EveryDevice, ::testing::ValuesIn(device_cases()),
                         [](const auto& of) { return std::string(of.param.name); });

/// The others measure how the target moves, are carried by it, or have tests of their
/// own.
TEST(EveryDevice, IsThere) {
  std::set<std::string> known = {"accelerometer", "gyroscope", "imu",
                                 "hiball",        "linear",    "magnetic_dipole"};
  for (const DeviceCase& c : device_cases()) known.insert(c.id);
  for (const std::string& id : plugins().ids()) EXPECT_TRUE(known.count(id)) << id;
}

}  // namespace
}  // namespace delos::test
