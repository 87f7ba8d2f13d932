// Devices put somewhere by hand: afterwards they stand there, says the rig.
#include "session/placing.h"

#include <cmath>
#include <numbers>

#include "designs.h"

namespace delos::session {
namespace {

const Eigen::Vector3d kPlace(0.3, -0.7, 2.1);

Eigen::Matrix3d some_rotation() {
  return Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -0.5, 0.8).normalized())
      .toRotationMatrix();
}

Pose placed(Design& design, const std::string& device,
            const std::optional<Eigen::Vector3d>& p,
            const std::optional<Eigen::Matrix3d>& R) {
  const auto changes = placing(design.loaded().scene, device, p, R);
  EXPECT_TRUE(std::holds_alternative<std::vector<Override>>(changes));
  change(design, std::get<std::vector<Override>>(changes));
  for (const PlacedDevice& d : design.loaded().system.devices)
    if (d.name == device) return d.X_WS();
  ADD_FAILURE();
  return {};
}

TEST(Placing, TurnsAQuaternion) {
  Design design = design_of("05-optitrack-lab");
  const Pose X = placed(design, "c104325", kPlace, some_rotation());
  EXPECT_LT((X.p - kPlace).norm(), 1e-12);
  EXPECT_LT((X.R - some_rotation()).norm(), 1e-9);
  EXPECT_TRUE(std::holds_alternative<QuaternionWxyz>(
      design.loaded().scene.devices[1].placement.facing));
}

TEST(Placing, GivesAnglesToWhatHadNoOrientation) {
  Design design = design_of("01-acoustic");
  const Pose X = placed(design, "s1", std::nullopt, some_rotation());
  EXPECT_LT((X.R - some_rotation()).norm(), 1e-9);
  EXPECT_EQ(X.p, design_of("01-acoustic").loaded().system.devices[0].X_WS().p);
}

/// An aim keeps its distance and, moved alone, its point.
TEST(Placing, MovesAnAim) {
  Design design = design_of("02-eight-cameras");
  const DeviceEntry before = design.loaded().scene.devices[0];
  const Eigen::Vector3d at = std::get<Aim>(before.placement.facing).at;
  const Pose moved = placed(design, before.name, kPlace, std::nullopt);
  EXPECT_LT((moved.R.col(2) - (at - kPlace).normalized()).norm(), 1e-12);

  const Pose turned = placed(design, before.name, std::nullopt, some_rotation());
  EXPECT_LT((turned.R.col(2) - some_rotation().col(2)).norm(), 1e-12);
  const auto& aim = std::get<Aim>(design.loaded().scene.devices[0].placement.facing);
  EXPECT_NEAR((aim.at - kPlace).norm(), (at - kPlace).norm(), 1e-12);
}

/// The group stands elsewhere and is turned; the hand moves in the world.
TEST(Placing, StaysInItsGroup) {
  const std::string text = R"(delos: 1
name: grouped
motion: {type: position_velocity, q: [0.4, 0.4, 0.1]}
sample: {points: [[0, 0, 0]]}
groups: {stand: {at: [1, 2, 3], rpy: [0.1, 0.2, 0.3]}}
devices:
  - {name: a, type: acoustic_range, rate: 50 Hz, group: stand, at: [1, 0, 0], rpy: [0, 0, 1], params: {r: 0.005}}
)";
  Diagnostics findings;
  auto scene = parse_scene(text, "scene.yaml", {}, plugins(), findings);
  ASSERT_TRUE(scene) << to_string(findings.at(0));
  const auto changes = placing(*scene, "a", kPlace, some_rotation());
  scene = parse_scene(text, "scene.yaml", std::get<std::vector<Override>>(changes),
                      plugins(), findings);
  ASSERT_TRUE(scene);
  const Pose X = device_pose(*scene, scene->devices[0]);
  EXPECT_LT((X.p - kPlace).norm(), 1e-12);
  EXPECT_LT((X.R - some_rotation()).norm(), 1e-9);
  EXPECT_EQ(scene->devices[0].group, "stand");
}

TEST(Placing, SaysWhyItCannot) {
  const auto why = [](const char* scene, const char* device) {
    const auto changes =
        placing(design_of(scene).loaded().scene, device, kPlace, std::nullopt);
    const auto* text = std::get_if<std::string>(&changes);
    return text ? *text : "";
  };
  EXPECT_NE(why("09-camera-room", "west").find("mounted on"), std::string::npos);
  EXPECT_NE(why("hiball/six-lepd", "hiball").find("carried"), std::string::npos);
  EXPECT_NE(why("01-acoustic", "nobody").find("no device 'nobody'"), std::string::npos);
}

TEST(RollPitchYaw, AreThoseOfTheRotation) {
  const double right = std::numbers::pi / 2;
  for (const double roll : {-3.0, 0.0, 0.7})
    for (const double pitch : {-right, -1.2, 0.0, 0.4, right})
      for (const double yaw : {-2.0, 0.0, 3.1}) {
        const Eigen::Matrix3d R = rotation_from_rpy({roll, pitch, yaw});
        EXPECT_LT((rotation_from_rpy(rpy_of(R)) - R).norm(), 1e-8)
            << roll << " " << pitch << " " << yaw;
      }
}

}  // namespace
}  // namespace delos::session
