// Bad variables, objectives and constraints.
#include "scene/refusal.h"

namespace delos::test {
namespace {

std::vector<Bad> bad_searches() {
  const auto e = in_scene;
  const auto with = [](const std::string& lines) { return kGood + lines; };
  return {
      {"UnknownDevice",
       with("variables:\n  - {path: devices.s3.at.z, lower: 0, upper: 1}\n"),
       {e("19:12: error: variables.0.path: 'devices.s3.at.z': there is no number 's3' "
          "here; did you mean 's1'?")}},
      {"UnknownParameter",
       with("variables:\n  - {path: devices.s1.params.focall, lower: 0, upper: 1}\n"),
       {e("19:12: error: variables.0.path: 'devices.s1.params.focall': there is no "
          "number 'focall' here; did you mean 'focal'?")}},
      {"NotANumber",
       with("variables:\n  - {path: devices.s1.params.shape, lower: 0, upper: 1}\n"),
       {e("19:12: error: variables.0.path: 'devices.s1.params.shape': a choice of "
          "words "
          "isn't a number; compare them with 'delos compare'")}},
      {"NotANumberByItself",
       with("variables:\n  - {path: devices.s1, lower: 0, upper: 1}\n"),
       {e("19:12: error: variables.0.path: 'devices.s1': isn't a number by itself; go "
          "on "
          "with at, rate, phase, exposure, params")}},
      {"LowerAboveUpper",
       with("variables:\n  - {path: devices.s1.at.z, lower: 2, upper: 1}\n"),
       {e("19:36: error: variables.0.lower: 2 isn't below upper, 1; a variable needs "
          "room to change")}},
      {"NoBounds",
       with("variables:\n  - {path: devices.s1.at.z, lower: 2}\n"),
       {e("19:5: error: variables.0.upper: missing: nothing is known of how far "
          "'devices.s1.at.z' may go")}},
      {"BelowTheTable",
       with("variables:\n  - {path: devices.s1.params.r, lower: -1, upper: 1}\n"),
       {e("19:40: error: variables.0.lower: -1 is below the least value of "
          "'devices.s1.params.r', 0")}},
      {"AnExposureLongerThanThePeriod",
       with("variables:\n  - {path: devices.s1.exposure, lower: 0, upper: 30 ms}\n"),
       {e("19:50: error: variables.0.upper: 0.03 is above the greatest value of "
          "'devices.s1.exposure', 0.02")}},
      {"AnExposureUnderContinuousFusion",
       with("fusion: continuous\nvariables:\n  - {path: devices.s1.exposure, lower: 0, "
            "upper: 10 ms}\n"),
       {e("20:3: error: variables: change an exposure, which isn't known to continuous "
          "fusion, the limit of frequent updates, in which no reading takes time; use "
          "fusion: periodic, or sequential")}},
      {"ChangedTwice",
       with("variables:\n  - {path: devices.s1.at.z, lower: 0, upper: 1}\n"
            "  - {path: devices.s2.at.z, lower: 0, upper: 1, tie: devices.s1.at.z}\n"),
       {e("20:5: error: variables.1: 'devices.s1.at.z' is changed by the variable on "
          "line 19 already")}},
      {"WrongLength",
       with("variables:\n  - {path: devices.s1.at, lower: [0, 0], upper: 1}\n"),
       {e("19:34: error: variables.0.lower: has 2 numbers, but the path means 3")}},
      {"UnknownMetric",
       with("objective: {minimize: mean, of: eigmx}\n"),
       {e("18:33: error: objective.of: unknown metric 'eigmx'; this state has sigma_x "
          "sigma_y sigma_z sigma_vx sigma_vy sigma_vz sigma_horizontal sigma_position "
          "eigmax eiglen mle "
          "trace det coverage footprint latency nonlinearity unscented_ratio")}},
      {"MoreIsBetter",
       with("objective: {minimize: mean, of: coverage}\n"),
       {e("18:23: error: objective.minimize: more coverage is better: maximize it")}},
      {"NoLimit",
       with("objective: {minimize: fraction}\n"),
       {e("18:12: error: objective.limit: missing: what a sample should keep to, in "
          "m")}},
      {"UnknownSet",
       with("objective: {minimize: mean, over: core}\n"),
       {e("18:35: error: objective.over: there is no sample set 'core'; no set of the "
          "scene has a name")}},
      {"Level",
       with("objective: {minimize: cvar, level: 1.5}\n"),
       {e("18:36: error: objective.level: must be above 0 and below 1")}},
      {"UnknownFailure",
       with("objective: {minimize: mean, robust: {failures: [s1, s3]}}\n"),
       {e("18:48: error: objective.robust.failures: there is no device 's3'; did you "
          "mean 's1'?")}},
      {"NothingWithstood",
       with("objective: {minimize: mean, robust: {}}\n"),
       {e("18:37: error: objective.robust: withstands nothing; give failures, mounting "
          "or noise")}},
      {"NegativeDeviations",
       with("objective:\n  robust: {mounting: {at: -1 cm, angle: 0}, noise: -10 %}\n"),
       {e("19:27: error: objective.robust.mounting.at: must be above 0; leave out what "
          "isn't drawn"),
        e("19:41: error: objective.robust.mounting.angle: must be above 0; leave out "
          "what isn't drawn"),
        e("19:52: error: objective.robust.noise: must be above 0; leave out what isn't "
          "drawn")}},
      {"NoDraws",
       with("objective: {minimize: mean, robust: {noise: 10 %, draws: 0}}\n"),
       {e("18:58: error: objective.robust.draws: 0 is outside 1 to 10,000")}},
      {"DrawsOfNothing",
       with("objective: {minimize: mean, robust: {failures: s1, draws: 4}}\n"),
       {e("18:59: error: objective.robust.draws: nothing is drawn; give mounting or "
          "noise")}},
      {"ASingleDevice",
       "delos: 1\nname: One\nmotion: {type: position, q: [1, 1, 1]}\n"
       "sample: {points: [[0, 0, 0]]}\ndevices:\n"
       "  - {name: s1, type: probe, rate: 50, at: [0, 0, 1], params: {r: 1}}\n"
       "objective: {minimize: mean, robust: {failures: s1}}\n",
       {e("7:48: error: objective.robust.failures: of a single device none may fail; "
          "nothing would be left")}},
      {"UnknownRegion",
       with("constraints:\n  - {inside: stage, devices: s1}\n"),
       {e("19:14: error: constraints.0.inside: there is no region 'stage'; the scene "
          "declares none")}},
      {"NoDevices",
       with("constraints:\n  - {spacing: 1, devices: cam*}\n"),
       {e("19:27: error: constraints.0.devices: there is no device 'cam*'; known: s1, "
          "s2")}},
      {"Nothing",
       with("constraints:\n  - {name: empty}\n"),
       {e("19:5: error: constraints.empty: keeps nothing; give inside, outside, "
          "spacing, "
          "tilt, clear, sum or metric")}},
      {"WrongSide",
       with("constraints:\n  - {metric: eigmax, above: 1 mm}\n"),
       {e("19:29: error: constraints.0.above: less eigmax is better: give below")}},
      {"ForeignKey",
       with("constraints:\n  - {spacing: 1, devices: \"*\", below: 3}\n"),
       {e("19:32: error: constraints.0.below: isn't for spacing")}},
  };
}

class BadSearch : public testing::TestWithParam<Bad> {};

TEST_P(BadSearch, IsExplained) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Scene, BadSearch, testing::ValuesIn(bad_searches()),
                         [](const auto& bad) { return bad.param.name; });

}  // namespace
}  // namespace delos::test
