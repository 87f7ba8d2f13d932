// Occluders, surfaces, regions, adaptive and mesh samples: what becomes of them.
#include "scene/room.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "delos/device/faults.h"
#include "delos/sampling/samples.h"
#include "delos/scene/number.h"

namespace delos::test {
namespace {

using std::numbers::pi;

AdaptiveSampling adaptive_of(const Scene& scene) {
  return std::get<AdaptiveSampling>(scene.samples.at(0).shape);
}

void expect_near(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  EXPECT_LT((a - b).norm(), 1e-14) << a.transpose() << " is not " << b.transpose();
}

TEST(Room, ReadsAdaptiveSamplesInSi) {
  const Scene s = accepted(kRoom);
  const AdaptiveSampling a = adaptive_of(s);
  EXPECT_EQ(a.min, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(a.max, Eigen::Vector3d(4, 3, 2));
  EXPECT_EQ(a.tolerance, 0.05);
  EXPECT_EQ(a.depth, 7);
  EXPECT_EQ(a.evaluations, 200000);
  EXPECT_EQ(a.seconds, 30);
  EXPECT_EQ(a.near_value, 0.001);
  ASSERT_TRUE(a.within);
  EXPECT_EQ(a.within->min(), Eigen::Vector3d(1, 1, 0));
  EXPECT_EQ(a.within->max(), Eigen::Vector3d(2, 2, 1));
  EXPECT_EQ(sample_count(s.samples[0]), 0);
  EXPECT_THROW(static_cast<void>(make_samples(s.samples)), std::invalid_argument);
  EXPECT_EQ(s.orientations.combine, OrientationRule::information);
}

TEST(Room, FillsInWhatAdaptiveSamplesDontSay) {
  const AdaptiveSampling a =
      adaptive_of(accepted(good_with("step: 0.04", "adaptive: {}")));
  EXPECT_EQ(a.tolerance, 0.02);
  EXPECT_EQ(a.depth, 6);
  EXPECT_FALSE(a.evaluations || a.seconds || a.near_value || a.within);
}

TEST(Room, TakesNearInTheMetricsUnit) {
  // The metric stands behind the samples; turns have another unit than positions.
  std::string text = room_with("near: 1 mm", "near: 180 deg");
  text = with(text, "q: [0.4, 0.4, 0.1]", "q: [1, 1, 1, 1, 1, 1], state: pose");
  text += "metric: sigma_orientation\n";
  EXPECT_DOUBLE_EQ(*adaptive_of(accepted(text)).near_value, pi);
}

TEST(Room, ReadsOccluders) {
  const Scene s = accepted(kRoom);
  ASSERT_EQ(s.occluders.size(), 4u);
  EXPECT_EQ(s.occluders[0].name, "table");
  const auto& box = std::get<BoxShape>(s.occluders[0].body);
  EXPECT_EQ(box.min, Eigen::Vector3d(0, 0, 0.7));
  EXPECT_EQ(box.max, Eigen::Vector3d(2, 1, 0.74));
  EXPECT_EQ(s.occluders[0].mount, Mount::world);
  EXPECT_EQ(s.occluders[1].name, "");
  EXPECT_EQ(s.occluders[1].body, Body(CylinderShape{0.2, 2.5, 8}));
  EXPECT_EQ(pose_of(s.occluders[1].placement).p, Eigen::Vector3d(1, 1, 0));
  EXPECT_DOUBLE_EQ(pose_of(s.occluders[1].placement).R(1, 0), 0.5);
  EXPECT_EQ(s.occluders[2].body, Body(SphereShape{0.12}));
  EXPECT_EQ(s.occluders[2].mount, Mount::target);
  EXPECT_EQ(s.occluders[3].body, Body(PrismShape{{{0, 0}, {2, 0}, {2, 1}}, 1}));
  EXPECT_EQ(s.skin, 0.002);
  EXPECT_EQ(accepted(kGood).skin, 0.001);
}

TEST(Room, ReadsRegions) {
  const Scene s = accepted(kRoom);
  ASSERT_EQ(s.regions.size(), 2u);
  EXPECT_EQ(s.regions[0].name, "stage");
  EXPECT_EQ(std::get<BoxShape>(s.regions[0].body).max, Eigen::Vector3d(3, 2, 2));
  EXPECT_EQ(s.regions[1].name, "pit");
  EXPECT_EQ(std::get<PrismShape>(s.regions[1].body).height, 0.5);
  EXPECT_EQ(s.regions[1].placement.at.z(), -0.5);
}

TEST(Room, MakesBodiesOfTriangles) {
  const Scene s = accepted(kRoom);
  // Corners by hand: a box has 8 and a prism over a triangle 6; 12 and 8 triangles.
  EXPECT_EQ(body_mesh(s.occluders[0].body).vertices.size(), 8u);
  EXPECT_EQ(body_mesh(s.occluders[0].body).triangles.size(), 12u);
  EXPECT_EQ(body_mesh(s.occluders[3].body).vertices.size(), 6u);
  EXPECT_EQ(body_mesh(s.occluders[3].body).triangles.size(), 8u);
  EXPECT_EQ(body_mesh(s.occluders[1].body).vertices.size(), 16u);
  for (const Eigen::Vector3d& p : body_mesh(s.occluders[2].body).vertices)
    EXPECT_NEAR(p.norm(), 0.12, 1e-15);
}

TEST(Room, MountsDevicesOnSurfaces) {
  const Scene s = accepted(kRoom);
  EXPECT_EQ(s.devices[0].mounting, (Mounting{"ceiling", {0.5, 0.25}}));
  // Half of u = (0, 3, 0) and a quarter of v = (4, 0, 0); u × v points down.
  const Pose ceiling = device_pose(s, s.devices[0]);
  EXPECT_EQ(ceiling.p, Eigen::Vector3d(1, 1.5, 3));
  EXPECT_EQ(ceiling.R.col(2), Eigen::Vector3d(0, 0, -1));
  // 0.875 of 3 m + 1 m is half of the second piece.
  const Pose rail = device_pose(s, s.devices[1]);
  EXPECT_EQ(rail.p, Eigen::Vector3d(3, 0.5, 2));
  expect_near(rail.R.col(2), -Eigen::Vector3d(3, 0.5, 2).normalized());
}

TEST(Room, LetsMountedDevicesFaceElsewhere) {
  const auto pose = [](const std::string& text) {
    const Scene s = accepted(text);
    return device_pose(s, s.devices[0]);
  };
  const Pose aimed = pose(room_with("[0.5, 25 %],", "[0.5, 25 %], aim: [1, 1.5, 9],"));
  EXPECT_EQ(aimed.R.col(2), Eigen::Vector3d(0, 0, 1));
  const Pose turned = pose(room_with("[0.5, 25 %],", "[0.5, 25 %], rpy: [0, 0, 0],"));
  EXPECT_EQ(turned.R, Eigen::Matrix3d::Identity());
  EXPECT_EQ(turned.p, Eigen::Vector3d(1, 1.5, 3));
  // A rail faces nowhere.
  const Pose rail = pose(room_with("on: ceiling, coordinates: [0.5, 25 %]",
                                   "on: rail1, coordinates: [0]"));
  EXPECT_EQ(rail.R, Eigen::Matrix3d::Identity());
  EXPECT_EQ(rail.p, Eigen::Vector3d(0, 0, 2));
}

// A rail's one coordinate is a number, in a scene and as a variable; beside a patch's
// two.
TEST(Room, TakesARailsCoordinateAsANumber) {
  for (const char* written : {"0.875", "[0.875]"}) {
    Scene s = accepted(
        room_with("coordinates: 0.875", std::string("coordinates: ") + written));
    const auto one = expand_numbers(s, "devices.c2.coordinates", plugins());
    EXPECT_EQ(std::get<0>(one), (std::vector<std::string>{"devices.c2.coordinates.0"}));
    for (const char* path : {"devices.c2.coordinates", "devices.c2.coordinates.0"})
      EXPECT_EQ(*std::get<0>(find_number(s, path, plugins())).value, 0.875);
    const auto all = expand_numbers(s, "devices.c*.coordinates", plugins());
    EXPECT_EQ(std::get<0>(all), (std::vector<std::string>{"devices.c1.coordinates.0",
                                                          "devices.c1.coordinates.1",
                                                          "devices.c2.coordinates.0"}));
  }
}

TEST(Room, EndsOfRailsAreOnThem) {
  const SurfaceEntry rail{"r",
                          RailSurface{{{0, 0, 0}, {0, 0, 0}, {0, 3, 0}, {4, 3, 0}}}};
  EXPECT_EQ(mount_point(rail, {0})->p, Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(mount_point(rail, {1})->p, Eigen::Vector3d(4, 3, 0));
  expect_near(mount_point(rail, {4.0 / 7})->p, {1, 3, 0});
}

const std::string kHull =
    "  hull: {mesh: t.off, scale: 0.5, from: {origin: [-1, 0, 0], u: [0, 0.5, 0], v: "
    "[0, 0, 0.5]}}\nregions:";

TEST(Room, MountsDevicesOnMeshes) {
  const RoomFolder folder;
  folder.write("t.off", kTetrahedron);
  const auto pose = [&](const std::string& coordinates, const std::string& hull) {
    std::string text = room_with("regions:", hull);
    text = with(text, "on: ceiling, coordinates: [0.5, 25 %]",
                "on: hull, coordinates: " + coordinates);
    const Scene s = accepted(folder.load(text));
    return device_pose(s, s.devices.at(0));
  };
  // From x = -1 along u × v = +x: the tetrahedron, half as large, begins at x = 0.
  const Pose X = pose("[0.2, 0.4]", kHull);
  expect_near(X.p, {0, 0.1, 0.2});
  expect_near(X.R.col(2), {-1, 0, 0});
  // On the diagonal between two triangles, and at a corner, something is hit too.
  expect_near(pose("[0.5, 0.5]", kHull).p, {0, 0.25, 0.25});
  expect_near(pose("[0, 0]", kHull).p, {0, 0, 0});
  // From the other side, the slanted face x + y + z = 1/2.
  const std::string back =
      "  hull: {mesh: t.off, scale: 0.5, from: {origin: [1, 0, 0], v: [0, 0.5, 0], u: "
      "[0, 0, 0.5]}}\nregions:";
  const Pose slanted = pose("[0.2, 0.4]", back);
  expect_near(slanted.p, {0.2, 0.2, 0.1});
  expect_near(slanted.R.col(2), Eigen::Vector3d(1, 1, 1).normalized());
  // From inside, the normal faces inside.
  const std::string inside =
      "  hull: {mesh: t.off, from: {origin: [0.1, 0.1, 0.1], u: [1, 0, 0], v: "
      "[0, 1, 0]}}\nregions:";
  const Pose within = pose("[0, 0]", inside);
  expect_near(within.p, {0.1, 0.1, 0.8});
  expect_near(within.R.col(2), -Eigen::Vector3d(1, 1, 1).normalized());
}

TEST(Room, SaysWhereAMovedDeviceLeavesItsMesh) {
  const RoomFolder folder;
  folder.write("t.off", kTetrahedron);
  std::string text = room_with("regions:", kHull);
  text = with(text, "on: ceiling, coordinates: [0.5, 25 %]",
              "on: hull, coordinates: [0, 0]");
  Scene s = accepted(folder.load(text));
  s.devices.at(0).mounting->coordinates = {1, 1};
  try {
    static_cast<void>(device_pose(s, s.devices[0]));
    FAIL();
  } catch (const Unbuildable& e) {
    EXPECT_STREQ(e.what(), "c1: the ray from its coordinates on 'hull' hits nothing");
  }
}

TEST(Room, SamplesTheVerticesOfAMesh) {
  const RoomFolder folder;
  folder.write("t.off", kTetrahedron);
  const std::string volume =
      "volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}";
  const Scene one = accepted(folder.load(good_with(volume, "mesh: t.off")));
  const auto& mesh = std::get<MeshSampling>(one.samples.at(0).shape);
  EXPECT_EQ(mesh.surface.file, "t.off");
  EXPECT_EQ(mesh.surface.scale, 1);
  const Scene small =
      accepted(folder.load(good_with(volume, "mesh: {file: t.off, scale: 0.001}")));
  EXPECT_EQ(sample_count(small.samples.at(0)), 4);
  const Samples samples = make_samples(small.samples);
  EXPECT_EQ(samples.points,
            (std::vector<Eigen::Vector3d>{
                {0, 0, 0}, {0.001, 0, 0}, {0, 0.001, 0}, {0, 0, 0.001}}));
  ASSERT_TRUE(std::holds_alternative<SurfaceShape>(samples.parts.at(0).shape));
  EXPECT_EQ(std::get<SurfaceShape>(samples.parts[0].shape).triangles,
            mesh.surface.mesh->triangles);
}

TEST(Room, ReadsAMeshOnce) {
  const RoomFolder folder;
  folder.write("t.off", kTetrahedron);
  const Scene s =
      accepted(folder.load(room_with("skin",
                                     "  - {mesh: t.off, at: [1, 2, 3]}\n"
                                     "  - {mesh: ./t.off, scale: 0.5}\nskin")));
  ASSERT_EQ(s.occluders.size(), 6u);
  const auto& a = std::get<MeshShape>(s.occluders[4].body);
  const auto& b = std::get<MeshShape>(s.occluders[5].body);
  ASSERT_TRUE(a.mesh);
  EXPECT_EQ(a.mesh, b.mesh);
  EXPECT_EQ(body_mesh(a).vertices[1], Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(body_mesh(b).vertices[1], Eigen::Vector3d(0.5, 0, 0));
}

TEST(Room, TellsHowMuchOfAMeshIsRead) {
  const RoomFolder folder;
  folder.write("t.off", kTetrahedron);
  std::vector<double> parts;
  const Loaded loaded = folder.load(
      room_with("box: {min: [0, 0, 0.7], max: [2, 1, 0.74]}", "mesh: t.off"),
      [&](const std::filesystem::path& file, double part) {
        EXPECT_EQ(file.filename(), "t.off");
        parts.push_back(part);
      });
  ASSERT_TRUE(loaded.scene);
  ASSERT_FALSE(parts.empty());
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_EQ(parts.back(), 1);
}

TEST(Room, IsReachedByOverrides) {
  const auto changed = [](const std::string& path, const std::string& value) {
    return accepted(kRoom, {{path, value}});
  };
  EXPECT_EQ(changed("occluders.table.at.x", "3").occluders[0].placement.at.x(), 3);
  EXPECT_EQ(changed("occluders.1.at.z", "3").occluders[1].placement.at.z(), 3);
  EXPECT_EQ(changed("occluders.1.cylinder.radius", "1 cm").occluders[1].body,
            Body(CylinderShape{0.01, 2.5, 8}));
  EXPECT_EQ(changed("occluders.table.box.max.z", "0.9").occluders[0].body,
            Body(BoxShape{{0, 0, 0.7}, {2, 1, 0.9}}));
  EXPECT_EQ(changed("occluders.3.prism.polygon.1.y", "-1").occluders[3].body,
            Body(PrismShape{{{0, 0}, {2, -1}, {2, 1}}, 1}));
  EXPECT_EQ(changed("skin", "5 mm").skin, 0.005);
  EXPECT_EQ(changed("regions.pit.at.z", "-1").regions[1].placement.at.z(), -1);
  EXPECT_EQ(
      changed("devices.c1.coordinates.1", "0.75").devices[0].mounting->coordinates,
      (std::vector<double>{0.5, 0.75}));
  EXPECT_EQ(std::get<PatchSurface>(
                changed("surfaces.ceiling.patch.origin.z", "4").surfaces[0].shape)
                .origin.z(),
            4);
  EXPECT_EQ(adaptive_of(changed("sample.volume.adaptive.tolerance", "1 %")).tolerance,
            0.01);
}

TEST(Room, SurvivesWritingAndReading) {
  const RoomFolder folder;
  folder.write("t.off", kTetrahedron);
  std::string text = room_with("regions:", kHull);
  text = with(text, "pit: {prism",
              "tent: {mesh: t.off, scale: 2, at: [0, 0, 1]}\n  pit: {prism");
  text = with(text, "skin", "  - {mesh: t.off, mount: target}\nskin");
  const Scene s = accepted(folder.load(text));
  const std::string written = write_scene(s);
  EXPECT_EQ(accepted(folder.load(written)), s) << written;
  EXPECT_EQ(write_scene(accepted(folder.load(written))), written);
  const Scene mesh = accepted(folder.load(
      good_with("volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}",
                "mesh: {file: t.off, scale: 0.25}")));
  EXPECT_EQ(accepted(folder.load(write_scene(mesh))), mesh) << write_scene(mesh);
}

TEST(Room, IsToldFromOthers) {
  const Scene scene = accepted(kRoom);
  const auto differs = [&](auto change) {
    Scene other = scene;
    change(other);
    EXPECT_FALSE(other == scene);
    EXPECT_NE(write_scene(other), write_scene(scene));
  };
  const auto adapt = [&](auto change) {
    differs([&](Scene& s) { change(std::get<AdaptiveSampling>(s.samples[0].shape)); });
  };
  adapt([](auto& a) { a.min.x() = -1; });
  adapt([](auto& a) { a.max.x() = 9; });
  adapt([](auto& a) { a.tolerance = 0.5; });
  adapt([](auto& a) { a.depth = 1; });
  adapt([](auto& a) { a.evaluations.reset(); });
  adapt([](auto& a) { a.seconds = 1; });
  adapt([](auto& a) { a.near_value.reset(); });
  adapt([](auto& a) { a.within->max().x() = 1.5; });
  adapt([](auto& a) { a.within.reset(); });
  differs([](Scene& s) { s.skin = 0; });
  differs([](Scene& s) { s.occluders[0].name = ""; });
  differs([](Scene& s) { s.occluders[0].mount = Mount::target; });
  differs([](Scene& s) { s.occluders[0].placement.at.x() = 1; });
  differs([](Scene& s) { std::get<CylinderShape>(s.occluders[1].body).sides = 9; });
  differs([](Scene& s) { std::get<SphereShape>(s.occluders[2].body).radius = 9; });
  differs([](Scene& s) { std::get<PrismShape>(s.occluders[3].body).height = 9; });
  differs([](Scene& s) { s.occluders[0].body = MeshShape{"a.off", 1, nullptr}; });
  differs([](Scene& s) { s.regions.pop_back(); });
  differs(
      [](Scene& s) { std::get<RailSurface>(s.surfaces[1].shape).points.pop_back(); });
  differs([](Scene& s) { std::get<PatchSurface>(s.surfaces[0].shape).u.x() = 1; });
  differs([](Scene& s) { s.devices[0].mounting->coordinates[0] = 0; });
  differs([](Scene& s) { s.devices[0].mounting.reset(); });
  EXPECT_FALSE((MeshShape{"a.off", 1, nullptr} == MeshShape{"a.off", 2, nullptr}));
  EXPECT_FALSE((MeshShape{"a.off", 1, nullptr} == MeshShape{"b.off", 1, nullptr}));
}

}  // namespace
}  // namespace delos::test
