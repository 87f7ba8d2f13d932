// Good scenes, and what becomes of them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "delos/sampling/samples.h"
#include "scene/load.h"

namespace delos::test {
namespace {

using std::numbers::pi;

TEST(Accept, ReadsEveryPartInSi) {
  const Scene s = accepted(kGood);
  EXPECT_EQ(s.name, "Good");
  EXPECT_EQ(s.motion.layout.order, 2);
  EXPECT_EQ(s.motion.layout.pose, PoseState::position);
  const auto& q = std::get<ChainMotion>(s.motion.dynamics).q;
  EXPECT_EQ(q, CoordinateMatrix(Eigen::Vector3d(0.4, 0.4, 0.1).asDiagonal()));
  ASSERT_EQ(s.samples.size(), 1u);
  const auto& v = std::get<VolumeSampling>(s.samples[0].shape);
  EXPECT_EQ(v.max, Eigen::Vector3d(0.4, 0.4, 0.8));
  EXPECT_EQ(v.step, Eigen::Vector3d(0.04, 0.04, 0.04));
  ASSERT_EQ(s.groups.size(), 1u);
  EXPECT_EQ(s.groups[0].name, "rig1");
  EXPECT_EQ(s.groups[0].placement.at, Eigen::Vector3d(0, 0, 2));
  ASSERT_EQ(s.devices.size(), 2u);
  EXPECT_EQ(s.devices[0].name, "s1");
  EXPECT_EQ(s.devices[0].type, "probe");
  EXPECT_EQ(s.devices[0].rate, 50);
  EXPECT_EQ(s.devices[0].phase, 0);
  EXPECT_EQ(s.devices[0].exposure, 0);
  EXPECT_EQ(s.devices[0].placement.at, Eigen::Vector3d(0, 0, 1));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(s.devices[0].placement.facing));
  EXPECT_EQ(s.devices[0].params["r"], 0.005);
  EXPECT_EQ(std::get<Aim>(s.devices[1].placement.facing).at, Eigen::Vector3d(0, 0, 0));
}

TEST(Accept, FillsInWhatIsNotSaid) {
  const Scene s = accepted(kGood);
  EXPECT_FALSE(s.fusion.has_value());
  EXPECT_EQ(s.covariance, CovarianceKind::prior);
  EXPECT_EQ(s.metric, "eigmax");
  EXPECT_EQ(s.markers, std::vector<Eigen::Vector3d>{Eigen::Vector3d::Zero()});
  EXPECT_EQ(s.orientations, Orientations{});
  const ParamValues& p = s.devices[0].params;
  EXPECT_EQ(p["focal"], 0.05);
  EXPECT_EQ(p.choice("shape"), "round");
  EXPECT_EQ(p.matrix("resolution"), Eigen::MatrixXd(Eigen::Vector2d(640, 480)));
  EXPECT_EQ(p.matrix("mix"), Eigen::MatrixXd(Eigen::MatrixXd::Identity(2, 3)));
  // In the order of the table, whatever was given.
  ASSERT_EQ(p.all().size(), 8u);
  EXPECT_EQ(p.all()[0].first, "r");
  EXPECT_EQ(p.all()[7].first, "mix");
}

TEST(Accept, ReadsWhatIsSaid) {
  std::string text =
      good_with("sample:",
                "fusion: periodic\ncovariance: posterior\nmetric: trace\n"
                "target: {markers: [[1 mm, 0, 0], [0, 2 in, 0]]}\nsample:");
  text.replace(text.find("    rate: 50 Hz"), 15,
               "    rate: 1.5 kHz\n    phase: 5 ms\n    exposure: 500 us\n    mount: "
               "world\n    group: rig1\n"
               "    rpy: [90 deg, 0, -0.5]");
  text.replace(
      text.find("{r: 5 mm}"), 9,
      "{r: 5 mm, shape: square, gain: 5 %, resolution: [1, 2 px], mix: [[3]]}");
  const Scene s = accepted(text);
  EXPECT_EQ(s.fusion, Fusion::periodic);
  EXPECT_EQ(s.covariance, CovarianceKind::posterior);
  EXPECT_EQ(s.metric, "trace");
  ASSERT_EQ(s.markers.size(), 2u);
  EXPECT_EQ(s.markers[0], Eigen::Vector3d(0.001, 0, 0));
  EXPECT_DOUBLE_EQ(s.markers[1].y(), 0.0508);
  const DeviceEntry& d = s.devices[0];
  EXPECT_EQ(d.rate, 1500);
  EXPECT_EQ(d.phase, 0.005);
  EXPECT_EQ(d.exposure, 0.0005);
  EXPECT_EQ(d.group, "rig1");
  EXPECT_EQ(std::get<Rpy>(d.placement.facing).angles, Eigen::Vector3d(pi / 2, 0, -0.5));
  EXPECT_EQ(d.params.choice("shape"), "square");
  EXPECT_EQ(d.params["gain"], 0.05);
  EXPECT_EQ(d.params.matrix("resolution"), Eigen::MatrixXd(Eigen::Vector2d(1, 2)));
  EXPECT_EQ(d.params.matrix("mix"), Eigen::MatrixXd::Constant(1, 1, 3));
}

TEST(Accept, TakesBoundsAsInclusive) {
  const Scene s = accepted(good_with("{r: 5 mm}", "{r: 0, gain: 100 %}"));
  EXPECT_EQ(s.devices[0].params["r"], 0);
  EXPECT_EQ(s.devices[0].params["gain"], 1);
}

TEST(Accept, ReadsAFullQWithUnits) {
  const Scene s =
      accepted(good_with("state: position\n  q: [0.4, 0.4, 0.1]",
                         "state: pose\n  q:\n"
                         "    - [1 cm^2/s^3, 0, 0, 1e-4 m rad/s^3, 0, 0]\n"
                         "    - [0, 1, 0, 0, 0, 0]\n    - [0, 0, 1, 0, 0, 0]\n"
                         "    - [1e-4, 0, 0, 2 rad^2/s^3, 0, 0]\n"
                         "    - [0, 0, 0, 0, 1, 0]\n    - [0, 0, 0, 0, 0, 1]"));
  const auto& q = std::get<ChainMotion>(s.motion.dynamics).q;
  EXPECT_EQ(q(0, 0), 1e-4);
  EXPECT_EQ(q(0, 3), 1e-4);
  EXPECT_EQ(q(3, 3), 2);
  EXPECT_EQ(s.motion.layout.coordinates(), 6);
}

TEST(Accept, ReadsCustomMotionWithExtraStates) {
  const std::string identity4 =
      "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]";
  const auto custom = [&](const std::string& names) {
    return good_with(
        "  type: position_velocity\n  state: position\n  q: [0.4, 0.4, 0.1]\n",
        "  type: custom\n" + names + "  A: " + identity4 +
            "\n  Q: [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 0]]\n");
  };
  const Scene s = accepted(custom("  names: [bias]\n"));
  EXPECT_FALSE(s.motion.is_chain());
  EXPECT_EQ(s.motion.layout.order, 1);
  EXPECT_EQ(s.motion.layout.extra, std::vector<std::string>{"bias"});
  EXPECT_EQ(s.motion.layout.size(), 4);
  EXPECT_EQ(std::get<CustomMotion>(s.motion.dynamics).Q(3, 3), 0);
  EXPECT_EQ(accepted(custom("")).motion.layout.extra,
            std::vector<std::string>{"extra1"});
}

TEST(Accept, ReadsSeveralSetsWithOrientationsBeside) {
  const Scene s = accepted(good_with(
      "sample:\n  volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}",
      "sample:\n"
      "  - {name: floor, plane: {origin: [0, 0, 0], u: [1 m, 0, 0], v: [0, 2, 0],"
      " counts: [3, 2]}}\n"
      "  - points: [[1, 2, 3]]\n"
      "  - volume: {min: [0, 0, 0], max: [1, 1, 1], step: [1, 0.5, 25 cm]}\n"
      "orientations: {rpy: [[0, 0, 0], [0, 0, 180 deg]], combine: mean}"));
  ASSERT_EQ(s.samples.size(), 3u);
  EXPECT_EQ(s.samples[0].name, "floor");
  EXPECT_EQ(sample_count(s.samples[0]), 6);
  EXPECT_EQ(std::get<PointSampling>(s.samples[1].shape).points[0],
            Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(sample_count(s.samples[2]), 2 * 3 * 5);
  ASSERT_EQ(s.orientations.rpy.size(), 2u);
  EXPECT_DOUBLE_EQ(s.orientations.rpy[1].z(), pi);
  EXPECT_EQ(s.orientations.combine, OrientationRule::mean);
}

TEST(Accept, ReadsPointFilesBesideTheScene) {
  const Folder folder;
  std::ofstream(folder / "z.ptl") << "; a comment\n\n 1 2 3\n4\t5 6 ; here too\r\n#x\n";
  std::ofstream(folder / "z.csv") << "\xEF\xBB\xBFX, Y, Z\n1, 2,3\n-1e-1,+2,.5\n";
  std::ofstream(folder / "scene.yaml") << good_with(
      "sample:\n  volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}",
      "sample: [{file: z.ptl}, {file: z.csv}]");
  Diagnostics diagnostics;
  const auto s = load_scene(folder / "scene.yaml", {}, plugins(), diagnostics);
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << to_string(d);
  ASSERT_TRUE(s);
  const auto& ptl = std::get<PointSampling>(s->samples[0].shape);
  EXPECT_EQ(ptl.file, "z.ptl");
  EXPECT_EQ(ptl.points, (std::vector<Eigen::Vector3d>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(std::get<PointSampling>(s->samples[1].shape).points,
            (std::vector<Eigen::Vector3d>{{1, 2, 3}, {-0.1, 2, 0.5}}));
}

TEST(Accept, TakesAliasesForWhatTheyStandFor) {
  std::string text =
      good_with("params: {r: 5 mm}", "params: &lens {r: 5 mm, focal: 8 mm}");
  text.replace(text.rfind("{r: 0.005}"), 10, "*lens");
  const Scene s = accepted(text);
  EXPECT_EQ(s.devices[1].params["focal"], 0.008);
}

TEST(Accept, TakesQuotedNumbers) {
  EXPECT_EQ(accepted(good_with("rate: 50 Hz", "rate: '50 Hz'")).devices[0].rate, 50);
}

TEST(Accept, DevicesOfTheStatesSize) {
  const Scene s = accepted(good_with(
      "type: probe, rate: 50, at: [1, 0, 1], aim: [0, 0, 0], params: {r: 0.005}",
      "type: state_probe, rate: 50, params: {size: 6}"));
  EXPECT_EQ(s.devices[1].params["size"], 6);
}

}  // namespace
}  // namespace delos::test
