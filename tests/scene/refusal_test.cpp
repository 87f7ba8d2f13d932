// Bad scenes, and exactly what the user reads about each.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/load.h"

namespace delos::test {
namespace {

struct Bad {
  const char* name;
  std::string text;
  std::vector<std::string> findings;
};

void PrintTo(const Bad& bad, std::ostream* os) { *os << bad.name; }

std::vector<Bad> bad_texts() {
  const auto e = [](const char* rest) { return std::string("scene.yaml:") + rest; };
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
          "q, A, "
          "Q")}},
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
      {"LaterTopKeys",
       kGood + "beacons: {}\noccluders: []\nvariables: []\nconstraints: []\n"
               "objective: {}\n",
       {e("18:10: error: beacons: not supported by this version: sets of beacons for "
          "inside-out devices"),
        e("19:12: error: occluders: not supported by this version: what blocks the "
          "sight"),
        e("20:12: error: variables: not supported by this version: what a search may "
          "change"),
        e("21:14: error: constraints: not supported by this version: what a search "
          "must "
          "keep"),
        e("22:12: error: objective: not supported by this version: what a search makes "
          "small")}},
      {"LaterVolumeKey",
       good_with("step: 0.04", "step: 0.04, adaptive: {depth: 7}"),
       {e("8:72: error: sample.volume.adaptive: not supported by this version: "
          "refinement "
          "where the field bends")}},
      {"LaterSampleKey",
       good_with(kVolume, "mesh: torso.obj"),
       {e("8:9: error: sample.mesh: not supported by this version: samples on a "
          "surface")}},
      {"LaterMount",
       good_with("    rate: 50 Hz", "    mount: target\n    rate: 50 Hz"),
       {e("14:12: error: devices.s1.mount: 'target' is not supported by this version; "
          "devices are in the world")}},

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
       {e("7:13: error: covariance: 'P' is none of prior, posterior")}},

      // ---- motion ----
      {"MotionType",
       good_with("type: position_velocity", "type: brownian"),
       {e("4:9: error: motion.type: 'brownian' is none of position, position_velocity, "
          "position_velocity_acceleration, custom")}},
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
       {e("7:6: error: motion.A: only custom motion has it; q describes this type")}},
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

      // ---- samples ----
      {"NoShape",
       good_with(kVolume, "name: bench"),
       {e("8:3: error: sample: nothing to sample; give volume, plane, points or "
          "file")}},
      {"TwoShapes",
       good_with(kVolume, kVolume + "\n  points: [[0, 0, 0]]"),
       {e("9:11: error: sample.points: the set is given by 'volume' already; make a "
          "list of "
          "sets")}},
      {"MaxBelowMin",
       good_with("max: [0.4, 0.4, 0.8]", "max: [0.4, -1 cm, 0.8]"),
       {e("8:39: error: sample.volume.max.y: -1 cm is below min; exchange them")}},
      {"StepZero",
       good_with("step: 0.04", "step: 0"),
       {e("8:56: error: sample.volume.step: must be above 0")}},
      {"StepNegative",
       good_with("step: 0.04", "step: [0.1, -0.1, 0.1]"),
       {e("8:62: error: sample.volume.step.y: must be above 0")}},
      {"VolumeWithoutStep",
       good_with(", step: 0.04", ""),
       {e("8:11: error: sample.volume.step: missing: distance of samples, metres: a "
          "number "
          "or [x, y, z]")}},
      {"CountsZero",
       good_with(kVolume,
                 "plane: {origin: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0], counts: "
                 "[0, 1.5]}"),
       {e("8:67: error: sample.plane.counts.0: 0 is outside 1 to 2,147,483,647"),
        e("8:70: error: sample.plane.counts.1: expected a whole number, not '1.5'")}},
      {"NoPoints",
       good_with(kVolume, "points: []"),
       {e("8:11: error: sample.points: the list is empty; give at least one")}},
      {"NoSets",
       good_with("sample:\n  " + kVolume, "sample: []"),
       {e("7:9: error: sample: the list is empty; give at least one set")}},
      {"TooManySamples",
       good_with(kVolume,
                 "volume: {min: [0, 0, 0], max: [0.999, 0.999, 0.999], step: "
                 "0.001}"),
       // (1000)³; 368 samples an axis fit, 0.999/367 = 0.00272…, to two digits 0.0028.
       {e("8:62: error: sample.volume.step: 1,000,000,000 samples would need about 40 "
          "GB; "
          "at most 50,000,000: use step 0.0028 or coarser")}},
      {"TooManyUneven",
       good_with(kVolume,
                 "volume: {min: [0, 0, 0], max: [10, 10, 1], step: [0.01, 0.01, "
                 "0.001]}"),
       // 1001³; 0.027, 0.027, 0.0027 give 371³ = 51,064,811, still too many, and 0.027,
       // 0.027,
       // 0.0028 give 371²·358 = 49,275,478.
       {e("8:52: error: sample.volume.step: 1,003,003,001 samples would need about 40 "
          "GB; "
          "at most 50,000,000: use step [0.027, 0.027, 0.0028] or coarser")}},
      {"TooManyOnAPlane",
       good_with(kVolume,
                 "plane: {origin: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0], counts: "
                 "[20000, 10000]}"),
       // Half as many along both: √(50e6/200e6) = 1/2.
       {e("8:66: error: sample.plane.counts: 200,000,000 samples would need about 8 "
          "GB; at "
          "most 50,000,000: use counts [10000, 5000] or fewer")}},
      {"TooManyTogether",
       good_with("sample:\n  " + kVolume,
                 "sample:\n"
                 "  - volume: {min: [0, 0, 0], max: [299, 299, 299], step: 1}\n"
                 "  - volume: {min: [0, 0, 0], max: [299, 299, 299], step: 1}"),
       {e("8:3: error: sample: 54,000,000 samples would need about 2.2 GB; at most "
          "50,000,000: make the sets coarser")}},
      {"StepVanishes",
       good_with("step: 0.04", "step: 1e-320"),
       {e("8:56: error: sample.volume.step: is too small for this box")}},
      {"OrientationsInAList",
       good_with("sample:\n  " + kVolume,
                 "sample:\n  - " + kVolume + "\n    orientations: {rpy: [[0, 0, 0]]}"),
       {e("9:19: error: sample.0.orientations: orientations hold for all sets; put "
          "them "
          "beside 'sample'")}},
      {"OrientationsTwice",
       good_with(kVolume, kVolume + "\n  orientations: {combine: mean}\n"
                                    "orientations: {combine: worst}"),
       {e("10:15: error: orientations: are given inside 'sample' already; keep one")}},
      {"OrientationUnit",
       good_with(kVolume, kVolume + "\n  orientations: {rpy: [[1 m, 0, 0]]}"),
       {e("9:25: error: sample.orientations.rpy.0.roll: '1 m' is a length; expected an "
          "angle such as '60 deg'")}},
      {"SetNamesTwice",
       good_with("sample:\n  " + kVolume,
                 "sample:\n  - {name: a, points: [[0, 0, 0]]}\n  - "
                 "{name: a, points: [[0, 0, 0]]}"),
       {e("9:12: error: sample.a.name: 'a' is another set's name already")}},
      {"MissingFile",
       good_with(kVolume, "file: nowhere.ptl"),
       {e("8:9: error: sample.file: there is no readable file 'nowhere.ptl'")}},
      {"OtherFile",
       good_with(kVolume, "file: points.xyz"),
       {e("8:9: error: sample.file: 'points.xyz' is neither a .ptl nor a .csv file")}},

      // ---- devices ----
      {"NoDevices",
       kGood.substr(0, kGood.find("devices:")) + "devices: []\n",
       {e("11:10: error: devices: the list is empty; a system needs a device")}},
      {"DevicesMissing",
       kGood.substr(0, kGood.find("devices:")),
       {e("1:1: error: devices: missing: what measures")}},
      {"DeviceNamesTwice",
       good_with("name: s2", "name: s1"),
       {e("17:12: error: devices.s1.name: 's1' names the device on line 12 already")}},
      {"NameWithDot",
       good_with("name: s2", "name: s.2"),
       {e("17:12: error: devices.s.2.name: 's.2' holds '.' or '=', which separate the "
          "parts of a path; use '_'")}},
      {"NameMissing",
       good_with("name: s2, ", ""),
       {e("17:5: error: devices.1.name: missing: a word of your own that messages and "
          "paths use")}},
      {"RateZero",
       good_with("rate: 50 Hz", "rate: 0"),
       {e("14:11: error: devices.s1.rate: must be above 0; a device that is off is "
          "left "
          "out")}},
      {"RateNegative",
       good_with("rate: 50 Hz", "rate: -50 Hz"),
       {e("14:11: error: devices.s1.rate: must be above 0; a device that is off is "
          "left "
          "out")}},
      {"PhaseNegative",
       good_with("rate: 50 Hz", "rate: 50 Hz\n    phase: -5 ms"),
       {e("15:12: error: devices.s1.phase: must not be below 0")}},
      {"UnknownGroup",
       good_with("rate: 50 Hz", "rate: 50 Hz\n    group: rig2"),
       {e("15:12: error: devices.s1.group: there is no group 'rig2'; did you mean "
          "'rig1'?")}},
      {"NoGroupAtAll",
       good_with("groups:\n  rig1: {at: [0, 0, 2]}\ndevices:\n  - name: s1",
                 "devices:\n  - group: rig1\n    name: s1"),
       {e("10:12: error: devices.s1.group: there is no group 'rig1'; the scene "
          "declares "
          "none")}},
      {"AimAtItself",
       good_with("aim: [0, 0, 0]", "aim: [100 cm, 0, 1]"),
       {e("17:59: error: devices.s2.aim: is the same point as 'at'; choose a point to "
          "look "
          "at")}},
      {"TwoFacings",
       good_with("aim: [0, 0, 0]", "aim: [0, 0, 0], rpy: [0, 0, 0]"),
       {e("17:75: error: devices.s2.rpy: the orientation is given by 'aim' already; "
          "keep "
          "one")}},
      {"QuaternionZero",
       good_with("aim: [0, 0, 0]", "quaternion_wxyz: [0, 0, 0, 0]"),
       {e("17:71: error: devices.s2.quaternion_wxyz: has length zero, which is no "
          "orientation; identity is [1, 0, 0, 0]")}},
      {"QuaternionShort",
       good_with("aim: [0, 0, 0]", "quaternion_wxyz: [0, 0, 1]"),
       {e("17:71: error: devices.s2.quaternion_wxyz: expected four numbers [w, x, y, "
          "z], "
          "not 3 members")}},
      {"GroupPose",
       good_with("rig1: {at: [0, 0, 2]}", "rig1: {at: [0, 0, 2], yaw: 3}"),
       {e("10:25: error: groups.rig1.yaw: unknown key; known: at, aim, rpy, "
          "quaternion_wxyz")}},

      // ---- parameters ----
      {"ParamUnknown",
       good_with("{r: 5 mm}", "{r: 5 mm, focall: 1}"),
       {e("16:23: error: devices.s1.params.focall: unknown key; did you mean "
          "'focal'?")}},
      {"ParamMissing",
       good_with("{r: 5 mm}", "{focal: 1}"),
       {e("16:13: error: devices.s1.params.r: missing: Noise of a range.")}},
      {"ParamsMissing",
       good_with("    params: {r: 5 mm}\n", ""),
       {e("12:5: error: devices.s1.params.r: missing: Noise of a range.")}},
      {"ParamNegative",
       good_with("{r: 5 mm}", "{r: -5 mm}"),
       {e("16:17: error: devices.s1.params.r: -0.005 m is below the least value 0 m")}},
      {"ParamTooGreat",
       good_with("{r: 5 mm}", "{r: 1, gain: 101 %}"),
       {e("16:26: error: devices.s1.params.gain: 1.01 is above the greatest value 1")}},
      {"ParamUnit",
       good_with("{r: 5 mm}", "{r: 1, gain: 5 deg}"),
       {e("16:26: error: devices.s1.params.gain: '5 deg' is an angle; expected a pure "
          "number such as '0.5'")}},
      {"ParamChoice",
       good_with("{r: 5 mm}", "{r: 1, shape: squre}"),
       {e("16:27: error: devices.s1.params.shape: 'squre' is none of round, square, "
          "hexagonal; did you mean 'square'?")}},
      {"ParamLength",
       good_with("{r: 5 mm}", "{r: 1, resolution: [640, 480, 3]}"),
       {e("16:32: error: devices.s1.params.resolution: expected 2 numbers, not 3")}},
      {"ParamEntry",
       good_with("{r: 5 mm}", "{r: 1, resolution: [640, 0.5]}"),
       {e("16:38: error: devices.s1.params.resolution.1: 0.5 px is below the least "
          "value 1 "
          "px")}},
      {"ParamMatrix",
       good_with("{r: 5 mm}", "{r: 1, mix: [[1, 2], [3]]}"),
       {e("16:34: error: devices.s1.params.mix.1: the row has 1 number, the first has "
          "2")}},
      {"ParamsClash",
       good_with("{r: 5 mm}", "{r: 1, near: 20}"),
       {e("12:5: error: devices.s1: near must be below far; exchange them")}},
      {"StateSize",
       good_with("type: probe, rate: 50, at: [1, 0, 1], aim: [0, 0, 0], "
                 "params: {r: 0.005}",
                 "type: state_probe, rate: 50, params: {size: 5}"),
       {e("17:5: error: devices.s2: measures a state of 5 entries, but this motion's "
          "has 6: "
          "x, y, z, vx, vy, vz")}},

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

TEST_P(Refusal, IsLocatedAndExplained) {
  const Loaded loaded = load(GetParam().text);
  EXPECT_EQ(loaded.findings, GetParam().findings) << GetParam().text;
  EXPECT_FALSE(loaded.scene.has_value());
}

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
          "position_velocity_acceleration or custom",
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

TEST(RefusalOfLaughs, StopsAtAMillionNodes) {
  std::string text = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string from = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + from;
    for (int j = 1; j < 10; ++j) text += ", " + from;
    text += "]\n";
  }
  const auto findings = load(text).findings;
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].substr(findings[0].find("not a")),
            "not a readable YAML text: aliases make this text too large");
}

// ---- point files ----

std::vector<std::string> findings_of_file(const std::string& name,
                                          const std::string& content) {
  const Folder folder("points");
  std::ofstream(folder.path / name, std::ios::binary) << content;
  Diagnostics diagnostics;
  EXPECT_FALSE(
      parse_scene(good_with("volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: "
                            "0.04}",
                            "file: " + name),
                  folder.path / "scene.yaml", {}, plugins(), diagnostics));
  std::vector<std::string> findings;
  for (Diagnostic& d : diagnostics) {
    d.where.file = std::filesystem::path(d.where.file).filename();
    findings.push_back(to_string(d));
  }
  return findings;
}

TEST(RefusalOfPointFiles, IsLocatedInThem) {
  EXPECT_EQ(
      findings_of_file("a.ptl", "; heading\n0 0 0\n1 2\n1 2 3 4\n\n1 2 x\n1 nan 3\n"),
      (std::vector<std::string>{
          "a.ptl:3:3: error: expected three numbers x y z, found 2",
          "a.ptl:4:7: error: expected three numbers x y z, found 4",
          "a.ptl:6:5: error: 'x' isn't a number; rows are x y z in metres",
          "a.ptl:7:3: error: 'nan' isn't a finite number"}));
  EXPECT_EQ(
      findings_of_file("a.csv", "x,y,z\n1,2,3\nx,y,z\n1,,3\n1 m,2,3\n1,2,010\n"),
      (std::vector<std::string>{
          "a.csv:3:1: error: 'x' isn't a number; rows are x,y,z in metres",
          "a.csv:4:3: error: '' isn't a number; rows are x,y,z in metres",
          "a.csv:5:1: error: '1 m' isn't a number; rows are x,y,z in metres",
          "a.csv:6:5: error: '010' has a leading zero; numbers are decimal, leave it "
          "out"}));
}

TEST(RefusalOfPointFiles, StopsWhereTheFileIsOfAnotherKind) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "these are no numbers\n";
  const auto findings = findings_of_file("a.ptl", text);
  ASSERT_EQ(findings.size(), 21u);
  EXPECT_EQ(
      findings[20],
      "a.ptl:21: error: too many malformed rows; the rest of the file wasn't read");
}

TEST(RefusalOfPointFiles, WantsAtLeastOnePoint) {
  const auto findings = findings_of_file("a.csv", "x,y,z\n\n# nothing\n");
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].substr(0, 40), "scene.yaml:8:9: error: sample.file: the ");
}

TEST(RefusalOfFiles, NamesTheFile) {
  Diagnostics diagnostics;
  EXPECT_FALSE(load_scene("nowhere/scene.yaml", {}, plugins(), diagnostics));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(to_string(diagnostics[0]),
            "nowhere/scene.yaml: error: the scene can't be read: No such file or "
            "directory");
  EXPECT_TRUE(has_errors(diagnostics));
  EXPECT_FALSE(load_scene(".", {}, plugins(), diagnostics));
  EXPECT_EQ(to_string(diagnostics.at(1)),
            ".: error: the scene can't be read: it is a folder");
}

}  // namespace
}  // namespace delos::test
