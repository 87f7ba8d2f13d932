// Beacons, devices on the target, and scenes that extend another one.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "delos/rig/system.h"
#include "scene/load.h"

namespace delos::test {
namespace {

/// kGood with beacons and a device on the target that sees them.
std::string carried(const std::string& beacons, const std::string& keys = "") {
  return good_with("devices:\n", "beacons:\n" + beacons +
                                     "devices:\n"
                                     "  - {name: eye, type: probe, rate: 50, mount: "
                                     "target, params: {r: 0.005}" +
                                     keys + "}\n");
}

const std::string kCeiling =
    "  ceiling: {grid: {min: [0, 0, 3], max: [0.3, 0.2, 3], step: 0.1}}\n";

std::vector<Eigen::Vector2d> lit(const std::string& keys) {
  const Loaded loaded = load(carried(
      "  c: {grid: {min: [0, 0, 3], max: [0.3, 0.2, 3], step: 0.1}" + keys + "}\n"));
  for (const std::string& finding : loaded.findings) ADD_FAILURE() << finding;
  std::vector<Eigen::Vector2d> places;
  for (const Beacon& b : lit_beacons(loaded.scene.value().beacons.at(0))) {
    places.emplace_back(std::lround(b.p.x() * 10), std::lround(b.p.y() * 10));
  }
  return places;
}

using Places = std::vector<Eigen::Vector2d>;

// Of a grid of 4 by 3, drawn by hand.
TEST(BeaconPattern, LightsPanels) {
  EXPECT_EQ(lit("").size(), 12u);
  EXPECT_EQ(lit(", pattern: full").size(), 12u);
  EXPECT_EQ(lit(", pattern: half"),
            (Places{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 2}, {1, 2}, {2, 2}, {3, 2}}));
  EXPECT_EQ(lit(", pattern: columns"),
            (Places{{0, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {2, 2}}));
  EXPECT_EQ(lit(", pattern: checkerboard"),
            (Places{{0, 0}, {2, 0}, {1, 1}, {3, 1}, {0, 2}, {2, 2}}));
  EXPECT_EQ(lit(", pattern: half, panel: [1, 2]"),
            (Places{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}, {1, 1}, {2, 1}, {3, 1}}));
  EXPECT_EQ(lit(", pattern: checkerboard, panel: [2, 1]"),
            (Places{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {0, 2}, {1, 2}}));
}

TEST(Beacons, HaveNormalsConesRangesAndWeights) {
  const Loaded loaded = load(carried(
      "  wall: {list: [[1, 2, 3], [1, 2, 3 cm, 0, 0, 2], [4, 5, 6, 1, 0, 0, 0.5]], "
      "normal: [0, -3, 0], emission: 60 deg, range: 4 m, weight: 0.5}\n"));
  ASSERT_TRUE(loaded.scene) << loaded.findings.at(0);
  const std::vector<Beacon> beacons = lit_beacons(loaded.scene->beacons[0]);
  ASSERT_EQ(beacons.size(), 3u);
  EXPECT_EQ(beacons[0].normal, Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(beacons[1].normal, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(beacons[1].p.z(), 0.03);
  EXPECT_EQ(beacons[2].weight, 0.25);
  EXPECT_EQ(beacons[0].weight, 0.5);
  EXPECT_EQ(beacons[0].range, 4);
  EXPECT_NEAR(beacons[0].cos_emission, 0.5, 1e-15);
  // 60° about −y: (0, −1, 1.7) is 59.5° off, (0, −1, 1.8) 60.9°.
  EXPECT_TRUE(beacons[0].reaches({1, 1, 4.7}));
  EXPECT_FALSE(beacons[0].reaches({1, 1, 4.8}));
  EXPECT_FALSE(beacons[0].reaches({1, -2.1, 3}));  // 4.1 m away
}

TEST(Beacons, AreReadFromFiles) {
  const Folder folder;
  std::ofstream(folder / "leds.csv") << "x,y,z,nx,ny,nz\n1,2,3\n4,5,6,0,0,-1\n";
  Diagnostics findings;
  const auto scene = parse_scene(carried("  c: {file: leds.csv}\n"),
                                 folder / "scene.yaml", {}, plugins(), findings);
  ASSERT_TRUE(scene);
  const auto& list = std::get<BeaconList>(scene->beacons[0].layout);
  EXPECT_EQ(list.file, "leds.csv");
  ASSERT_EQ(list.entries.size(), 2u);
  EXPECT_FALSE(list.entries[0].normal);
  EXPECT_EQ(list.entries[1].normal, Eigen::Vector3d(0, 0, -1));
}

TEST(Beacons, MalformedRowsAreNamed) {
  const Folder folder;
  std::ofstream(folder / "leds.csv") << "1,2,3\n1,2\n1,x,3\n1,2,3,0,0,0\n";
  Diagnostics findings;
  EXPECT_FALSE(parse_scene(carried("  c: {file: leds.csv}\n"), folder / "scene.yaml",
                           {}, plugins(), findings));
  ASSERT_EQ(findings.size(), 2u);
  const std::string file = (folder / "leds.csv").string();
  EXPECT_EQ(to_string(findings[0]),
            file +
                ":2:3: error: expected 3 numbers x,y,z or 6 numbers x,y,z,nx,ny,nz or "
                "7 numbers x,y,z,nx,ny,nz,weight, found 2");
  EXPECT_EQ(to_string(findings[1]),
            file + ":3:3: error: 'x' isn't a number; rows are x,y,z in metres");
  std::ofstream(folder / "leds.csv") << "1,2,3,0,0,0\n1,2,3,0,0,1,2\n";
  findings.clear();
  EXPECT_FALSE(parse_scene(carried("  c: {file: leds.csv}\n"), folder / "scene.yaml",
                           {}, plugins(), findings));
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_NE(
      to_string(findings[0]).find("leds.csv: beacon 0: the normal has length zero"),
      std::string::npos);
}

TEST(CarriedDevice, IsPlacedOnTheTarget) {
  const Loaded loaded = load(carried(
      kCeiling, ", at: [0, 0, 0.1], beacons: ceiling, select: nearest, count: 3"));
  ASSERT_TRUE(loaded.scene) << loaded.findings.at(0);
  const System system = build_system(*loaded.scene, plugins());
  ASSERT_TRUE(system.devices.at(0).carried());
  const TargetMount& eye = *system.devices[0].carried();
  EXPECT_EQ(eye.beacons->size(), 12u);
  EXPECT_EQ(eye.X_TS.p, Eigen::Vector3d(0, 0, 0.1));
  EXPECT_EQ(eye.select, SightingRule::nearest);
  EXPECT_EQ(eye.count, 3);
  EXPECT_FALSE(system.devices.at(1).carried());
  // The same beacons are the same index: a moved device makes none anew.
  Scene moved = *loaded.scene;
  moved.devices[0].placement.at.x() = 0.2;
  const System again = build_system(moved, plugins(), &system);
  EXPECT_EQ(again.devices[0].carried()->beacons, eye.beacons);
  std::get<BeaconGrid>(moved.beacons[0].layout).pattern = BeaconPattern::half;
  EXPECT_NE(build_system(moved, plugins(), &system).devices[0].carried()->beacons,
            eye.beacons);
}

TEST(CarriedDevice, IsWrittenAsItWasRead) {
  for (const std::string& keys :
       {std::string(), std::string(", beacons: [ceiling], select: best, count: 4")}) {
    const Loaded loaded = load(carried(
        kCeiling + "  wall: {list: [[1, 2, 3], [1, 2, 3, 0, 1, 0, 0.5]], range: 3}\n",
        keys));
    ASSERT_TRUE(loaded.scene) << loaded.findings.at(0);
    const Loaded again = load(write_scene(*loaded.scene));
    ASSERT_TRUE(again.scene) << again.findings.at(0);
    EXPECT_EQ(*again.scene, *loaded.scene);
  }
}

struct BadBeacons {
  const char* name;
  std::string text;
  std::string finding;
};

TEST(CarriedDevice, MistakesAreSaid) {
  const BadBeacons bad[] = {
      {"no layout", carried("  c: {normal: [0, 0, -1]}\n"),
       "beacons.c: no beacons; give grid, list or file"},
      {"two layouts", carried("  c: {list: [[0, 0, 1]], file: x.csv}\n"),
       "beacons.c.file: the beacons are given by 'list' already; keep one"},
      {"pattern of a list", carried("  c: {list: [[0, 0, 1]], pattern: half}\n"),
       "beacons.c.pattern: is of a grid; leave out the rows that are off"},
      {"pattern",
       carried("  c: {grid: {min: [0, 0, 0], max: [1, 1, 0], step: 1}, "
               "pattern: chess}\n"),
       "beacons.c.pattern: 'chess' is none of full, half, columns, checkerboard"},
      {"empty list", carried("  c: {list: []}\n"),
       "beacons.c.list: the list is empty; give at least one beacon"},
      {"row", carried("  c: {list: [[0, 0]]}\n"),
       "beacons.c.list.0: expected [x, y, z], or with a normal [x, y, z, nx, ny, nz], "
       "or "
       "with a weight behind it, not 2 members"},
      {"weight", carried("  c: {list: [[0, 0, 1, 0, 0, 1, 1.5]]}\n"),
       "beacons.c.list.0: the weight must be from 0 to 1"},
      {"zero normal", carried("  c: {list: [[0, 0, 1]], normal: [0, 0, 0]}\n"),
       "beacons.c.normal: has length zero; leave it out where beacons radiate all "
       "around"},
      {"emission", carried("  c: {list: [[0, 0, 1]], emission: 0 deg}\n"),
       "beacons.c.emission: must be above 0 and at most 180 deg: the half-angle of the "
       "cone"},
      {"range", carried("  c: {list: [[0, 0, 1]], range: 0 m}\n"),
       "beacons.c.range: must be above 0"},
      {"too many",
       carried("  c: {grid: {min: [0, 0, 0], max: [10, 10, 0], step: 1 mm}}\n"),
       "beacons.c.grid.step: 100,020,001 beacons; at most 10,000,000: make it coarser"},
      {"adaptive",
       carried("  c: {grid: {min: [0, 0, 0], max: [1, 1, 1], adaptive: {}}}\n"),
       "beacons.c.grid.adaptive: beacons stand on a grid; give 'step'"},
      {"no such set", carried(kCeiling, ", beacons: cieling"),
       "devices.eye.beacons: there is no set 'cieling'; did you mean 'ceiling'?"},
      {"in a group", carried(kCeiling, ", group: rig1"),
       "devices.eye.group: is in the world, but mount: target moves with the target"},
      {"count alone", carried(kCeiling, ", count: 3"),
       "devices.eye.count: goes with 'select: mean', 'random', 'nearest' or 'best'"},
      {"no beacons", good_with("type: probe\n", "type: probe\n    mount: target\n"),
       "devices.s1.mount: the scene declares no beacons for it to see; add 'beacons'"},
      {"world", good_with("type: probe\n", "type: probe\n    select: best\n"),
       "devices.s1.select: is for a device that the target carries; give 'mount: "
       "target'"},
  };
  for (const BadBeacons& b : bad) {
    SCOPED_TRACE(b.name);
    const Loaded loaded = load(b.text);
    EXPECT_FALSE(loaded.scene);
    bool said = false;
    for (const std::string& finding : loaded.findings) {
      said = said || finding.ends_with(": error: " + b.finding);
    }
    EXPECT_TRUE(said) << (loaded.findings.empty() ? "nothing" : loaded.findings[0]);
  }
}

// ---- extends ----

/// A base in a folder, and scenes that extend it.
class Extends : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    folder_.write(name, text);
  }
  std::optional<Scene> load(const std::string& name,
                            const std::vector<Override>& changes = {}) {
    findings_.clear();
    Diagnostics found;
    auto scene = load_scene(folder_ / name, changes, plugins(), found);
    for (const Diagnostic& d : found) {
      std::string text = to_string(d);
      const std::string prefix = folder_.path().string() + "/";
      if (text.starts_with(prefix)) text.erase(0, prefix.size());
      findings_.push_back(text);
    }
    return scene;
  }
  Folder folder_;
  std::vector<std::string> findings_;
};

TEST_F(Extends, TakesOverWhatItDoesNotSay) {
  write("base.yaml", kGood);
  write("s.yaml",
        "extends: base.yaml\nname: Mine\nset:\n  devices.s1.at.z: 120 cm\n"
        "  devices.s2.rate: 25\n");
  const auto base = load("base.yaml"), scene = load("s.yaml");
  ASSERT_TRUE(base && scene) << findings_.at(0);
  Scene expected = *base;
  expected.name = "Mine";
  expected.devices[0].placement.at.z() = 1.2;
  expected.devices[1].rate = 25;
  EXPECT_EQ(*scene, expected);
  // What the command line changes comes last.
  EXPECT_EQ(load("s.yaml", {{"devices.s1.at.z", "3"}})->devices[0].placement.at.z(), 3);
}

TEST_F(Extends, GoesOnAndFindsFilesBesideTheBase) {
  write("rooms/points.csv", "1,2,3\n");
  write("rooms/base.yaml",
        good_with("volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}",
                  "file: points.csv"));
  write("rooms/middle.yaml", "extends: base.yaml\nname: Middle\n");
  write("s.yaml", "extends: rooms/middle.yaml\nmetric: trace\n");
  const auto scene = load("s.yaml");
  ASSERT_TRUE(scene) << findings_.at(0);
  EXPECT_EQ(scene->name, "Middle");
  EXPECT_EQ(scene->metric, "trace");
  const auto& points = std::get<PointSampling>(scene->samples[0].shape);
  EXPECT_EQ(points.file, "rooms/points.csv");
  EXPECT_EQ(points.points.size(), 1u);
}

TEST_F(Extends, FindingsPointIntoTheTextThatIsWrong) {
  write("base.yaml", good_with("rate: 50 Hz", "rate: 0 Hz"));
  write("s.yaml", "extends: base.yaml\nmetric: nonsense\n");
  EXPECT_FALSE(load("s.yaml"));
  ASSERT_EQ(findings_.size(), 2u);
  EXPECT_TRUE(findings_[0].starts_with("s.yaml:2:9: error: metric:")) << findings_[0];
  EXPECT_TRUE(findings_[1].starts_with("base.yaml:14:11: error: devices.s1.rate:"))
      << findings_[1];
}

TEST_F(Extends, MistakesAreSaid) {
  const auto only = [&](const std::string& text) -> std::string {
    write("s.yaml", text);
    EXPECT_FALSE(load("s.yaml"));
    return findings_.size() == 1 ? findings_[0] : std::to_string(findings_.size());
  };
  write("base.yaml", kGood);
  write("list.yaml", "- 1\n");
  write("loop.yaml", "extends: s.yaml\n");
  EXPECT_EQ(only("extends: none.yaml\n"),
            "s.yaml:1:10: error: extends: there is no readable scene '" +
                (folder_ / "none.yaml").string() + "': No such file or directory");
  std::filesystem::create_symlink("self.yaml", folder_ / "self.yaml");
  EXPECT_EQ(only("extends: self.yaml\n"),
            "s.yaml:1:10: error: extends: there is no readable scene '" +
                (folder_ / "self.yaml").string() +
                "': Too many levels of symbolic links");
  EXPECT_EQ(only("extends: list.yaml\n"),
            "s.yaml:1:10: error: extends: 'list.yaml' isn't a scene");
  EXPECT_EQ(only("extends: [1]\n"),
            "s.yaml:1:10: error: extends: expected the name of a scene file");
  EXPECT_EQ(only("extends: base.yaml\nset: 3\n"),
            "s.yaml:2:6: error: set: expected a mapping of paths to values");
  EXPECT_EQ(
      only("extends: base.yaml\nset: {devices.s9.rate: 3}\n"),
      "s.yaml:2:7: error: devices.s9: there is no such member; did you mean 's1'?");
  EXPECT_EQ(only(kGood + "set: {name: x}\n"),
            "s.yaml:18:6: error: set: goes with 'extends'; here, write the values");
  EXPECT_EQ(only("extends: loop.yaml\n"),
            "s.yaml:1:10: error: extends: 'loop.yaml' extends this scene again");
}

}  // namespace
}  // namespace delos::test
