// Scenes of a plane, of any state, and of motion in continuous time: read, and refused
// at their place.
#include "scene/refusal.h"

namespace delos::test {
namespace {

const std::string kMotion =
    "motion:\n  type: position_velocity\n  state: position\n  q: [0.4, 0.4, 0.1]\n";
const std::string kSecond =
    "{name: s2, type: probe, rate: 50, at: [1, 0, 1], aim: [0, 0, 0], params: {r: "
    "0.005}}";

/// kGood with another motion, which keeps the lines of the rest.
std::string moving(const std::string& second, const std::string& third,
                   const std::string& fourth) {
  return good_with(kMotion,
                   "motion:\n  " + second + "\n  " + third + "\n  " + fourth + "\n");
}

std::string planar(const std::string& more = "") {
  return moving("type: position_velocity", "state: planar", "q: [0.4, 0.4]") + more;
}

/// A state of one level, which `device` reads.
std::string level(const std::string& more = "metric: sigma_level\n",
                  const std::string& device = "type: state_probe, params: {size: 1}") {
  return "delos: 1\n"
         "motion: {type: custom, state: none, names: [level], A: [[0.9]], Q: [[1]]}\n"
         "sample: {points: [[0, 0, 0]]}\n"
         "devices: [{name: a, rate: 5, " +
         device + "}]\n" + more;
}

TEST(AcceptPlanar, StatesOfAPlane) {
  const Scene s = accepted(planar("metric: sigma_horizontal\n"));
  EXPECT_EQ(s.motion.layout.pose, PoseState::planar);
  EXPECT_EQ(s.motion.layout.size(), 4);
  const Scene pose = accepted(
      moving("type: position", "state: planar_pose", "q: [1 m^2/s, 1, 4 rad^2/s]") +
      "metric: sigma_yaw\n");
  EXPECT_EQ(std::get<ChainMotion>(pose.motion.dynamics).q(2, 2), 4);
}

TEST(AcceptPlanar, ThePoseIsMeasuredWhereTheStateHasOne) {
  std::string text = moving("type: position", "state: planar_pose", "q: [1, 1, 1]");
  text.replace(text.find(kSecond), kSecond.size(),
               "{name: s2, type: pose_probe, rate: 50}");
  EXPECT_EQ(accepted(text).devices[1].type, "pose_probe");
}

TEST(AcceptPlanar, CustomMotionOfOneState) {
  const Scene s = accepted(level());
  EXPECT_EQ(s.motion.layout.names(), std::vector<std::string>{"level"});
  EXPECT_EQ(s.motion.layout.size(), 1);
  EXPECT_EQ(accepted(write_scene(s)), s);
}

TEST(AcceptPlanar, MotionInContinuousTimeTakesEveryFusion) {
  const std::string flat = moving("type: continuous", "state: planar",
                                  "A: [[0, 0], [0, -1]]\n  Q: [[1, 0], [0, 1]]");
  for (const char* fusion : {"stacked", "continuous", "periodic", "sequential"}) {
    const Scene s = accepted(flat + "fusion: " + fusion + "\n");
    EXPECT_EQ(std::get<ContinuousMotion>(s.motion.dynamics).A(1, 1), -1);
  }
  // Unlike custom motion, it can be of several rates.
  std::string rates = flat;
  rates.replace(rates.find("rate: 50,"), 9, "rate: 40,");
  accepted(rates);
}

std::vector<Bad> bad_planes() {
  const auto e = in_scene;
  std::string pose = planar();
  pose.replace(pose.find(kSecond), kSecond.size(),
               "{name: s2, type: pose_probe, rate: 50}");
  std::string spatial = planar();
  spatial.replace(spatial.find(kSecond), kSecond.size(),
                  "{name: s2, type: state_probe, rate: 50, params: {size: 6}}");
  return {
      {"NoiseOfSpace",
       good_with("state: position", "state: planar"),
       {e("6:6: error: motion.q: has 3 members, but the state 'planar' has 2 "
          "coordinates")}},
      {"DeviceOfSpace",
       spatial,
       {e("17:5: error: devices.s2: measures a state of 6 entries, but this motion's "
          "has 4: x, y, vx, vy")}},
      {"PoseInAPlaneWithoutHeading",
       pose,
       {e("17:5: error: devices.s2: measures the target's whole pose, of which the "
          "state 'planar' leaves the heading out; use planar_pose")}},
      {"MetricOfHeight",
       planar("metric: sigma_z\n"),
       {e("18:9: error: metric: unknown metric 'sigma_z'; this state has sigma_x "
          "sigma_y sigma_vx sigma_vy sigma_horizontal sigma_position eigmax eiglen mle "
          "trace det coverage footprint latency nonlinearity unscented_ratio")}},
      {"OrientationWithoutHeading",
       planar("objective: {minimize: mean, of: sigma_orientation}\n"),
       {e("18:33: error: objective.of: unknown metric 'sigma_orientation'; this state "
          "has sigma_x sigma_y sigma_vx sigma_vy sigma_horizontal sigma_position "
          "eigmax "
          "eiglen mle trace det coverage footprint latency nonlinearity "
          "unscented_ratio")}},
      {"SingleReadingWithoutPose",
       level("covariance: single\nmetric: sigma_level\n"),
       {e("5:13: error: covariance: single is of the target's pose, which this state "
          "doesn't have")}},
      {"PointsWithoutPose",
       level("metric: sigma_level\n", "type: probe, params: {r: 1}"),
       {e("4:11: error: devices.a: measures where the target is, but this state has no "
          "pose")}},
      {"UsualMetricWithoutPose",
       level(""),
       {e("2:9: error: motion: has no pose for the usual metric; name another in "
          "'metric': unknown metric 'eigmax'; this state has sigma_level mle coverage "
          "footprint latency nonlinearity unscented_ratio")}},
      {"ChainWithoutPose",
       good_with("state: position", "state: none"),
       {e("5:10: error: motion.state: is for custom and continuous motion; this type "
          "moves coordinates of a pose")}},
      {"BlocksWithoutPose",
       moving("type: custom", "state: none", "order: 2\n  A: [[1]]\n  Q: [[1]]") +
           "metric: sigma_extra1\n",
       {e("6:10: error: motion.order: is of blocks of coordinates, but this state has "
          "none")}},
      {"ContinuousWithoutA",
       moving("type: continuous", "state: planar", "Q: [[1, 0], [0, 1]]"),
       {e("4:3: error: motion.A: missing: this type of motion needs it")}},
      {"ContinuousWithq",
       moving("type: continuous", "state: planar",
              "q: [1, 1]\n  A: [[0, 0], [0, 0]]\n  Q: [[1, 0], [0, 1]]"),
       {e("6:6: error: motion.q: continuous motion is described by A and Q instead")}},
      {"TooFewForAPlane",
       moving("type: continuous", "state: planar", "A: [[0]]\n  Q: [[1]]"),
       {e("6:6: error: motion.A: has 1 state, but 1 × 2 coordinates need at least "
          "2")}},
  };
}

class RefusedPlane : public testing::TestWithParam<Bad> {};

TEST_P(RefusedPlane, WithTheseFindings) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Scene, RefusedPlane, testing::ValuesIn(bad_planes()),
                         [](const auto& i) { return std::string(i.param.name); });

}  // namespace
}  // namespace delos::test
