#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/load.h"

namespace delos::test {
namespace {

Scene changed(const std::string& path, const std::string& value,
              const std::string& text = kGood) {
  const Loaded loaded = load(text, {{path, value}});
  for (const std::string& finding : loaded.findings) ADD_FAILURE() << finding;
  return loaded.scene.value_or(Scene{});
}

TEST(ParseOverride, SplitsAtTheFirstEquals) {
  const auto o = parse_override("devices.s1.at.x=1.2 m");
  ASSERT_TRUE(o);
  EXPECT_EQ(o->path, "devices.s1.at.x");
  EXPECT_EQ(o->value, "1.2 m");
  EXPECT_EQ(parse_override("a=b=c")->value, "b=c");
  EXPECT_EQ(parse_override("a=")->value, "");
  EXPECT_FALSE(parse_override("devices.s1.at.x"));
  EXPECT_FALSE(parse_override("=3"));
  EXPECT_FALSE(parse_override(""));
}

TEST(Override, ReachesEveryKindOfValue) {
  EXPECT_EQ(changed("devices.s1.at.x", "1.2 m").devices[0].placement.at.x(), 1.2);
  EXPECT_EQ(changed("devices.s2.at.z", "30 cm").devices[1].placement.at.z(), 0.3);
  EXPECT_EQ(changed("devices.1.at.2", "7").devices[1].placement.at.z(), 7);
  EXPECT_EQ(changed("devices.s1.params.r", "7 mm").devices[0].params["r"], 0.007);
  EXPECT_EQ(std::get<ChainMotion>(changed("motion.q.0", "9").motion.dynamics).q(0, 0),
            9);
  EXPECT_EQ(changed("groups.rig1.at.x", "3").groups[0].placement.at.x(), 3);
  EXPECT_EQ(
      std::get<VolumeSampling>(changed("sample.volume.step", "0.1").samples[0].shape)
          .step.y(),
      0.1);
  EXPECT_EQ(
      std::get<Aim>(changed("devices.s2.aim.y", "5").devices[1].placement.facing).at,
      Eigen::Vector3d(0, 5, 0));
  EXPECT_EQ(changed("devices.s1.at", "[1, 2, 3]").devices[0].placement.at,
            Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(changed("name", "'a: b'").name, "a: b");
}

TEST(Override, ReachesAllMembersByAStar) {
  const Scene scene = changed("devices.*.rate", "7 Hz");
  ASSERT_GT(scene.devices.size(), 1u);
  for (const DeviceEntry& device : scene.devices) EXPECT_EQ(device.rate, 7);
  EXPECT_EQ(changed("groups.*.at.x", "3").groups[0].placement.at.x(), 3);
  EXPECT_EQ(load(kGood, {{"name.*.x", "1"}}).findings.front(),
            "--set name.*.x: error: name.*: there are no members");
  EXPECT_FALSE(load(kGood, {{"devices.*.rates", "1"}}).scene);
}

TEST(Override, KnowsAnglesAndQuaternionsByTheirOwnNames) {
  const std::string rpy = good_with("aim: [0, 0, 0]", "rpy: [0, 0, 0]");
  EXPECT_EQ(
      std::get<Rpy>(changed("devices.s2.rpy.yaw", "2", rpy).devices[1].placement.facing)
          .angles,
      Eigen::Vector3d(0, 0, 2));
  const std::string wxyz = good_with("aim: [0, 0, 0]", "quaternion_wxyz: [1, 0, 0, 0]");
  EXPECT_EQ(std::get<QuaternionWxyz>(changed("devices.s2.quaternion_wxyz.x", "2", wxyz)
                                         .devices[1]
                                         .placement.facing)
                .wxyz,
            Eigen::Vector4d(1, 2, 0, 0));
}

TEST(Override, AddsAbsentKeys) {
  EXPECT_EQ(changed("fusion", "periodic").fusion, Fusion::periodic);
  EXPECT_EQ(changed("devices.s2.params.focal", "20 mm").devices[1].params["focal"],
            0.02);
  EXPECT_EQ(changed("sample.orientations.combine", "mean").orientations.combine,
            OrientationRule::mean);
  EXPECT_EQ(changed("target.markers", "[[1, 2, 3]]").markers[0],
            Eigen::Vector3d(1, 2, 3));
  const std::string no_at = good_with("    at: [0, 0, 1]\n", "");
  EXPECT_EQ(changed("devices.s1.at.y", "4", no_at).devices[0].placement.at,
            Eigen::Vector3d(0, 4, 0));
}

TEST(Override, PlusIsOneMoreMemberOfAList) {
  const Scene scene = changed(
      "devices.+", "{name: s9, type: probe, rate: 50, at: [1, 2, 3], params: {r: 1}}");
  ASSERT_EQ(scene.devices.size(), load(kGood).scene->devices.size() + 1);
  EXPECT_EQ(scene.devices.back().name, "s9");
  // Of a list that isn't given yet, too.
  EXPECT_EQ(
      changed("constraints.+", "{spacing: 0.1, devices: [s1, s2]}").constraints.size(),
      1u);
}

TEST(Override, TakesAMemberAway) {
  const std::vector<DeviceEntry> all = load(kGood).scene->devices;
  const Scene without = changed("devices.-", all.front().name);
  ASSERT_EQ(without.devices.size(), all.size() - 1);
  EXPECT_EQ(without.devices.front(), all[1]);
  EXPECT_EQ(changed("devices.-", "1").devices.front(), all[0]) << "by index";
}

TEST(Override, TakesAKeyAway) {
  EXPECT_EQ(changed("-", "name").name, "");
  EXPECT_FALSE(changed("devices.s2.-", "aim").devices[1] ==
               load(kGood).scene->devices[1]);
  const Loaded loaded = load(kGood, {{"-", "nobody"}});
  ASSERT_EQ(loaded.findings.size(), 1u);
  EXPECT_NE(loaded.findings[0].find("no such member"), std::string::npos);
}

TEST(Override, PrefersNamesToIndices) {
  // The device that is called 1 is the first one.
  const std::string text = good_with("name: s1", "name: 1");
  EXPECT_EQ(changed("devices.1.at.x", "8", text).devices[0].placement.at.x(), 8);
}

TEST(Override, ChangesOneUseOfAnAnchorOnly) {
  std::string text = good_with("params: {r: 5 mm}", "params: &p {r: 5 mm}");
  text.replace(text.rfind("{r: 0.005}"), 10, "*p");
  const Scene scene = changed("devices.s1.params.r", "1", text);
  EXPECT_EQ(scene.devices[0].params["r"], 1);
  EXPECT_EQ(scene.devices[1].params["r"], 0.005);
}

TEST(Override, AreAppliedInOrder) {
  const Loaded loaded =
      load(kGood, {{"devices.s1.at", "[1, 2, 3]"}, {"devices.s1.at.z", "4"}});
  ASSERT_TRUE(loaded.scene);
  EXPECT_EQ(loaded.scene->devices[0].placement.at, Eigen::Vector3d(1, 2, 4));
}

struct BadOverride {
  const char* path;
  const char* value;
  const char* finding;
};

const BadOverride kBad[] = {
    {"devices.s3.at.x", "1", "devices.s3: there is no such member; did you mean 's1'?"},
    {"devices.camera.at.x", "1",
     "devices.camera: there is no such member; known: s1, s2"},
    {"motion.q.7", "1", "motion.q.7: there is no such member; known: x, y, z"},
    {"devices.s1.at.q", "1",
     "devices.s1.at.q: there is no such member; known: x, y, z"},
    {"groups.rig2.at.x", "1",
     "groups.rig2: there is no such group; did you mean 'rig1'?"},
    {"devices.s1.aim.x", "1",
     "devices.s1.aim: isn't given, so one component can't be set; set it whole"},
    {"name.x", "1", "name.x: there is nothing inside a single value"},
    {"name..x", "1", "name.: a part of the path is empty"},
    {"devices.s1.parms.r", "1",
     "devices.s1.parms: unknown key; did you mean 'params'?"},
    {"devices.s1.params.rr", "1",
     "devices.s1.params.rr: unknown key; did you mean 'r'?"},
    {"devices.s1.params.aperture", "1",
     "devices.s1.params.aperture: unknown key; known: r, focal, near, far, gain, "
     "shape, "
     "resolution, mix"},
    {"fusoin", "stacked", "fusoin: unknown key; did you mean 'fusion'?"},
    {"device.s1.at.z", "1", "device: unknown key; did you mean 'devices'?"},
    {"devices.s1.at.x", "5 Hz",
     "devices.s1.at.x: '5 Hz' is a frequency; expected a length such as '50 mm'"},
    {"devices.s1.rate", "",
     "devices.s1.rate: no value is given: updates a second, such as 50 Hz"},
    {"devices.s1.at", "[1, 2",
     "not a readable YAML text: end of sequence flow not found"},
};

TEST(Override, SaysWhatIsWrongWithIt) {
  for (const BadOverride& bad : kBad) {
    const Loaded loaded = load(kGood, {{bad.path, bad.value}});
    EXPECT_EQ(loaded.findings,
              std::vector<std::string>{std::string("--set ") + bad.path +
                                       ": error: " + bad.finding});
    EXPECT_FALSE(loaded.scene);
  }
}

TEST(Override, KeepsAllFindingsOfAPlaceWithoutLines) {
  // The same problem under the same last key, told apart by nothing but the path.
  const Loaded loaded = load(kGood, {{"target.markers", "[[a, 0, 0], [a, 0, 0]]"}});
  EXPECT_EQ(loaded.findings.size(), 2u);
}

TEST(Override, IsReportedAfterTheScenesOwnFindings) {
  const Loaded loaded = load(good_with("rate: 50 Hz", "rate: 0"),
                             {{"nmae", "x"}, {"devices.s2.rate", "0"}});
  ASSERT_EQ(loaded.findings.size(), 3u);
  EXPECT_EQ(loaded.findings[0].substr(0, 16), "scene.yaml:14:11");
  EXPECT_EQ(loaded.findings[1].substr(0, 10), "--set nmae");
  EXPECT_EQ(loaded.findings[2].substr(0, 21), "--set devices.s2.rate");
}

}  // namespace
}  // namespace delos::test
