// What check, field and optimize say of devices that see nothing, of values of the
// wrong unit and of bodies that hold everything.
#include <gtest/gtest.h>

#include <algorithm>

#include "program.h"

namespace delos::test {
namespace {

/// Four cameras in the upper corners of a room of 5 m that look at its middle, 75
/// samples: all four see all of them.
const char* const kRoom = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {volume: {min: [1.5, 1.5, 0.5], max: [3.5, 3.5, 1.5], step: 0.5}}
devices:
  - {name: a, type: pinhole_camera, rate: 100 Hz, at: [0, 0, 2.5], aim: [2.5, 2.5, 1], params: {focal: 6 mm, pitch: 5 um, resolution: [1280, 1024]}}
  - {name: b, type: pinhole_camera, rate: 100 Hz, at: [5, 0, 2.5], aim: [2.5, 2.5, 1], params: &c {focal: 6 mm, pitch: 5 um, resolution: [1280, 1024]}}
  - {name: c, type: pinhole_camera, rate: 100 Hz, at: [5, 5, 2.5], aim: [2.5, 2.5, 1], params: *c}
  - {name: d, type: pinhole_camera, rate: 100 Hz, at: [0, 5, 2.5], aim: [2.5, 2.5, 1], params: *c}
)";

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos;
       at += by.size())
    text.replace(at, old.size(), by);
  return text;
}

/// What check says of a scene, which is in order all the same.
std::string said_of(const std::string& text, const Folder& folder = Folder()) {
  folder.write("room.yaml", text);
  const Finished done = run({"check", "room.yaml"}, folder.path());
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.out.rfind("room.yaml: in order; ", 0), 0u) << done.out;
  return done.err;
}

#define EXPECT_SAYS(text, part) \
  EXPECT_NE((text).find(part), std::string::npos) << "'" << (part) << "' in:\n" << text

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(Doubts, AreSilentWhereAllIsWell) {
  EXPECT_EQ(said_of(kRoom), "");
  std::vector<std::string> words = {"check"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(DELOS_SCENES))
    if (entry.path().extension() == ".yaml") words.push_back(entry.path().string());
  ASSERT_GE(words.size(), 16u);
  const Finished done = run(words);
  EXPECT_EQ(done.code, 0);
  EXPECT_EQ(done.err, "");
}

// ---- the six cases of users ----

TEST(Doubts, TellDegreesThatAreReadAsRadians) {
  const std::string text = said_of(replaced(kRoom, "[0, 0, 2.5], aim: [2.5, 2.5, 1]",
                                            "[0, 0, 2.5], rpy: [0, 120, 45]"));
  EXPECT_SAYS(text,
              "room.yaml:5:77: warning: devices.a.rpy.pitch: is in radians, and "
              "more than a full turn; do you mean '120 deg'?");
  // Looking 30° down along the diagonal, in degrees, it sees what the aim sees.
  EXPECT_SAYS(text,
              "room.yaml:5:5: warning: devices.a: sees none of 75 samples looked at: "
              "they are outside of its view, or behind it; do you mean 'rpy: [0 deg, "
              "120 deg, 45 deg]'? Then ");
  EXPECT_EQ(text.find("devices.b"), std::string::npos) << text;
}

TEST(Doubts, TellADeviceInsideASolid) {
  const std::string text = said_of(
      std::string(kRoom) +
      "occluders: [{name: pillar, box: {min: [-0.2, -0.2, 0], max: [0.2, 0.2, 3]}}]\n");
  EXPECT_SAYS(text,
              "devices.a: sees none of 75 samples looked at: it stands inside of "
              "occluders.pillar, which hides them");
  EXPECT_EQ(lines(text), 1u) << text;
}

TEST(Doubts, TellASceneInMillimetres) {
  std::string text = kRoom;
  text = replaced(text, "[1.5, 1.5, 0.5]", "[1500, 1500, 500]");
  text = replaced(text, "[3.5, 3.5, 1.5], step: 0.5", "[3500, 3500, 1500], step: 500");
  text = replaced(text, "[2.5, 2.5, 1]", "[2500, 2500, 1000]");
  text = replaced(text, "2.5]", "2500]");
  text = replaced(text, "at: [5, ", "at: [5000, ");
  text = replaced(text, "0, 5, 2500", "0, 5000, 2500");
  text = replaced(text, "5000, 5, 2500", "5000, 5000, 2500");
  const std::string said = said_of(text);
  for (const char* device : {"a", "b", "c", "d"})
    EXPECT_SAYS(said, std::string("devices.") + device +
                          ": sees none of 75 samples looked at: they are too far, ");
  // The camera's reach along its axis, 100 m; towards the side of the image it is
  // longer by 1/cos, at most √(1 + 0.533² + 0.427²) = 1.21.
  EXPECT_SAYS(said, " away or more, and it sees up to 1");
  EXPECT_SAYS(said, " m; do you mean millimetres? Then write '1500 mm', or 1.5");
}

TEST(Doubts, TellDevicesInMillimetres) {
  std::string text = kRoom;
  text = replaced(text, "aim: [2.5, 2.5, 1]", "aim: [2500, 2500, 1000]");
  text = replaced(text, "2.5]", "2500]");
  text = replaced(text, "at: [5, ", "at: [5000, ");
  const std::string said = said_of(text);
  EXPECT_SAYS(said,
              "devices.a: is 2.5 km from the samples, which are 2 m wide; do you "
              "mean millimetres?");
  EXPECT_SAYS(said, "devices.a: sees none of 75 samples looked at: ");
}

TEST(Doubts, TellAFocalLengthInMetres) {
  const std::string text = said_of(
      replaced(kRoom, "2.5, 1], params: {focal: 6 mm", "2.5, 1], params: {focal: 6"));
  // Between 2 atan(1280 · 5 µm / 2 / 6 m) = 0.0611° from side to side and
  // 2 atan(hypot(1280, 1024) · 5 µm / 2 / 6 m) = 0.0783° from corner to corner.
  EXPECT_SAYS(text, "devices.a: its field of view is 0.0");
  EXPECT_SAYS(text, " deg wide; do you mean 'focal: 6 mm'?");
  EXPECT_EQ(lines(text), 1u) << text;
}

TEST(Doubts, TellSamplesInMillimetres) {
  const Folder folder;
  std::string csv = "x,y,z\n";
  for (const char* x : {"1500", "2500", "3500"})
    for (const char* y : {"1500", "2500", "3500"})
      csv += std::string(x) + "," + y + ",1000\n";
  folder.write("walk.csv", csv);
  std::string text = kRoom;
  const std::size_t at = text.find("sample:");
  text.replace(at, text.find('\n', at) - at, "sample: {file: walk.csv}");
  const std::string said = said_of(text, folder);
  EXPECT_SAYS(said,
              "room.yaml:3:9: warning: sample: the samples are 2 km wide and the "
              "devices within 5 m; do you mean millimetres?");
  EXPECT_SAYS(said, "devices.c: sees none of 9 samples looked at: ");
}

// ---- others of their kind ----

TEST(Doubts, TellADeviceThatIsTooNear) {
  const std::string text = said_of(
      replaced(kRoom, "2.5, 1], params: {focal", "2.5, 1], params: {near: 50, focal"));
  EXPECT_SAYS(text,
              "devices.a: sees none of 75 samples looked at: they are too near, ");
  EXPECT_SAYS(text, " m on; do you mean 'near: 50 mm'? Then 75 are in its view");
}

/// A board 2 cm before a lens that looks along the diagonal.
TEST(Doubts, TellWhatStandsRightBeforeADevice) {
  const std::string text = said_of(
      std::string(kRoom) +
      "occluders: [{box: {min: [0.02, -1, 0], max: [0.03, 1, 3]}, name: board}]\n");
  EXPECT_SAYS(text,
              "devices.a: sees none of 75 samples looked at: occluders.board is "
              "right before it and hides 75; ");
  EXPECT_EQ(text.find("devices.b"), std::string::npos) << text;
}

/// A wall in the middle of the way is no mistake of the device's place.
TEST(Doubts, TellADeviceBehindAWall) {
  const std::string text = said_of(
      std::string(kRoom) + "occluders: [{box: {min: [1, -1, 0], max: [1.1, 6, 3]}}]\n");
  EXPECT_SAYS(text,
              "devices.a: sees none of 75 samples looked at: they are hidden by "
              "what stands in between");
}

TEST(Doubts, TellADeviceThatLooksTheOtherWay) {
  const std::string text = said_of(replaced(kRoom, "[0, 0, 2.5], aim: [2.5, 2.5, 1]",
                                            "[0, 0, 2.5], aim: [-2.5, -2.5, 1]"));
  EXPECT_SAYS(text,
              "devices.a: sees none of 75 samples looked at: they are outside of "
              "its view, or behind it\n");
}

// ---- where they are told ----

TEST(Doubts, AreTold) {
  const Folder folder;
  folder.write("room.yaml",
               replaced(kRoom, "[0, 0, 2.5], aim: [2.5, 2.5, 1]",
                        "[0, 0, 2.5], aim: [-2.5, -2.5, 1]") +
                   "variables: [{path: devices.b.at.z, lower: 2, upper: 3}]\n");
  const std::string told = "room.yaml:5:5: warning: devices.a: sees none of 75 ";
  const Finished check = run({"check", "room.yaml", "--json"}, folder.path());
  EXPECT_EQ(check.json()[0]["in_order"], true);
  ASSERT_EQ(check.json()[0]["diagnostics"].size(), 1u);
  const Json first = check.json()[0]["diagnostics"][0];
  EXPECT_EQ(first["severity"], "warning");
  EXPECT_EQ(first["line"], 5);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"field", "room.yaml"},
        {"optimize", "room.yaml", "--evaluations", "3", "--starts", "1"}}) {
    const Finished text = run(words, folder.path());
    EXPECT_SAYS(text.err, told);
    std::vector<std::string> with_json = words;
    with_json.push_back("--json");
    const Finished json = run(with_json, folder.path());
    ASSERT_EQ(json.json()["warnings"].size(), 1u) << words[0];
    EXPECT_EQ(json.json()["warnings"][0], first);
  }
}

// ---- rooms ----

/// A box of 5.4 × 5.4 × 3 m as a mesh, faces inward or outward.
std::string shell(bool inward) {
  std::string text = "OFF\n8 6 0\n";
  for (const char* z : {"0", "3"})
    for (const char* y : {"-0.2", "5.2"})
      for (const char* x : {"-0.2", "5.2"})
        text += std::string(x) + " " + y + " " + z + "\n";
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    text += "4";
    for (int i = 0; i < 4; ++i) text += " " + std::to_string(f[inward ? 3 - i : i]);
    text += "\n";
  }
  return text;
}

TEST(Rooms, ThatLookInwardAreFree) {
  const Folder folder;
  folder.write("shell.off", shell(true));
  folder.write("empty.yaml", kRoom);
  const std::string with = std::string(kRoom) + "occluders: [{mesh: shell.off}]\n";
  EXPECT_SAYS(
      said_of(with, folder),
      "occluders.0: faces inward and holds all devices and samples: it is taken "
      "for a room, whose inside is free; say so with 'room: true'");
  const Json empty = run({"field", "empty.yaml", "--json"}, folder.path()).json();
  const Json room = run({"field", "room.yaml", "--json"}, folder.path()).json();
  EXPECT_EQ(room["observable"], 75);
  EXPECT_EQ(room["mean"], empty["mean"]);
}

TEST(Rooms, AreSaidAndHideWithTheirWalls) {
  const Folder folder;
  folder.write("shell.off", shell(true));
  for (const char* body :
       {"mesh: shell.off", "box: {min: [-0.2, -0.2, 0], max: [5.2, 5.2, 3]}"}) {
    const std::string with =
        std::string(kRoom) + "occluders: [{" + body + ", room: true}]\n";
    EXPECT_EQ(said_of(with, folder), "") << body;
    const Json room = run({"field", "room.yaml", "--json"}, folder.path()).json();
    EXPECT_EQ(room["observable"], 75) << body;
    EXPECT_FALSE(room.contains("inside")) << body;
    // A camera outside of it sees the outside of a wall.
    const std::string outside =
        said_of(replaced(with, "at: [0, 0,", "at: [-1, 0,"), folder);
    EXPECT_SAYS(outside,
                "devices.a: sees none of 75 samples looked at: they are hidden "
                "by what stands in between");
  }
}

TEST(Rooms, AreAskedForWhereASolidHoldsEverything) {
  const Folder folder;
  const std::string with =
      std::string(kRoom) +
      "occluders: [{name: hall, box: {min: [-0.2, -0.2, 0], max: [5.2, 5.2, 3]}}]\n";
  EXPECT_SAYS(
      said_of(with),
      "occluders.hall: is a solid that holds all samples and all devices; if it "
      "is a room, give it 'room: true', so that its inside is free; else move it");
  // One around the samples alone.
  EXPECT_SAYS(said_of(std::string(kRoom) +
                      "occluders: [{box: {min: [1, 1, 0], max: [4, 4, 2]}}]\n"),
              "occluders.0: is a solid that holds all samples; ");
}

/// A mesh that looks inward but holds only a part of the samples stays a solid.
TEST(Rooms, AreNotWhatHoldsAPart) {
  const Folder folder;
  folder.write("shell.off", shell(true));
  said_of(std::string(kRoom) + "occluders: [{mesh: shell.off, at: [0, 0, -2]}]\n",
          folder);
  const Json json = run({"field", "room.yaml", "--json"}, folder.path()).json();
  EXPECT_EQ(json["inside"], 50);  // two of three layers, up to 1 m
}

}  // namespace
}  // namespace delos::test
