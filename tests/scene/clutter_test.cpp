// Bodies drawn at random: the law that they are drawn by, and what they hide, against
// the slabs of each box.
#include "delos/scene/clutter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "delos/device/range_device.h"
#include "delos/field/evaluate.h"
#include "scene/load.h"

namespace delos::test {
namespace {

const ClutterEntry kClutter{.name = "crowd",
                            .count = 4000,
                            .seed = 11,
                            .shape = ClutterShape::box,
                            .least = 0.2,
                            .greatest = 0.6,
                            .box = {{-1, 0, 2}, {3, 2, 2.5}}};

/// The mean of n uniform numbers is off by more than 5 √(1/12n) once in a million
/// times.
void expect_uniform(const std::vector<double>& values, double least, double greatest) {
  double sum = 0;
  for (const double value : values) {
    EXPECT_GE(value, least);
    EXPECT_LT(value, greatest);
    sum += (value - least) / (greatest - least);
  }
  const auto n = static_cast<double>(values.size());
  EXPECT_NEAR(sum / n, 0.5, 5 / std::sqrt(12 * n));
}

TEST(Clutter, IsDrawnUniformly) {
  const std::vector<OccluderEntry> bodies = drawn_bodies(kClutter);
  ASSERT_EQ(bodies.size(), 4000u);
  std::vector<double> at[3], size[3], turn;
  std::set<std::string> names;
  for (const OccluderEntry& body : bodies) {
    const auto& box = std::get<BoxShape>(body.body);
    EXPECT_EQ(box.min, -box.max);
    for (int i = 0; i < 3; ++i) {
      at[i].push_back(body.placement.at(i));
      size[i].push_back(2 * box.max(i));
    }
    const Eigen::Vector3d angles = std::get<Rpy>(body.placement.facing).angles;
    EXPECT_EQ(angles.head(2).norm(), 0);
    turn.push_back(angles.z());
    EXPECT_EQ(body.mount, Mount::world);
    names.insert(body.name);
  }
  for (int i = 0; i < 3; ++i) {
    expect_uniform(at[i], kClutter.box.min(i), kClutter.box.max(i));
    expect_uniform(size[i], 0.2, 0.6);
  }
  expect_uniform(turn, 0, 2 * std::numbers::pi);
  EXPECT_EQ(names.size(), 4000u);
  // The generator is the standard's: its 10,000th number is given there. The centre of
  // the first body is made of the first three.
  std::mt19937_64 standard;
  standard.discard(9999);
  EXPECT_EQ(standard(), 9981545732273789042u);
  std::mt19937_64 same(11);
  EXPECT_EQ(bodies[0].placement.at.x(),
            -1 + 4 * std::ldexp(static_cast<double>(same() >> 11), -53));
}

TEST(Clutter, GrowsByItsCountAndChangesWithItsSeed) {
  ClutterEntry other = kClutter;
  const std::vector<OccluderEntry> all = drawn_bodies(kClutter);
  other.count = 7;
  const std::vector<OccluderEntry> few = drawn_bodies(other);
  ASSERT_EQ(few.size(), 7u);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), all.begin()));
  other.seed = 12;
  EXPECT_NE(drawn_bodies(other).front().placement.at, all.front().placement.at);
  other.shape = ClutterShape::sphere;
  for (const OccluderEntry& ball : drawn_bodies(other)) {
    const double diameter = 2 * std::get<SphereShape>(ball.body).radius;
    EXPECT_GE(diameter, 0.2);
    EXPECT_LT(diameter, 0.6);
  }
  other.count = 0;
  EXPECT_TRUE(drawn_bodies(other).empty());
}

/// Hears whatever is in sight.
class Ear final : public RangeDevice {
 public:
  Ear() : RangeDevice(1e-4, 0, 100) {}
};

const std::string kScene = good_with("groups:", R"(clutter:
  boxes: {count: 12, seed: 3, size: [4 cm, 20 cm], box: {min: [0, 0, 0.2], max: [1, 0.4, 0.9]}}
  balls: {count: 2, shape: sphere, size: [1 cm, 2 cm], box: {min: [5, 5, 5], max: [6, 6, 6]}}
groups:)");

/// Whether a segment meets a turned box: in the box's frame, by its slabs.
bool meets(const OccluderEntry& body, Eigen::Vector3d from, Eigen::Vector3d to) {
  const Pose X = pose_of(body.placement);
  const auto& box = std::get<BoxShape>(body.body);
  from = X.R.transpose() * (from - X.p);
  to = X.R.transpose() * (to - X.p);
  double enters = 0, leaves = 1;
  for (int i = 0; i < 3; ++i) {
    const double d = to(i) - from(i);
    double a = (box.min(i) - from(i)) / d, b = (box.max(i) - from(i)) / d;
    if (a > b) std::swap(a, b);
    enters = std::max(enters, a);
    leaves = std::min(leaves, b);
  }
  return enters < leaves;
}

TEST(Clutter, HidesWhatItsBoxesHide) {
  const Loaded loaded = load(kScene);
  ASSERT_TRUE(loaded.scene) << loaded.findings.size();
  const Scene& scene = *loaded.scene;
  System system = build_system(scene, plugins());
  for (PlacedDevice& device : system.devices)  // a probe sees nothing
    device.device = std::make_shared<const Ear>();
  ASSERT_EQ(system.occluders.size(), 14u);
  Samples samples;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 500; ++i)
    samples.points.emplace_back(0.4 * uniform(random), 0.4 * uniform(random),
                                0.2 * uniform(random));
  samples.parts = {{"", 0, 500, ScatteredShape{}}};
  const auto coverage = std::get<Metric>(parse_metric("coverage", scene.motion.layout));
  const Field one = evaluate_field(system, samples, {}, coverage, {.threads = 1});
  int hidden = 0, compared = 0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    if (one.inside[i]) continue;
    ++compared;
    double seen = 0;
    for (const PlacedDevice& device : system.devices) {
      bool free = true;
      for (std::size_t b = 0; b < 12; ++b)
        free = free && !meets(system.occluders[b], device.X_WS().p, samples.points[i]);
      seen += free;
    }
    EXPECT_EQ(one.value[i], seen) << samples.points[i].transpose();
    hidden += seen < 2;
  }
  EXPECT_GT(compared, 400);
  EXPECT_GT(hidden, 50);
  EXPECT_LT(hidden, 450);
  for (const int threads : {2, 3})
    EXPECT_EQ(evaluate_field(system, samples, {}, coverage, {.threads = threads}).value,
              one.value);
}

TEST(Clutter, IsWrittenAsItWasRead) {
  const Scene scene = load(kScene).scene.value();
  const std::string text = write_scene(scene);
  EXPECT_NE(text.find("seed: 3"), std::string::npos) << text;
  EXPECT_NE(text.find("seed: 0"), std::string::npos) << text;
  EXPECT_EQ(load(text).scene.value(), scene);
}

TEST(Clutter, IsRefusedWhereItMakesNoSense) {
  const auto refused = [](const std::string& clutter) {
    const Loaded loaded =
        load(good_with("groups:", "clutter: " + clutter + "\ngroups:"));
    EXPECT_FALSE(loaded.scene);
    return loaded.findings;
  };
  const std::string box = "box: {min: [0, 0, 0], max: [1, 1, 1]}";
  using Findings = std::vector<std::string>;
  EXPECT_EQ(refused("[1]"), Findings{"scene.yaml:9:10: error: clutter: expected a "
                                     "mapping of names to what is drawn, not a list"});
  EXPECT_EQ(refused("{a: {count: 3, size: [2, 1], " + box + "}}"),
            Findings{"scene.yaml:9:35: error: clutter.a.size.1: is below the least; "
                     "exchange them"});
  EXPECT_EQ(refused("{a: {count: 3, size: [0, 1], " + box + "}}"),
            Findings{"scene.yaml:9:32: error: clutter.a.size.0: must be above 0"});
  EXPECT_EQ(refused("{a: {count: -3, size: 1, " + box + "}}"),
            (Findings{"scene.yaml:9:22: error: clutter.a.count: -3 is outside 0 to "
                      "10,000",
                      "scene.yaml:9:32: error: clutter.a.size: expected two lengths "
                      "[least, greatest], not a single value"}));
  EXPECT_EQ(refused("{a: {count: 3, size: [1, 2, 3], " + box + "}}"),
            Findings{"scene.yaml:9:31: error: clutter.a.size: expected two lengths "
                     "[least, greatest], not 3 members"});
}

}  // namespace
}  // namespace delos::test
