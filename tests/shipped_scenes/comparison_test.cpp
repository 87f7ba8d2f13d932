// What scenes are compared under: one definition for all sides.
#include <random>

#include "delos/scene/definition.h"
#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

/// Three anchors of one rate around a tag.
const std::string kAnchors = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.1]}
sample: {points: [[1, 1, 1]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [0, 0, 2], params: &u {sigma: 10 cm}}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [5, 5, 0], params: *u}
  - {name: c, type: uwb_range, rate: 10 Hz, at: [0, 5, 1], params: *u}
)";
const std::string kUseless =
    "  - {name: useless, type: uwb_range, rate: 0.1 Hz, at: [0, 0, 2], params: {sigma: "
    "10 m}}\n";

/// Values of both scenes at the samples of the first, under one definition.
std::pair<Field, Field> alike_fields(Scene first, Scene second) {
  const Scene* both[] = {&first, &second};
  const auto fusion = common_fusion(both);
  EXPECT_TRUE(fusion);
  first.fusion = second.fusion = fusion;
  return {field_of(first), field_of(second, make_samples(first.samples))};
}

/// One range of 10 m at 0.1 Hz beside three of 10 cm at 10 Hz adds a 10⁻⁶ part of
/// information about one direction. SciPy's CARE gives 170.02 mm with or without it, to
/// 26 nm; with DARE, which needs one rate, the three alone are 182 mm.
TEST(Comparison, DoesntPraiseAUselessDevice) {
  const auto [without, with] =
      alike_fields(scene_of(kAnchors), scene_of(kAnchors + kUseless));
  EXPECT_NEAR(without.value[0], 0.17002, 5e-6);
  EXPECT_NEAR(without.value[0] - with.value[0], 26e-9, 1e-9);
}

/// A rate of 9.9 Hz instead of 10 costs 0.16 %: SciPy's CARE, 170.02 and 170.29 mm.
TEST(Comparison, DoesntPraiseALowerRate) {
  const auto [before, after] = alike_fields(
      scene_of(kAnchors), scene_of(kAnchors, {{"devices.a.rate", "9.9 Hz"}}));
  EXPECT_NEAR(before.value[0], 0.17002, 5e-6);
  EXPECT_NEAR(after.value[0], 0.17029, 5e-6);
}

TEST(Comparison, IsStackedWhereAllScenesMayBe) {
  const Scene slow = scene_of(kAnchors),
              fast = scene_of(kAnchors, {{"devices.a.rate", "20 Hz"},
                                         {"devices.b.rate", "20 Hz"},
                                         {"devices.c.rate", "20 Hz"}}),
              mixed = scene_of(kAnchors + kUseless);
  const auto fusion = [](std::vector<const Scene*> scenes) {
    return common_fusion(scenes);
  };
  EXPECT_EQ(fusion({&slow, &fast}), Fusion::stacked);
  EXPECT_EQ(fusion({&slow, &fast, &mixed}), Fusion::continuous);
  // What a scene would be anyway it doesn't demand, though it says so.
  Scene said = slow, mixed_said = mixed;
  said.fusion = Fusion::stacked;
  mixed_said.fusion = Fusion::continuous;
  EXPECT_EQ(fusion({&said, &fast}), Fusion::stacked);
  EXPECT_EQ(fusion({&said, &mixed_said}), Fusion::continuous);
  said.fusion = Fusion::periodic;
  EXPECT_EQ(fusion({&slow, &said, &mixed_said}), Fusion::periodic);
  Scene other = fast;
  other.fusion = Fusion::artemis;
  EXPECT_EQ(fusion({&slow, &other}), Fusion::artemis);
  EXPECT_EQ(fusion({&said, &other}), std::nullopt);
}

/// Before and after of a search are of the scene's definition: a rate that may differ
/// from the others' makes it continuous, before it differs.
TEST(Comparison, FusionDoesntDependOnWhatVariablesAreSetTo) {
  const auto fusion = [](const std::string& variables) {
    return definition_of(scene_of(kAnchors + "variables:\n" + variables)).fusion;
  };
  EXPECT_EQ(fusion("  - {path: devices.a.rate, lower: 1, upper: 10}\n"),
            Fusion::continuous);
  EXPECT_EQ(fusion("  - {path: devices.a.rate, lower: 1, upper: 10, "
                   "tie: [devices.b.rate, devices.c.rate]}\n"),
            Fusion::stacked);
  EXPECT_EQ(fusion("  - {path: devices.a.rate, lower: 1, upper: 10, tie: "
                   "devices.b.rate, follow: [{path: devices.c.rate, factor: 2}]}\n"),
            Fusion::continuous);
  EXPECT_EQ(fusion("  - {path: devices.a.at.z, lower: 1, upper: 3}\n"),
            Fusion::stacked);
}

TEST(Comparison, RefusesStackedFusionOfRatesThatVaryApart) {
  Diagnostics findings;
  const auto scene =
      parse_scene(kAnchors +
                      "fusion: stacked\nvariables:\n"
                      "  - {path: devices.a.rate, lower: 1 Hz, upper: 10 Hz}\n",
                  "scene.yaml", {}, plugins(), findings);
  EXPECT_FALSE(scene);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(
      to_string(findings[0]),
      "scene.yaml:10:3: error: variables: change the rates of single devices, but "
      "stacked fusion needs one rate; tie all rates together, or use continuous");
}

/// Random rigs of ranges and cameras about six points, and what may be said of them.
class RandomRig {
 public:
  explicit RandomRig(std::uint64_t seed) : random_(seed) {}

  Scene scene() {
    std::string text =
        "delos: 1\nmotion: {type: " +
        one_of({"position", "position_velocity", "position_velocity_acceleration"}) +
        ", q: [" + number(0.1, 2) + ", " + number(0.1, 2) + ", " + number(0.1, 2) +
        "]}\n";
    text += "covariance: " + one_of({"prior", "posterior"}) + "\n";
    text += "metric: " +
            one_of({"eigmax", "sigma_x", "trace", "det", "eiglen", "mle", "coverage",
                    "sigma_position"}) +
            "\nsample: {points: [";
    for (int i = 0; i < 6; ++i)
      text += "[" + number(1, 4) + ", " + number(1, 4) + ", " + number(0.5, 2) + "], ";
    text += "]}\ndevices:\n";
    rate_ = one_of({"10", "20", "50"});
    const int count = std::uniform_int_distribution<int>(1, 5)(random_);
    for (int i = 0; i < count; ++i) text += device("d" + std::to_string(i));
    return scene_of(text);
  }

  /// The scene with one more device.
  Scene richer(Scene scene) {
    const Scene other = scene_of(
        "delos: 1\nmotion: {type: position, q: [1, 1, 1]}\nsample: {points: [[0, 0, "
        "0]]}\ndevices:\n" +
        device("more"));
    scene.devices.push_back(other.devices.front());
    return scene;
  }

  /// The scene with one slower device, or, now and then, all of them alike.
  Scene slower(Scene scene) {
    const double part = std::uniform_real_distribution<double>(0.05, 1)(random_);
    if (one_of({"all", "one", "one"}) == "all") {
      for (DeviceEntry& device : scene.devices) device.rate *= part;
    } else {
      const std::size_t i = std::uniform_int_distribution<std::size_t>(
          0, scene.devices.size() - 1)(random_);
      scene.devices[i].rate *= part;
    }
    return scene;
  }

 private:
  std::string one_of(const std::vector<std::string>& words) {
    return words[std::uniform_int_distribution<std::size_t>(0,
                                                            words.size() - 1)(random_)];
  }
  std::string number(double from, double to) {
    return std::to_string(std::uniform_real_distribution<double>(from, to)(random_));
  }
  std::string device(const std::string& name) {
    // Most have the scene's rate, so that many scenes are stacked.
    const std::string rate = one_of({rate_, rate_, rate_, rate_, "0.1", "33"});
    const std::string placed = ", rate: " + rate + ", at: [" + number(0, 5) + ", " +
                               number(0, 5) + ", " + number(2, 3) + "]";
    return "  - {name: " + name +
           (one_of({"range", "camera"}) == "range"
                ? ", type: uwb_range" + placed +
                      ", params: {sigma: " + number(0.01, 1) + "}}\n"
                : ", type: pinhole_camera" + placed +
                      ", aim: [2.5, 2.5, 1], params: {focal: 0.006, pitch: 5e-6, "
                      "resolution: [1280, 1024], sigma: " +
                      number(0.1, 2) + "}}\n");
  }

  std::mt19937_64 random_;
  std::string rate_ = "10";
};

/// Whether a value is at least as good as another, but for rounding: the least
/// eigenvalue of S is known to ε‖S‖, so that a direction seen a thousand times less
/// well than others keeps seven digits.
bool as_good(double value, double other, bool larger_is_better) {
  if (!std::isfinite(other)) return true;
  if (!std::isfinite(value)) return false;
  const double slack = 1e-6 * std::abs(other);
  return larger_is_better ? value >= other - slack : value <= other + slack;
}

/// Information only ever helps: P∞ falls in the order of matrices with S, and with the
/// rate at which S is had.
TEST(Comparison, OfMoreDevicesIsNeverWorseNorOfALowerRateBetter) {
  int stacked = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomRig rig(seed);
    const Scene scene = rig.scene();
    const bool larger =
        std::get<Metric>(parse_metric(scene.metric, scene.motion.layout))
            .larger_is_better;
    const auto [base, more] = alike_fields(scene, rig.richer(scene));
    const auto [same, less] = alike_fields(scene, rig.slower(scene));
    stacked += base.definition.fusion == Fusion::stacked;
    for (std::size_t i = 0; i < base.value.size(); ++i) {
      EXPECT_TRUE(as_good(more.value[i], base.value[i], larger))
          << "seed " << seed << ", one more device: " << base.value[i] << " to "
          << more.value[i];
      EXPECT_TRUE(as_good(same.value[i], less.value[i], larger))
          << "seed " << seed << ", a lower rate: " << same.value[i] << " to "
          << less.value[i];
    }
  }
  // Both kinds of definition were tried.
  EXPECT_GT(stacked, 20);
  EXPECT_LT(stacked, 180);
}

}  // namespace
}  // namespace delos::test
