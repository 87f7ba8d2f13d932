// Bad rooms: bodies, meshes, surfaces and adaptive samples; and what is only warned of.
#include <gtest/gtest.h>

#include <stdexcept>

#include "scene/refusal.h"
#include "scene/room.h"

namespace delos::test {
namespace {

std::vector<Bad> bad_rooms() {
  const std::string table = "box: {min: [0, 0, 0.7], max: [2, 1, 0.74]}";
  const auto occluder = [&](const std::string& body) { return room_with(table, body); };
  const auto adaptive = [](const std::string& from, const std::string& to) {
    return room_with(from, to);
  };
  const auto e = in_scene;
  return {
      // ---- bodies ----
      {"NoBody",
       occluder("mount: world"),
       {e("22:5: error: occluders.table: there is no body; give box, cylinder, sphere, "
          "prism or mesh")}},
      {"TwoBodies",
       occluder(table + ", sphere: {radius: 1}"),
       {e("22:71: error: occluders.table.sphere: the body is given by 'box' already; "
          "keep one")}},
      {"UnknownBody",
       occluder("boxx: {}, sphere: {radius: 1}"),
       {e("22:19: error: occluders.table.boxx: unknown key; did you mean 'box'?")}},
      {"FlatBox",
       occluder("box: {min: [0, 0, 0.7], max: [2, -1 cm, 0.7]}"),
       {e("22:52: error: occluders.table.box.max.y: -1 cm isn't above min; a box "
          "extends "
          "along every axis"),
        e("22:59: error: occluders.table.box.max.z: 0.7 isn't above min; a box extends "
          "along every axis")}},
      {"BoxWithoutMax",
       occluder("box: {min: [0, 0, 0.7]}"),
       {e("22:24: error: occluders.table.box.max: missing: opposite corner [x, y, z], "
          "metres")}},
      {"NegativeRadius",
       occluder("sphere: {radius: -12 cm}"),
       {e("22:36: error: occluders.table.sphere.radius: must be above 0")}},
      {"CylinderWithoutVolume",
       occluder("cylinder: {radius: 0, height: 0, sides: 2}"),
       {e("22:38: error: occluders.table.cylinder.radius: must be above 0"),
        e("22:49: error: occluders.table.cylinder.height: must be above 0"),
        e("22:59: error: occluders.table.cylinder.sides: 2 is outside 3 to 1,000")}},
      {"CrossingPolygon",
       occluder("prism: {polygon: [[0, 0], [1, 1], [1, 0], [0, 1]], height: 1}"),
       {e("22:36: error: occluders.table.prism.polygon: edges of the polygon touch or "
          "cross each other")}},
      {"PolygonOfTwo",
       occluder("prism: {polygon: [[0, 0], [1, 1]], height: 1}"),
       {e("22:36: error: occluders.table.prism.polygon: a polygon needs at least three "
          "corners, not 2")}},
      {"PolygonInSpace",
       occluder("prism: {polygon: [[0, 0, 0], 7, [1, 1 Hz]], height: 1}"),
       {e("22:37: error: occluders.table.prism.polygon.0: expected two numbers [x, y], "
          "not 3 members"),
        e("22:48: error: occluders.table.prism.polygon.1: expected two numbers [x, y], "
          "not a single value"),
        e("22:55: error: occluders.table.prism.polygon.2.y: '1 Hz' is a frequency; "
          "expected a length such as '50 mm'")}},
      {"ScaleOfABox",
       occluder(table + ", scale: 0.001"),
       {e("22:70: error: occluders.table.scale: only a mesh has a scale; other bodies "
          "are in metres")}},
      {"UnknownMount",
       occluder(table + ", mount: tarjet"),
       {e("22:70: error: occluders.table.mount: 'tarjet' is none of world, target; did "
          "you mean 'target'?")}},
      {"OccluderTwice",
       room_with("  - {sphere:", "  - {name: table, sphere:"),
       {e("25:12: error: occluders.table.name: 'table' names the occluder on line 22 "
          "already")}},
      {"OccludersAreAList",
       kGood + "occluders: {table: {}}\n",
       {e("18:12: error: occluders: expected a list of bodies, not a mapping")}},
      {"NegativeSkin",
       room_with("2 mm", "-2 mm"),
       {e("27:7: error: skin: must not be below 0")}},
      {"RegionWithoutBody",
       room_with("stage: {box: {min: [1, 1, 0], max: [3, 2, 2]}}", "stage: {}"),
       {e("14:10: error: regions.stage: there is no body; give box, cylinder, sphere, "
          "prism or mesh")}},
      {"RegionIsNoPath",
       room_with("stage:", "a.b:"),
       {e("14:3: error: regions.a.b: 'a.b' holds '.' or '=', which separate the parts "
          "of a path; use '_'")}},

      // ---- surfaces ----
      {"NoSurface",
       room_with("{rail: [[0, 0, 2], [3, 0, 2], [3, 1, 2]]}", "{}"),
       {e("12:10: error: surfaces.rail1: there is no surface; give patch, rail or "
          "mesh")}},
      {"TwoSurfaces",
       room_with("[3, 1, 2]]}", "[3, 1, 2]], mesh: t.off}"),
       {e("12:10: error: surfaces.rail1.from: missing: patch whose points are thrown "
          "on "
          "the mesh"),
        e("12:58: error: surfaces.rail1.mesh: t.off: no such file"),
        e("12:58: error: surfaces.rail1.mesh: the surface is given by 'rail' already; "
          "keep one")}},
      {"FlatPatch",
       room_with("u: [0, 3, 0]", "u: [2, 0, 0]"),
       {e("11:20: error: surfaces.ceiling.patch: u and v don't span a surface: they "
          "are "
          "parallel, or one is zero")}},
      {"RailWithoutLength",
       room_with("[[0, 0, 2], [3, 0, 2], [3, 1, 2]]", "[[3, 1, 2], [3, 1, 2]]"),
       {e("12:17: error: surfaces.rail1.rail: has no length; give two points or "
          "more")}},
      {"FromOfARail",
       room_with("[3, 1, 2]]}", "[3, 1, 2]], scale: 2}"),
       {e("12:59: error: surfaces.rail1.scale: belongs to a mesh; leave it out")}},
      {"UnknownSurface",
       room_with("on: ceiling", "on: ceilin"),
       {e("17:43: error: devices.c1.on: there is no surface 'ceilin'; did you mean "
          "'ceiling'?")}},
      {"NoSurfaces",
       good_with("    at: [0, 0, 1]\n", "    on: ceiling\n    coordinates: [0, 0]\n"),
       {e("15:9: error: devices.s1.on: there is no surface 'ceiling'; the scene "
          "declares "
          "none")}},
      {"OnAndAt",
       room_with("on: ceiling", "at: [0, 0, 0], group: g, on: ceiling"),
       {e("17:43: error: devices.c1.at: the place is given by 'on' already; keep one"),
        e("17:61: error: devices.c1.group: surfaces are in the world; leave out "
          "'group' "
          "or 'on'"),
        e("17:61: error: devices.c1.group: there is no group 'g'; the scene declares "
          "none")}},
      {"OnWithoutCoordinates",
       room_with("on: ceiling, coordinates: [0.5, 25 %]", "on: ceiling"),
       {e("17:43: error: devices.c1.coordinates: missing: where on the surface, "
          "numbers "
          "from 0 to 1")}},
      {"CoordinatesWithoutOn",
       room_with("on: ceiling, coordinates", "coordinates"),
       {e("17:52: error: devices.c1.coordinates: belong to a surface; give 'on' too, "
          "or "
          "'at' instead")}},
      {"CoordinatesOfAPatch",
       room_with("[0.5, 25 %]", "0.5"),
       {e("17:65: error: devices.c1.coordinates: 'ceiling' has two coordinates, along "
          "u "
          "and v: expected two numbers, not 1")}},
      {"CoordinatesOfARail",
       room_with("coordinates: 0.875", "coordinates: [0.875, 0]"),
       {e("19:63: error: devices.c2.coordinates: 'rail1' is a rail: expected one "
          "number, "
          "not 2")}},
      {"CoordinatesOutside",
       room_with("[0.5, 25 %]", "[-0.5, 125 %]"),
       {e("17:66: error: devices.c1.coordinates.0: -0.5 is outside 0 to 1, the "
          "surface's "
          "ends"),
        e("17:72: error: devices.c1.coordinates.1: 125 % is outside 0 to 1, the "
          "surface's ends")}},
      {"MountedAimAtItself",
       room_with("aim: [0, 0, 0]", "aim: [3, 0.5, 2]"),
       {e("20:11: error: devices.c2.aim: is where it stands; choose a point to look "
          "at")}},

      // ---- adaptive samples ----
      {"StepAndAdaptive",
       good_with("step: 0.04", "step: 0.04, adaptive: {}"),
       {e("8:72: error: sample.volume.adaptive: the samples are given by 'step' "
          "already; "
          "keep one")}},
      {"AdaptiveValues",
       adaptive("{tolerance: 5 %, depth: 7, evaluations: 200000, seconds: 0.5 min",
                "{tolerance: 100 %, depth: 13, evaluations: 0, seconds: -1"),
       {e("7:27: error: sample.volume.adaptive.tolerance: must be above 0 and below 1, "
          "such as 2 %"),
        e("7:41: error: sample.volume.adaptive.depth: 13 is outside 1 to 12"),
        e("7:58: error: sample.volume.adaptive.evaluations: 0 is outside 1 to "
          "2,147,483,647"),
        e("7:70: error: sample.volume.adaptive.seconds: must be above 0")}},
      {"AdaptiveUnknownKey",
       adaptive("tolerance: 5 %", "tolerence: 5 %"),
       {e("7:16: error: sample.volume.adaptive.tolerence: unknown key; did you mean "
          "'tolerance'?")}},
      {"AdaptiveNearOfAnotherUnit",
       adaptive("near: 1 mm", "near: 1 deg"),
       {e("8:22: error: sample.volume.adaptive.near: '1 deg' is an angle; expected a "
          "length such as '50 mm'")}},
      {"AdaptiveNearZero",
       adaptive("near: 1 mm", "near: 0"),
       {e("8:22: error: sample.volume.adaptive.near: must be above 0")}},
      {"AdaptiveFlat",
       adaptive("max: [4, 3, 2 m]", "max: [4, -3, 0]"),
       {e("6:14: error: sample.volume.max.y: -3 is below min; exchange them"),
        e("6:18: error: sample.volume.max.z: 0 is min too; adaptive samples need a "
          "box, "
          "so give a step")}},
      {"AdaptiveWithinNothing",
       adaptive("within: {min: [1, 1, 0], max: [2, 2, 1]}",
                "within: {min: [5, 1, 0], max: [6, 2, 1]}"),
       {e("8:36: error: sample.volume.adaptive.within: is outside of the volume")}},
      {"AdaptiveWithOthers",
       good_with(
           "sample:\n  volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}",
           "sample:\n  - volume: {min: [0, 0, 0], max: [1, 1, 1], adaptive: {}}\n"
           "  - points: [[0, 0, 0]]"),
       {e("8:56: error: sample.0.volume.adaptive: must be the only set of its scene; "
          "keep this set alone, or give it a step")}},
  };
}

class RoomRefusal : public testing::TestWithParam<Bad> {};

TEST_P(RoomRefusal, IsLocatedAndExplained) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Scene, RoomRefusal, testing::ValuesIn(bad_rooms()),
                         [](const auto& i) { return i.param.name; });

TEST(RoomRefusal, OfOverridesNamesTheMembers) {
  const auto finding = [](const std::string& path) {
    return load(kRoom, {{path, "1"}}).findings.at(0);
  };
  EXPECT_EQ(finding("surfaces.ceilng.patch.u.x"),
            "--set surfaces.ceilng.patch.u.x: error: surfaces.ceilng: there is no such "
            "surface; did you mean 'ceiling'?");
  EXPECT_EQ(finding("regions.hall.at.x"),
            "--set regions.hall.at.x: error: regions.hall: there is no such region; "
            "known: stage, pit");
  EXPECT_EQ(finding("occluders.tabel.at.x"),
            "--set occluders.tabel.at.x: error: occluders.tabel: there is no such "
            "member; did you mean 'table'?");
}

// ---- mesh files ----

/// kRoom with a mesh as another occluder, on line 27.
std::string with_mesh(const std::string& keys) {
  return room_with("skin", "  - {mesh: " + keys + "}\nskin");
}

/// The geometry room words what is wrong with a file; the scene says where it is named.
TEST(RoomRefusal, OfMeshFilesIsLocated) {
  const RoomFolder folder;
  folder.write("empty.off", "");
  folder.write("nothing.off", "OFF\n0 0 0\n");
  folder.write("nan.off", with(kTetrahedron, "0 0 1", "0 0 nan"));
  folder.write("words.off", "a room with a view\n");
  folder.write("torso.step", kTetrahedron);
  folder.write("corner.off", with(kTetrahedron, "3 1 2 3", "3 1 2 9"));
  for (const char* file : {"missing.off", "empty.off", "nothing.off", "nan.off",
                           "words.off", "torso.step", "corner.off"}) {
    const Loaded loaded = folder.load(with_mesh(file));
    EXPECT_FALSE(loaded.scene) << file;
    ASSERT_EQ(loaded.findings.size(), 1u) << file;
    const std::string begin =
        std::string("scene.yaml:27:12: error: occluders.4.mesh: ") + file + ": ";
    EXPECT_EQ(loaded.findings[0].substr(0, begin.size()), begin);
    EXPECT_GT(loaded.findings[0].size(), begin.size() + 5) << loaded.findings[0];
  }
  EXPECT_EQ(folder.load(with_mesh("missing.off")).findings[0],
            "scene.yaml:27:12: error: occluders.4.mesh: missing.off: no such file");
  EXPECT_EQ(
      folder
          .load(good_with("volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}",
                          "mesh: {file: missing.off, scale: 0}"))
          .findings,
      (std::vector<std::string>{
          "scene.yaml:8:16: error: sample.mesh.file: missing.off: no such file",
          "scene.yaml:8:36: error: sample.mesh.scale: must be above 0: it is metres "
          "per "
          "unit of the file"}));
}

TEST(RoomRefusal, OfRegionsWithoutInside) {
  const RoomFolder folder;
  folder.write("open.off", kOpenTetrahedron);
  EXPECT_EQ(
      folder.load(room_with("stage: {", "tent: {mesh: open.off}\n  stage: {")).findings,
      std::vector<std::string>{
          "scene.yaml:14:16: error: regions.tent.mesh: 'open.off' is open, 3 "
          "edges have one triangle only; nothing is inside of it: close it, or use "
          "another body"});
}

TEST(RoomRefusal, OfRaysThatMiss) {
  const RoomFolder folder;
  folder.write("t.off", kTetrahedron);
  std::string text = room_with(
      "regions:",
      "  hull: {mesh: t.off, from: {origin: [-1, 0, 0], u: [0, 0, 1], v: [0, 1, 0]}}\n"
      "regions:");
  text = with(text, "on: ceiling", "on: hull");
  EXPECT_EQ(folder.load(text).findings,
            std::vector<std::string>{
                "scene.yaml:18:62: error: devices.c1.coordinates: the ray from here "
                "along u × v hits nothing of 'hull'; move the patch 'from', or turn it "
                "by exchanging u and v"});
}

TEST(RoomRefusal, OfScalesBeyondDoubles) {
  const RoomFolder folder;
  folder.write("t.off", with(kTetrahedron, "0 0 1", "0 0 1e10"));
  EXPECT_EQ(folder.load(with_mesh("t.off, scale: 1e300")).findings,
            std::vector<std::string>{
                "scene.yaml:27:12: error: occluders.4.mesh: is beyond the range of a "
                "double at this scale"});
}

// ---- warnings ----

std::vector<std::string> warned(const RoomFolder& folder, const std::string& text) {
  const Loaded loaded = folder.load(text);
  EXPECT_TRUE(loaded.scene);
  return loaded.findings;
}

TEST(RoomWarning, AsksForMillimetres) {
  const RoomFolder folder;
  folder.write("t.off", with(kTetrahedron, "0 0 1", "0 0 4200"));
  const std::vector<std::string> warning = {
      "scene.yaml:27:12: warning: occluders.4.mesh: 't.off' extends over 4200 m; if it "
      "is in millimetres, give 'scale: 0.001'"};
  EXPECT_EQ(warned(folder, with_mesh("t.off")), warning);
  EXPECT_EQ(warned(folder, with_mesh("t.off, scale: 1 ")), warning);
  EXPECT_EQ(warned(folder, with_mesh("t.off, scale: 0.001")),
            std::vector<std::string>{});
  EXPECT_EQ(
      warned(folder,
             good_with("volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}",
                       "mesh: t.off")),
      std::vector<std::string>{
          "scene.yaml:8:9: warning: sample.mesh: 't.off' extends over 4200 m; if it is "
          "in millimetres, give 'scale: 0.001'"});
}

/// Counted by hand on the tetrahedron: it has 4 triangles and 6 edges.
TEST(RoomWarning, CountsDefectsAndSaysWhatFollows) {
  const RoomFolder folder;
  const auto of = [&](const std::string& mesh) {
    folder.write("t.off", mesh);
    const auto found = warned(folder, with_mesh("t.off"));
    const std::string begin = "scene.yaml:27:12: warning: occluders.4.mesh: 't.off': ";
    if (found.size() != 1) return std::to_string(found.size()) + " findings";
    EXPECT_EQ(found[0].substr(0, begin.size()), begin);
    return found[0].substr(std::min(found[0].size(), begin.size()));
  };
  EXPECT_EQ(of(kTetrahedron), "0 findings");
  EXPECT_EQ(of(kOpenTetrahedron),
            "is open, 3 edges have one triangle only: it hides, but has no inside");
  // All faces turned round.
  EXPECT_EQ(of("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n"
               "3 1 3 2\n"),
            "faces inward: it hides all the same");
  // One face turned round: its three edges.
  EXPECT_EQ(of(with(kTetrahedron, "3 1 2 3", "3 1 3 2")),
            "3 edges have triangles that don't face the same way: it hides all the "
            "same");
  // Another one through its middle.
  EXPECT_EQ(of("OFF\n7 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0.1 0.1 -1\n0.2 0.1 -1\n"
               "0.1 0.2 0.1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 5 6\n"),
            "is open, 3 edges have one triangle only: it hides, but has no inside; 1 "
            "pair of triangles cuts through each other: it hides all the same");
  // One face a second time, from its next corner and from behind.
  EXPECT_EQ(of("OFF\n4 5 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n"
               "3 1 2 3\n3 2 1 3\n"),
            "1 triangle is there twice");
  // One triangle with a corner twice, and one with it thrice.
  EXPECT_EQ(of("OFF\n5 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n2 0 0\n3 0 2 1\n3 0 1 3\n"
               "3 0 3 2\n3 1 2 3\n3 0 0 1\n3 3 3 3\n"),
            "2 triangles without area hide nothing");
  // Two tetrahedra with one edge in common: it has four triangles.
  EXPECT_EQ(
      of("OFF\n6 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n3 0 2 1\n"
         "3 0 1 3\n3 0 3 2\n3 1 2 3\n3 0 5 4\n3 0 4 3\n3 0 3 5\n3 4 5 3\n"),
      "1 edge has more than two triangles: its inside is where a line out crosses "
      "it an odd number of times");
}

TEST(RoomWarning, IsGivenOnceAFile) {
  const RoomFolder folder;
  folder.write("t.off", kOpenTetrahedron);
  EXPECT_EQ(warned(folder, with_mesh("t.off}\n  - {mesh: t.off, scale: 2")).size(), 1u);
}

}  // namespace
}  // namespace delos::test
