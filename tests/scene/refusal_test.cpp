// Bad texts, keys, values, motion and fusion.
#include "scene/refusal.h"

namespace delos::test {
namespace {

std::vector<Bad> bad_texts() {
  const auto e = in_scene;
  const std::string kQ = "q: [0.4, 0.4, 0.1]";
  const std::string kVolume =
      "volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}";
  const auto motion = [](const std::string& lines) {
    return good_with(
        "  type: position_velocity\n  state: position\n  q: [0.4, 0.4, 0.1]\n", lines);
  };
  const std::string rows3 = "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]";
  return {
      // ---- the text as YAML ----
      {"Syntax",
       good_with("[0, 0, 0]", "[0, 0, 0"),
       {e("8:59: error: not a readable YAML text: illegal flow end")}},
      {"Tab",
       good_with("  state", "\tstate"),
       {e("5:1: error: not a readable YAML text: illegal tab when looking for "
          "indentation")}},
      {"Empty",
       "",
       {("scene.yaml: error: the scene is empty; begin the file with 'delos: 1'")}},
      {"NotAMapping",
       "- delos: 1\n",
       {e("1:1: error: expected a mapping, not a list")}},
      {"TwoDocuments",
       kGood + "---\ndelos: 1\n",
       {e("18:1: error: not a readable YAML text: a second document begins here")}},
      {"KeyIsNoWord",
       good_with("name: Good", "[a, b]: Good"),
       {e("2:1: error: not a readable YAML text: a key must be a word")}},
      {"AliasOfItself",
       good_with("name: Good", "name: &a [*a]"),
       {e("2:11: error: not a readable YAML text: this alias stands for what it is "
          "part "
          "of")}},
      {"UnknownAlias",
       good_with("name: Good", "name: *nobody"),
       {e("2:7: error: not a readable YAML text: the referenced anchor is not "
          "defined")}},

      // ---- keys ----
      {"NoVersion",
       good_with("delos: 1\n", ""),
       {e("1:1: error: delos: missing: the format's version; begin the file with "
          "'delos: "
          "1'")}},
      {"OtherVersion",
       good_with("delos: 1", "delos: 2"),
       {e("1:8: error: delos: '2' isn't a format version that this program reads; it "
          "reads 1")}},
      {"UnknownKey",
       good_with("name: Good", "nmae: Good"),
       {e("2:1: error: nmae: unknown key; did you mean 'name'?")}},
      {"UnknownKeyFarFromAll",
       good_with("  state: position", "  wheels: 4"),
       {e("5:3: error: motion.wheels: unknown key; known: type, state, order, names, "
          "q, A, Q, speed, acceleration, vertical, changes_within, named")}},
      {"UnknownDeviceKey",
       good_with("    rate: 50 Hz", "    rate: 50 Hz\n    ratte: 1"),
       {e("15:5: error: devices.s1.ratte: unknown key; did you mean 'rate'?")}},
      {"DuplicateKey",
       good_with("    rate: 50 Hz", "    rate: 50 Hz\n    rate: 60 Hz"),
       {e("15:5: error: devices.s1.rate: duplicate key; the first is on line 14")}},
      {"DuplicateTopKey",
       good_with("groups:", "name: Again\ngroups:"),
       {e("9:1: error: name: duplicate key; the first is on line 2")}},
      {"DuplicateGroup",
       good_with("devices:", "  rig1: {}\ndevices:"),
       {e("11:3: error: groups.rig1: duplicate key; the first is on line 10")}},
      {"MissingSample",
       good_with("sample:\n  " + kVolume + "\n", ""),
       {e("1:1: error: sample: missing: where the system is evaluated")}},
      {"MissingRate",
       good_with("    rate: 50 Hz\n", ""),
       {e("12:5: error: devices.s1.rate: missing: updates a second, such as 50 Hz")}},
      {"NoValue",
       good_with("rate: 50 Hz", "rate:"),
       {e("14:5: error: devices.s1.rate: no value is given: updates a second, such as "
          "50 "
          "Hz")}},
      {"NoSuchPath",
       good_with(kVolume, "path: walk.txt"),
       {e("8:9: error: sample.path: 'walk.txt' is neither a .ptl nor a .csv file")}},

      // ---- values ----
      {"WrongUnit",
       good_with("at: [0, 0, 1]", "at: [0, 50 Hz, 1]"),
       {e("15:13: error: devices.s1.at.y: '50 Hz' is a frequency; expected a length "
          "such "
          "as '50 mm'")}},
      {"NotANumber",
       good_with("at: [0, 0, 1]", "at: [0, 0, yes]"),
       {e("15:16: error: devices.s1.at.z: expected a length such as '50 mm', not "
          "'yes'")}},
      {"Octal",
       good_with("step: 0.04", "step: 010"),
       {e("8:56: error: sample.volume.step: '010' has a leading zero; numbers are "
          "decimal, "
          "leave it out")}},
      {"NotFinite",
       good_with("at: [0, 0, 1]", "at: [0, 0, .nan]"),
       {e("15:16: error: devices.s1.at.z: '.nan' isn't a finite number")}},
      {"ListForNumber",
       good_with("rate: 50 Hz", "rate: [50]"),
       {e("14:11: error: devices.s1.rate: expected a number, not a list")}},
      {"NumberForVector",
       good_with("at: [0, 0, 1]", "at: 3"),
       {e("15:9: error: devices.s1.at: expected three numbers [x, y, z], not a single "
          "value")}},
      {"ShortVector",
       good_with("at: [0, 0, 1]", "at: [0, 1]"),
       {e("15:9: error: devices.s1.at: expected three numbers [x, y, z], not 2 "
          "members")}},
      {"NullInVector",
       good_with("at: [0, 0, 1]", "at: [0, ~, 1]"),
       {e("15:13: error: devices.s1.at.y: expected a number, not nothing")}},
      {"UnknownWord",
       good_with("sample:", "fusion: stackd\nsample:"),
       {e("7:9: error: fusion: 'stackd' is none of stacked, continuous, periodic, "
          "sequential, artemis; did you mean 'stacked'?")}},
      {"UnknownCovariance",
       good_with("sample:", "covariance: P\nsample:"),
       {e("7:13: error: covariance: 'P' is none of prior, posterior, single")}},

      // ---- motion ----
      {"MotionType",
       good_with("type: position_velocity", "type: brownian"),
       {e("4:9: error: motion.type: 'brownian' is none of position, position_velocity, "
          "position_velocity_acceleration, custom, continuous")}},
      {"QMissing",
       good_with("  " + kQ + "\n", ""),
       {e("4:3: error: motion.q: missing: this type of motion needs it")}},
      {"QTooShort",
       good_with(kQ, "q: [0.4, 0.4]"),
       {e("6:6: error: motion.q: has 2 members, but the state 'position' has 3 "
          "coordinates")}},
      {"QForPose",
       good_with("state: position", "state: pose"),
       {e("6:6: error: motion.q: has 3 members, but the state 'pose' has 6 "
          "coordinates")}},
      {"QNegative",
       good_with(kQ, "q: [0.4, -0.4, 0]"),
       {e("6:12: error: motion.q.1: -0.4 isn't above 0; the noise that drives the "
          "motion "
          "must be positive"),
        e("6:18: error: motion.q.2: 0 isn't above 0; the noise that drives the motion "
          "must "
          "be positive")}},
      {"QUnit",
       good_with(kQ, "q: [0.4 m^2/s^3, 0.4 m^2/s, 0.1]"),
       {e("6:20: error: motion.q.1: '0.4 m^2/s' is in m^2 s^-1; expected a number in "
          "m^2/s^3")}},
      {"QNotSymmetric",
       good_with(kQ, "q: [[1, 0.5, 0], [0.2, 1, 0], [0, 0, 1]]"),
       {e("6:6: error: motion.q: is not symmetric: 0.1 is 0.5, 1.0 is 0.2")}},
      {"QNotPositive",
       good_with(kQ, "q: [[1, 2, 0], [2, 1, 0], [0, 0, 1]]"),
       {e("6:6: error: motion.q: is not positive definite: its least eigenvalue is "
          "-1")}},
      {"QRagged",
       good_with(kQ, "q: [[1, 0, 0], [0, 1], [0, 0, 1]]"),
       {e("6:18: error: motion.q.1: the row has 2 numbers, the first has 3")}},
      {"QNotSquare",
       good_with(kQ, "q: [[1, 0], [0, 1], [0, 0]]"),
       {e("6:6: error: motion.q: is 3×2, but the state has 3 coordinates")}},
      {"QOfCustom",
       motion("  type: custom\n  q: [1, 1, 1]\n  A: " + rows3 + "\n  Q: " + rows3 +
              "\n"),
       {e("5:6: error: motion.q: custom motion is described by A and Q instead")}},
      {"AOfChain",
       good_with(kQ, kQ + "\n  A: " + rows3),
       {e("7:6: error: motion.A: only custom and continuous motion have it; q "
          "describes this type")}},
      {"CustomWithoutA",
       motion("  type: custom\n  Q: " + rows3 + "\n"),
       {e("4:3: error: motion.A: missing: this type of motion needs it")}},
      {"CustomNotSquare",
       motion("  type: custom\n  A: [[1, 0], [0, 1], [0, 0]]\n  Q: " + rows3 + "\n"),
       {e("5:6: error: motion.A: is 3×2, but must be square")}},
      {"CustomSizesDiffer",
       motion("  type: custom\n  A: " + rows3 + "\n  Q: [[1, 0], [0, 1]]\n"),
       {e("6:6: error: motion.Q: has 2 rows, A has 3")}},
      {"CustomTooSmall",
       motion("  type: custom\n  order: 2\n  A: " + rows3 + "\n  Q: " + rows3 + "\n"),
       {e("6:6: error: motion.A: has 3 states, but 2 × 3 coordinates need at least "
          "6")}},
      {"CustomQNegative",
       motion("  type: custom\n  A: " + rows3 +
              "\n  Q: [[1, 0, 0], [0, -2, 0], [0, 0, 1]]\n"),
       {e("6:6: error: motion.Q: is not positive semidefinite: its least eigenvalue is "
          "-2")}},
      {"CustomQNotSymmetric",
       motion("  type: custom\n  A: " + rows3 +
              "\n  Q: [[1, 0, 3], [0, 1, 0], [0, 0, 1]]\n"),
       {e("6:6: error: motion.Q: is not symmetric: 0.2 is 3, 2.0 is 0")}},
      {"CustomUnit",
       motion("  type: custom\n  A: [[1, 0, 0], [0, 1 m, 0], [0, 0, 1]]\n  "
              "Q: " +
              rows3 + "\n"),
       {e("5:22: error: motion.A.1.1: '1 m' is a length; expected a pure number such "
          "as "
          "'0.5'")}},
      {"CustomOrder",
       motion("  type: custom\n  order: 4\n  A: " + rows3 + "\n  Q: " + rows3 + "\n"),
       {e("5:10: error: motion.order: 4 is outside 1 to 3")}},
      {"CustomNamesCount",
       motion("  type: custom\n  names: [bias]\n  A: " + rows3 + "\n  Q: " + rows3 +
              "\n"),
       {e("5:10: error: motion.names: has 1 names, but 0 of the 3 states are behind "
          "the "
          "blocks of coordinates")}},
      {"CustomNamesTaken",
       motion(
           "  type: custom\n  names: [x]\n  A: [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, "
           "0], [0, 0, 0, 1]]\n  Q: [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, "
           "0, 0]]\n"),
       {e("5:11: error: motion.names.0: 'x' names another state already")}},

      // ---- fusion ----
      {"StackedRates",
       good_with("sample:", "fusion: stacked\nsample:")
           .replace(good_with("sample:", "fusion: stacked\nsample:").find("50 Hz"), 5,
                    "20 Hz"),
       {e("7:9: error: fusion: stacked needs one rate, but s1 has 20 Hz and s2 has 50 "
          "Hz; "
          "use continuous or periodic")}},
      {"ContinuousCustom",
       "fusion: continuous\n" +
           motion("  type: custom\n  A: " + rows3 + "\n  Q: " + rows3 + "\n"),
       {e("1:9: error: fusion: continuous needs a motion in continuous time, which "
          "custom "
          "motion isn't; use stacked")}},
  };
}

class Refusal : public testing::TestWithParam<Bad> {};

TEST_P(Refusal, IsLocatedAndExplained) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Scene, Refusal, testing::ValuesIn(bad_texts()),
                         [](const auto& i) { return i.param.name; });

TEST(RefusalOfPlugins, IsWhatTheRegistrySays) {
  const Loaded loaded = load(good_with("type: probe", "type: prob"));
  ASSERT_EQ(loaded.findings.size(), 1u);
  EXPECT_EQ(loaded.findings[0], "scene.yaml:13:11: error: devices.s1.type: " +
                                    plugins().find("prob").error);
}

TEST(RefusalOfCustomRates, NeedsOneRate) {
  const std::string custom =
      "  type: custom\n  A: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"
      "  Q: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n";
  std::string text = good_with(
      "  type: position_velocity\n  state: position\n  q: [0.4, 0.4, 0.1]\n", custom);
  text.replace(text.find("50 Hz"), 5, "20 Hz");
  EXPECT_EQ(
      load(text).findings,
      std::vector<std::string>{
          "scene.yaml:4:3: error: motion: custom motion is one update of one rate, "
          "but s1 has 20 Hz and s2 has 50 Hz; make them equal"});
  EXPECT_EQ(
      load("fusion: artemis\n" + text).findings,
      std::vector<std::string>{
          "scene.yaml:1:9: error: fusion: custom motion is one update of one rate, "
          "but s1 has 20 Hz and s2 has 50 Hz; make them equal"});
}

TEST(RefusalOfSeveral, ReportsAllInTheOrderOfTheText) {
  const Loaded loaded = load(
      "delos: 1\n"
      "motion:\n"
      "  q: [1, 1, -1]\n"
      "  typ: position\n"
      "sample: {volume: {min: [0, 0, 0], max: [1, 1, 1], step: 0}}\n"
      "metrik: eigmax\n"
      "devices:\n"
      "  - {name: a, type: probe, rate: 5 m, params: {r: 3, gain: 2}}\n"
      "  - {name: b, type: probe, rate: 5, params: {r: 1, r: 2}}\n");
  EXPECT_EQ(
      loaded.findings,
      (std::vector<std::string>{
          "scene.yaml:3:3: error: motion.type: missing: position, position_velocity, "
          "position_velocity_acceleration, custom or continuous",
          "scene.yaml:4:3: error: motion.typ: unknown key; did you mean 'type'?",
          "scene.yaml:5:57: error: sample.volume.step: must be above 0",
          "scene.yaml:6:1: error: metrik: unknown key; did you mean 'metric'?",
          "scene.yaml:8:34: error: devices.a.rate: '5 m' is a length; expected a "
          "frequency "
          "such as '100 Hz'",
          "scene.yaml:8:51: error: devices.a.params.r: 3 m is above the greatest value "
          "2 m",
          "scene.yaml:8:60: error: devices.a.params.gain: 2 is above the greatest "
          "value 1",
          "scene.yaml:9:52: error: devices.b.params.r: duplicate key; the first is on "
          "line 9"}));
  EXPECT_FALSE(loaded.scene.has_value());
}

TEST(RefusalOfAnchors, IsReportedOnce) {
  const Loaded loaded = load(
      good_with("params: {r: 5 mm}", "params: &p {r: 5 s}")
          .replace(
              good_with("params: {r: 5 mm}", "params: &p {r: 5 s}").rfind("{r: 0.005}"),
              10, "*p"));
  EXPECT_EQ(
      loaded.findings,
      (std::vector<std::string>{
          "scene.yaml:16:20: error: devices.s1.params.r: '5 s' is a time; expected a "
          "length such as '50 mm'"}));
}

TEST(RefusalOfLaughs, StopsWhereCopiesFillMemory) {
  // Each level holds the one before ten times.
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (char level = '1'; level < '9'; ++level) {
    const std::string name{'a', level}, inner{'*', 'a', static_cast<char>(level - 1)};
    text.append(name).append(": &").append(name).append(" [").append(inner);
    for (int j = 1; j < 10; ++j) text.append(", ").append(inner);
    text.append("]\n");
  }
  const auto findings = load(text).findings;
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].substr(findings[0].find("not a")),
            "not a readable YAML text: anchors and aliases make this text too large");
}

}  // namespace
}  // namespace delos::test
