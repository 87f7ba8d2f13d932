// Devices more and fewer: what is added is what was asked for, and goes again.
#include "session/more_devices.h"

#include <cmath>

#include "delos/field/blind.h"
#include "delos/scene/presets.h"
#include "designs.h"
#include "session/description.h"
#include "session/palette.h"
#include "session/point_answer.h"

namespace delos::session {
namespace {

/// Take the first way, which must do.
void take(Design& design, const Ways& ways) {
  const auto* all = std::get_if<0>(&ways);
  ASSERT_TRUE(all) << std::get<std::string>(ways);
  change(design, all->front());
}

const DeviceEntry& last(const Design& design) {
  return design.loaded().scene.devices.back();
}

/// Every plugin that observes a point can be put into a room, as it comes and as any
/// device that one can buy.
TEST(MoreDevices, OfEveryPluginThatSeesAPoint) {
  const Eigen::Vector3d at(1, -1, 2.5);
  for (const std::string type :
       {"acoustic_range", "bearing", "camera", "custom", "depth_camera", "goniometer",
        "lighthouse", "linkage", "magnetic_dipole", "pinhole_camera", "range",
        "uwb_range"}) {
    Design design = design_of("05-optitrack-lab");
    const std::size_t before = design.loaded().scene.devices.size();
    take(design, adding(design.loaded(), type, "", at, plugins()));
    ASSERT_EQ(design.loaded().scene.devices.size(), before + 1) << type;
    EXPECT_EQ(last(design).type, type);
    const Pose X = design.loaded().system.devices.back().X_WS();
    EXPECT_LT((X.p - at).norm(), 1e-12);
    const Eigen::Vector3d towards = sample_box(design.loaded().scene).center() - at;
    EXPECT_LT((X.R.col(2) - towards.normalized()).norm(), 1e-9) << type;
  }
  for (const DevicePreset& preset : device_presets()) {
    EXPECT_NE(preset_params(preset.type, preset.name), "");
    if (std::string(preset.type) == "imu") continue;
    Design design = design_of("05-optitrack-lab");
    take(design, adding(design.loaded(), preset.type, preset.name, at, plugins()));
    EXPECT_EQ(last(design).type, preset.type) << preset.name;
  }
}

/// Everything in the palette has parameters to begin with.
TEST(MoreDevices, AreAllInThePalette) {
  const Json palette = palette_json(plugins());
  EXPECT_GE(palette["types"].size(), 18u);
  for (const Json& type : palette["types"]) EXPECT_TRUE(type["ready"]) << type;
  EXPECT_EQ(palette["presets"].size(), device_presets().size());
}

/// What moves with the target is carried by it: the second way.
TEST(MoreDevices, AreCarriedWhereTheyMustBe) {
  Design design = design_of("05-optitrack-lab");
  const auto ways = std::get<0>(
      adding(design.loaded(), "accelerometer", "", std::nullopt, plugins()));
  ASSERT_GE(ways.size(), 2u);
  EXPECT_NE(ways[1].front().value.find("mount: target"), std::string::npos);
}

/// A HiBall in a room without beacons gets a ceiling of them, as one step, and sees it
/// from the middle of the samples.
TEST(MoreDevices, GetACeilingOfBeacons) {
  Design design = design_of("05-optitrack-lab");
  const auto ways =
      std::get<0>(adding(design.loaded(), "hiball", "", std::nullopt, plugins()));
  change(design, ways.front());
  EXPECT_EQ(design.history().undoable(), 1u);
  ASSERT_EQ(design.loaded().scene.beacons.size(), 1u);
  const Eigen::AlignedBox3d samples = sample_box(design.loaded().scene);
  const auto& grid = std::get<BeaconGrid>(design.loaded().scene.beacons[0].layout);
  EXPECT_GT(grid.box.min.z(), samples.max().z());
  const PointAnswer answer = answer_point(design.loaded(), samples.center(),
                                          Eigen::Vector3d::Zero(), Solver::automatic);
  const Json devices = point_json(answer, design.loaded())["devices"];
  EXPECT_EQ(devices.back()["type"], "hiball");
  EXPECT_TRUE(devices.back()["visible"]);
  design.undo(plugins());
  EXPECT_TRUE(design.loaded().scene.beacons.empty());
  // Where there are beacons there is no need of more.
  const auto below = std::get<0>(adding(design_of("hiball/six-lepd").loaded(), "hiball",
                                        "", std::nullopt, plugins()));
  EXPECT_EQ(below.front().size(), 1u);
}

/// Speakers of scene 01 stand in the corners of a square about the samples' middle: the
/// mirror of one is another.
TEST(MoreDevices, AreMirrored) {
  Design design = design_of("01-acoustic");
  const auto place = [&](std::size_t i) {
    return design.loaded().system.devices[i].X_WS().p;
  };
  take(design, mirroring(design.loaded(), "s1", 0));
  bool found = false;
  for (std::size_t i = 1; i < 4; ++i) found |= (place(i) - place(4)).norm() < 1e-12;
  EXPECT_TRUE(found) << place(4).transpose();
  EXPECT_NE(place(4).x(), place(0).x());
}

/// A mirrored camera sees the mirror of what the first one sees, and nothing else.
TEST(MoreDevices, SeeTheMirrorOfWhatTheFirstOneSees) {
  for (const auto& [scene, device] :
       {std::pair{"05-optitrack-lab", "c104321"}, {"02-eight-cameras", "lower1"}}) {
    for (const int axis : {0, 1}) {
      Design design = design_of(scene);
      const auto& devices = design.loaded().scene.devices;
      std::size_t first = 0;
      while (first + 1 < devices.size() && devices[first].name != device) ++first;
      take(design, mirroring(design.loaded(), devices[first].name, axis));
      const Eigen::AlignedBox3d box = sample_box(design.loaded().scene);
      std::vector<Eigen::Vector3d> points, mirrored;
      for (int i = 0; i < 400; ++i) {
        const Eigen::Vector3d part(std::fmod(i * 0.618034, 1),
                                   std::fmod(i * 0.414214, 1),
                                   std::fmod(i * 0.732051, 1));
        points.emplace_back(box.min() + part.cwiseProduct(box.sizes()));
        mirrored.push_back(points.back());
        mirrored.back()(axis) = 2 * box.center()(axis) - mirrored.back()(axis);
      }
      const auto seen = seen_points(design.loaded().system, {}, points);
      const auto seen_mirrored = seen_points(design.loaded().system, {}, mirrored);
      EXPECT_EQ(seen[first], seen_mirrored.back()) << scene << " " << axis;
      EXPECT_NE(seen[first], seen.back());
    }
  }
}

TEST(MoreDevices, AreCopies) {
  Design design = design_of("02-eight-cameras");
  const DeviceEntry first = design.loaded().scene.devices[0];
  const Pose before = design.loaded().system.devices[0].X_WS();
  take(design, copying(design.loaded(), first.name, {0.5, 0, 0.25}));
  EXPECT_EQ(last(design).name, first.name + "_2");
  EXPECT_EQ(last(design).params, first.params);
  const Pose X = design.loaded().system.devices.back().X_WS();
  EXPECT_LT((X.p - before.p - Eigen::Vector3d(0.5, 0, 0.25)).norm(), 1e-12);
  EXPECT_LT((X.R - before.R).norm(), 1e-12) << "it looks the same way";
  EXPECT_EQ(free_name(design.loaded().scene, first.name + "_2"), first.name + "_3");
}

/// Back and forth, to the same bytes.
TEST(MoreDevices, AreUndoneAndRedone) {
  Design design = design_of("02-eight-cameras");
  std::vector<std::string> texts = {design.text()};
  const auto step = [&](const Ways& ways) {
    take(design, ways);
    texts.push_back(design.text());
  };
  const std::string first = design.loaded().scene.devices[0].name;
  step(adding(design.loaded(), "range", "", std::nullopt, plugins()));
  step(removing(design.loaded(), first));
  step(copying(design.loaded(), "range_2", {0.1, 0, 0}));
  step(removing(design.loaded(), "range_2"));
  EXPECT_EQ(last(design).name, "range_3");
  for (std::size_t i = texts.size() - 1; i-- > 0;) {
    EXPECT_TRUE(design.undo(plugins()));
    EXPECT_EQ(design.text(), texts[i]);
  }
  for (std::size_t i = 1; i < texts.size(); ++i) {
    EXPECT_TRUE(design.redo(plugins()));
    EXPECT_EQ(design.text(), texts[i]);
  }
}

TEST(MoreDevices, SayWhyThereAreNone) {
  Design design = design_of("01-acoustic");
  const auto why = [](const Ways& ways) {
    const auto* text = std::get_if<std::string>(&ways);
    return text ? *text : "";
  };
  EXPECT_NE(why(removing(design.loaded(), "nobody")).find("no device 'nobody'"),
            std::string::npos);
  EXPECT_NE(why(adding(design.loaded(), "camera", "Nikon", {}, plugins())), "");
  EXPECT_NE(why(adding(design.loaded(), "sextant", "", {}, plugins())), "");
  for (const char* name : {"s1", "s2", "s3"})
    take(design, removing(design.loaded(), name));
  EXPECT_NE(why(removing(design.loaded(), "s4")).find("only device"),
            std::string::npos);
}

/// Neither what is kept nor what is read again at each change grows with them; what can
/// be undone stays.
TEST(MoreDevices, LeaveNothingBehind) {
  Design design = design_of("01-acoustic");
  const std::string text = design.text();
  for (int i = 0; i < 400; ++i) {
    take(design, copying(design.loaded(), "s1", {0.01, 0, 0}));
    take(design, removing(design.loaded(), "s1_2"));
    ASSERT_LE(design.history().settled().size(), Design::kMostSettled + 1);
  }
  EXPECT_EQ(design.text(), text);
  EXPECT_EQ(design.history().undoable(), History::kMostSteps);
  design.undo(plugins());
  EXPECT_EQ(last(design).name, "s1_2");
}

/// Take all changes, which must do, as one step.
void take_all(Design& design, const Together& together) {
  const auto* all = std::get_if<std::vector<Override>>(&together);
  ASSERT_TRUE(all) << std::get<std::string>(together);
  const std::size_t steps = design.history().undoable();
  change(design, *all);
  EXPECT_EQ(design.history().undoable(), steps + 1) << "one step";
}

TEST(MoreDevices, StandInARow) {
  Design design = design_of("05-optitrack-lab");
  const Pose first = design.loaded().system.devices[0].X_WS();
  const Eigen::Vector3d by(0.3, -0.4, 0.1);
  take_all(design, in_a_row(design.loaded(), "c104321", 4, by));
  const auto& devices = design.loaded().system.devices;
  ASSERT_EQ(devices.size(), 12u);
  for (int k = 1; k <= 4; ++k) {
    const PlacedDevice& copy = devices[static_cast<std::size_t>(7 + k)];
    EXPECT_EQ(copy.name, "c104321_" + std::to_string(k + 1));
    EXPECT_LT((copy.X_WS().p - first.p - k * by).norm(), 1e-12);
    EXPECT_LT((copy.X_WS().R - first.R).norm(), 1e-9);
  }
  EXPECT_TRUE(design.undo(plugins()));
  EXPECT_EQ(design.loaded().system.devices.size(), 8u);
}

/// Five copies make a regular hexagon about the axis, of cameras that all look at it
/// from the same height, with the same angle to it.
TEST(MoreDevices, StandInACircle) {
  Design design = design_of("05-optitrack-lab");
  const Eigen::Vector3d centre(-0.5, 0.2, 1);
  const Pose first = design.loaded().system.devices[1].X_WS();
  take_all(design, in_a_circle(design.loaded(), "c104325", 5, centre));
  const auto& devices = design.loaded().system.devices;
  ASSERT_EQ(devices.size(), 13u);
  std::vector<Pose> poses{first};
  for (std::size_t i = 8; i < 13; ++i) poses.push_back(devices[i].X_WS());
  const double radius = (first.p - centre).head<2>().norm();
  for (std::size_t i = 0; i < 6; ++i) {
    const Pose &a = poses[i], &b = poses[(i + 1) % 6];
    EXPECT_NEAR(a.p.z(), first.p.z(), 1e-12);
    EXPECT_NEAR((a.p - b.p).norm(), radius, 1e-9) << "a hexagon's side is its radius";
    const Eigen::Vector3d inward = centre - a.p, inward_first = centre - first.p;
    EXPECT_NEAR(a.R.col(2).dot(inward), first.R.col(2).dot(inward_first), 1e-9);
    EXPECT_NEAR(a.R.col(0).dot(inward), first.R.col(0).dot(inward_first), 1e-9);
  }
}

TEST(MoreDevices, OfArraysAreRefusedWithASentence) {
  const Design design = design_of("05-optitrack-lab");
  const Eigen::Vector3d by(1, 0, 0);
  for (const int copies : {-1, 0, kMostCopies + 1})
    EXPECT_TRUE(std::holds_alternative<std::string>(
        in_a_row(design.loaded(), "c104321", copies, by)));
  EXPECT_TRUE(std::holds_alternative<std::string>(
      in_a_circle(design.loaded(), "nobody", 3, by)));
}

}  // namespace
}  // namespace delos::session
