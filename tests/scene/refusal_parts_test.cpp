// Bad samples, devices and parameters.
#include "scene/refusal.h"

namespace delos::test {
namespace {

std::vector<Bad> bad_parts() {
  const auto e = in_scene;
  const std::string kVolume =
      "volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}";
  return {
      // ---- samples ----
      {"NoShape",
       good_with(kVolume, "name: bench"),
       {e("8:3: error: sample: nothing to sample; give volume, plane, points, "
          "file, path or mesh")}},
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
          "number or [x, y, z]; or give 'adaptive'")}},
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
       {e("8:9: error: sample.file: there is no readable file 'nowhere.ptl': No such "
          "file or directory")}},
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
      {"ExposureNegative",
       good_with("rate: 50 Hz", "rate: 50 Hz\n    exposure: -5 ms"),
       {e("15:15: error: devices.s1.exposure: must not be below 0")}},
      {"ExposureLongerThanThePeriod",
       good_with("rate: 50 Hz", "rate: 50 Hz\n    exposure: 21 ms"),
       {e("15:15: error: devices.s1.exposure: must not be longer than the time between "
          "updates, 20 ms at 50 Hz")}},
      {"ExposureIsATime",
       good_with("rate: 50 Hz", "rate: 50 Hz\n    exposure: 5 m"),
       {e("15:15: error: devices.s1.exposure: '5 m' is a length; expected a time such "
          "as "
          "'5 ms'")}},
      {"ExposureOfASingleReading",
       "covariance: single\n" +
           good_with("rate: 50 Hz", "rate: 50 Hz\n    exposure: 5 ms"),
       {e("16:15: error: devices.s1.exposure: isn't known to single readings, which "
          "are "
          "of one instant; leave it out, or use covariance: prior or posterior")}},
      {"ExposureUnderContinuousFusion",
       good_with("rate: 50 Hz", "rate: 60 Hz\n    exposure: 5 ms"),
       {e("15:15: error: devices.s1.exposure: isn't known to continuous fusion, the "
          "limit of frequent updates, in which no reading takes time; use fusion: "
          "periodic, or sequential")}},
      {"ExposureUnderArtemisFusion",
       "fusion: artemis\n" +
           good_with("rate: 50 Hz", "rate: 50 Hz\n    exposure: 5 ms"),
       {e("16:15: error: devices.s1.exposure: isn't known to artemis fusion; use "
          "fusion: "
          "stacked, periodic or sequential")}},
      {"ExposureOfCustomMotion",
       [] {
         std::string text = good_with("rate: 50 Hz", "rate: 50 Hz\n    exposure: 5 ms");
         const std::string chain =
             "  type: position_velocity\n  state: position\n  q: [0.4, 0.4, 0.1]\n";
         return text.replace(text.find(chain), chain.size(),
                             "  type: custom\n  A: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n"
                             "  Q: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n");
       }(),
       {e("15:15: error: devices.s1.exposure: needs a motion in continuous time, but "
          "custom motion says nothing of what happens between updates")}},
      {"ExposureOfMotionByMatrices",
       [] {
         std::string text = good_with("rate: 50 Hz", "rate: 50 Hz\n    exposure: 5 ms");
         const std::string chain =
             "  type: position_velocity\n  state: position\n  q: [0.4, 0.4, 0.1]\n";
         return text.replace(text.find(chain), chain.size(),
                             "  type: continuous\n  A: [[0, 0, 0], [0, 0, 0], [0, 0, "
                             "0]]\n  Q: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n");
       }(),
       {e("15:15: error: devices.s1.exposure: is of position, position_velocity and "
          "position_velocity_acceleration motion, not of one by matrices")}},
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
       {e("10:25: error: groups.rig1.yaw: unknown key; known: at, aim, roll, "
          "rpy, quaternion_wxyz")}},

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
  };
}

class RefusalOfParts : public testing::TestWithParam<Bad> {};

TEST_P(RefusalOfParts, IsLocatedAndExplained) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Scene, RefusalOfParts, testing::ValuesIn(bad_parts()),
                         [](const auto& i) { return i.param.name; });

}  // namespace
}  // namespace delos::test
