// delos point: everything about one point.
#include <gtest/gtest.h>

#include <cmath>

#include "program.h"

namespace delos::test {
namespace {

Json point(const std::string& name, const std::string& at) {
  const Finished done = run({"point", scene(name), "--at", at, "--json"});
  EXPECT_EQ(done.code, 0) << done.err;
  return done.json();
}

TEST(PointCommand, GivesTheContractsMembers) {
  const Json json = point("01-acoustic", "0.1,20 cm,300 mm");
  EXPECT_EQ(json["at"], (Json{0.1, 0.2, 0.3}));
  EXPECT_EQ(json["state"], (Json{"x", "y", "z", "vx", "vy", "vz"}));
  EXPECT_EQ(json["observable"], true);
  EXPECT_EQ(json["unobservable_directions"], Json::array());
  for (const char* name : {"sigma_x", "sigma_vz", "sigma_position", "eigmax", "eiglen",
                           "mle", "trace", "det", "coverage", "latency"}) {
    EXPECT_TRUE(json["metrics"][name]["value"].is_number()) << name;
    EXPECT_TRUE(json["metrics"][name]["unit"].is_string()) << name;
  }
  EXPECT_EQ(json["metrics"]["coverage"]["value"], 4);
  ASSERT_EQ(json["devices"].size(), 4u);
  for (const Json& device : json["devices"]) {
    EXPECT_EQ(device["type"], "acoustic_range");
    EXPECT_EQ(device["visible"], true);
    EXPECT_GT(device["share"], 0);  // a device taken away is information lost
  }
  EXPECT_EQ(json["devices"][2]["name"], "s3");
}

/// Up to the rounding of a product that is symmetric in exact numbers.
void expect_equal(double a, double b) { EXPECT_NEAR(a, b, 1e-14 * std::abs(a)); }

TEST(PointCommand, GivesSymmetricCovariancesThatFitTheMetrics) {
  const Json json = point("01-acoustic", "0.1,0.2,0.3");
  const Json &prior = json["P_prior"], &posterior = json["P_posterior"];
  ASSERT_EQ(prior.size(), 6u);
  for (int i = 0; i < 6; ++i) {
    ASSERT_EQ(prior[i].size(), 6u);
    // A measurement takes uncertainty away.
    EXPECT_LT(posterior[i][i], prior[i][i]);
    for (int j = 0; j < i; ++j) {
      expect_equal(prior[i][j], prior[j][i]);
      expect_equal(posterior[i][j], posterior[j][i]);
    }
  }
  const auto metric = [&](const char* name) {
    return json["metrics"][name]["value"].get<double>();
  };
  // The definitions, on the prior: what the scene asks for.
  const double xx = prior[0][0], yy = prior[1][1], zz = prior[2][2];
  EXPECT_NEAR(metric("sigma_x"), std::sqrt(xx), 1e-15);
  EXPECT_NEAR(metric("trace"), xx + yy + zz, 1e-15);
  EXPECT_NEAR(metric("sigma_position"), std::sqrt(xx + yy + zz), 1e-15);
}

/// 0.0189 m: tests/shipped_scenes/oracle.csv. The point is worked out with twice the
/// digits of the field, which has about 1e-12 of them here.
TEST(PointCommand, AgreesWithTheFieldAtASample) {
  const std::string best = "0.2,0.2,0.24";
  const double at_point = point("02-eight-cameras", best)["metrics"]["eigmax"]["value"];
  EXPECT_NEAR(at_point, 0.018895604, 1e-10);
  const Json field = run({"field", scene("02-eight-cameras"), "--json"}).json();
  EXPECT_NEAR(at_point, field["min"]["value"], 1e-10 * at_point);
}

/// Above 0.68 m no point of the scene is seen by two cameras (its own notes). What one
/// camera leaves open is the line of sight to it, and the velocity along that line.
TEST(PointCommand, NamesLostDirections) {
  const Json json = point("02-eight-cameras", "0,0,0.72");
  EXPECT_EQ(json["observable"], false);
  const Json& lost = json["unobservable_directions"];
  ASSERT_EQ(lost.size(), 2u);
  std::string seen_by;
  for (const Json& device : json["devices"]) {
    if (device["visible"] == true) seen_by += device["name"].get<std::string>();
  }
  ASSERT_EQ(seen_by, "lower1");  // at (-0.119, -0.786, 0.821)
  const double sight[3] = {-0.119, -0.786, 0.821 - 0.72};
  const double length = std::hypot(sight[0], sight[1], sight[2]);
  for (int block = 0; block < 2; ++block) {
    double norm2 = 0, along = 0;
    for (int i = 0; i < 6; ++i) norm2 += std::pow(lost[block][i].get<double>(), 2);
    for (int i = 0; i < 3; ++i) {
      along += lost[block][3 * block + i].get<double>() * sight[i] / length;
    }
    EXPECT_NEAR(norm2, 1, 1e-12);
    EXPECT_NEAR(std::abs(along), 1, 1e-6);
  }
}

TEST(PointCommand, ShowsNullForWhatIsInfinite) {
  const Finished done =
      run({"point", scene("02-eight-cameras"), "--at", "0,0,0.72", "--json"});
  const Json json = done.json();
  EXPECT_TRUE(json["metrics"]["eigmax"]["value"].is_null());
  EXPECT_TRUE(json["metrics"]["sigma_x"]["value"].is_null());
  EXPECT_EQ(json["metrics"]["coverage"]["value"], 1);
  EXPECT_TRUE(json["P_prior"][0][0].is_null());
  EXPECT_EQ(done.out.find("inf"), std::string::npos);
  EXPECT_EQ(done.out.find("nan"), std::string::npos);
}

/// The lost line of sight, with a share for nobody who is blind.
TEST(PointCommand, SaysWhatIsLostToPeople) {
  const Finished done = run({"point", scene("02-eight-cameras"), "--at", "0,0,0.72"});
  EXPECT_EQ(done.code, 0);
  EXPECT_NE(done.out.find("some directions are not observed"), std::string::npos);
  EXPECT_NE(done.out.find("\n  lost: x "), std::string::npos) << done.out;
  EXPECT_NE(done.out.find("(doesn't see the point)"), std::string::npos);
}

/// The southern desk's top is from z = 0.71 to 0.74 m.
TEST(PointCommand, SaysThatAPointIsInsideASolid) {
  const auto at = [](const char* place) {
    return run({"point", scene("06-furnished-lab"), "--at", place}).out;
  };
  EXPECT_NE(at("1.35,1,0.72").find("The point is inside a solid"), std::string::npos);
  EXPECT_EQ(at("1.35,1,0.76").find("The point is inside a solid"), std::string::npos);
  EXPECT_EQ(point("06-furnished-lab", "1.35,1,0.72")["inside"], true);
  EXPECT_EQ(point("06-furnished-lab", "1.35,1,0.76")["inside"], false);
}

const std::string kFlat = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {points: [[0, 0, 0]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [0, 0, 0]}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [5, 0, 0]}
  - {name: c, type: uwb_range, rate: 10 Hz, at: [5, 5, 0]}
  - {name: d, type: uwb_range, rate: 10 Hz, at: [0, 5, 0]}
)";

/// Four anchors and the tag on z = 0: σ_z is ∞ with each of them and without.
TEST(PointCommand, LeavesUndefinedWhatNoDeviceDecides) {
  const Folder folder;
  folder.write("flat.yaml", kFlat);
  const std::vector<std::string> at = {"point", "flat.yaml", "--at", "2,1,0"};
  std::vector<std::string> json = at;
  json.push_back("--json");
  const Json report = run(json, folder.path()).json();
  for (const Json& device : report["devices"]) {
    EXPECT_TRUE(device["visible"]);
    EXPECT_TRUE(device["share"].is_null());
  }
  const std::string text = run(at, folder.path()).out;
  EXPECT_EQ(text.find("0 %"), std::string::npos) << text;
  EXPECT_NE(text.find("eigmax isn't observed, with any device or without it"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("lost: z\n"), std::string::npos) << text;
  EXPECT_NE(text.find("the point and all 4 devices that see it lie in one plane, z = 0 "
                      "m, so that small moves out of it change no reading; where the "
                      "target can't make any, 'state: planar' says so"),
            std::string::npos)
      << text;
  // Of the plane itself the shares are defined.
  json.insert(json.end(), {"--metric", "sigma_y"});
  const Json of_y = run(json, folder.path()).json();
  for (const Json& device : of_y["devices"])
    EXPECT_GT(device["share"].get<double>(), 0);
}

/// In a plane the same anchors are enough, and two of them in line with the tag aren't.
TEST(PointCommand, SaysWhatIsLostInAPlane) {
  const Folder folder;
  folder.write("flat.yaml", kFlat);
  const auto text = [&](const char* at, const std::string& devices) {
    return run({"point", "flat.yaml", "--at", at, "--set", "motion.state=planar",
                "--set", "motion.q=[0.4, 0.4]", "--set", devices},
               folder.path())
        .out;
  };
  const std::string line =
      "devices=[{name: a, type: uwb_range, rate: 10 Hz, at: [0, 0, 1]},"
      " {name: b, type: uwb_range, rate: 10 Hz, at: [5, 0, 3]}]";
  EXPECT_NE(text("2,1,0", line).find("every direction is observed"), std::string::npos);
  const std::string lost = text("2,0,0", line);
  EXPECT_NE(
      lost.find("lost: y\n  lost: vy\n  the point and both devices that see it lie "
                "on one line as seen from above"),
      std::string::npos)
      << lost;
}

/// Two anchors and the tag on the x axis: y and z are lost, for another reason.
TEST(PointCommand, SaysThatPlacesAreOnALine) {
  const Folder folder;
  folder.write("line.yaml", R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {points: [[0, 0, 0]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [0, 0, 1]}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [5, 0, 1]}
)");
  const auto text = [&](const char* at) {
    return run({"point", "line.yaml", "--at", at}, folder.path()).out;
  };
  EXPECT_NE(text("2,0,1").find("both devices that see it lie on one line"),
            std::string::npos);
  // Beside the line they span a plane with it, x and z.
  EXPECT_NE(text("2,0,3").find("lie in one plane, y = 0 m"), std::string::npos);
}

Json one_more(const Folder& folder, const std::string& text, const std::string& at,
              const std::vector<std::string>& words = {}) {
  folder.write("room.yaml", text);
  std::vector<std::string> all = {"point", "room.yaml", "--at", at, "--json"};
  all.insert(all.end(), words.begin(), words.end());
  return run(all, folder.path()).json().at("one_more_device");
}

/// The four in the plane know x and y better than one range knows z: each of their
/// informations is above 1/σ², so that the best place is where all of the fifth goes
/// to z, and eigmax is that of a filter of z alone, iterated by itself: σ = 0.1 m,
/// 10 Hz, q = 0.4 m²/s³. Of √5, √10, √20 and 5 m the upper middle is 4.5.
TEST(PointCommand, NamesOneMoreDeviceThatWouldMendIt) {
  const Folder folder;
  const Json json = one_more(folder, kFlat, "2,1,0");
  EXPECT_EQ(json["like"], "a");
  EXPECT_EQ(json["type"], "uwb_range");
  EXPECT_EQ(json["at"], (Json{2, 1, 4.5}));
  EXPECT_EQ(json["metric"], "eigmax");
  EXPECT_EQ(json["unit"], "m");
  EXPECT_NEAR(json["value"].get<double>(), 0.0939260065772414, 1e-9);
  const std::string text =
      run({"point", "room.yaml", "--at", "2,1,0"}, folder.path()).out;
  EXPECT_NE(text.find("\n  one more uwb_range like a at (2, 1, 4.5) m would mend it: "
                      "eigmax 93.9 mm\n"),
            std::string::npos)
      << text;
  // Within the plane σ_x gets better still, but z remains lost.
  EXPECT_EQ(one_more(folder, kFlat, "2,1,0", {"--metric", "sigma_x"})["at"][2], 4.5);
  // Where nothing is lost there's nothing to mend.
  EXPECT_FALSE(run({"point", "room.yaml", "--at", "2,1,1", "--json"}, folder.path())
                   .json()
                   .contains("one_more_device"));
}

/// The scene with that device in it gives what was said.
TEST(PointCommand, KeepsWhatItSaysOfOneMoreDevice) {
  const Folder folder;
  std::string text = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {points: [[0, 0, 0]]}
devices:
  - {name: b, type: pinhole_camera, rate: 20 Hz, at: [4, 0, 2.5], aim: [1, 1, 1], params: {focal: 6 mm, pitch: 5 um, resolution: [1280, 1024]}}
  - {name: away, type: pinhole_camera, rate: 20 Hz, at: [0, 4, 2.5], aim: [9, 9, 9], params: {focal: 12 mm, pitch: 5 um, resolution: [1280, 1024]}}
)";
  const Json more = one_more(folder, text, "1,1,1");
  // The longer lens is the better one.
  ASSERT_EQ(more["like"], "away");
  text +=
      "  - {name: more, type: pinhole_camera, rate: 20 Hz, at: " + more["at"].dump() +
      ", aim: [1, 1, 1], params: {focal: 12 mm, pitch: 5 um, resolution: [1280, "
      "1024]}}\n";
  folder.write("more.yaml", text);
  const Json with =
      run({"point", "more.yaml", "--at", "1,1,1", "--json"}, folder.path()).json();
  EXPECT_EQ(with["observable"], true);
  EXPECT_NEAR(
      with["metrics"]["eigmax"]["value"].get<double>() / more["value"].get<double>(), 1,
      1e-9);
}

/// On the line of two anchors y and z are lost, and one range more gives one of them;
/// beside it only what is across their plane. Of a point that turns ranges say nothing.
TEST(PointCommand, SaysThatNoSingleDeviceWouldMendIt) {
  const Folder folder;
  const std::string line = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {points: [[0, 0, 0]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [0, 0, 1]}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [5, 0, 1]}
)";
  EXPECT_TRUE(one_more(folder, line, "2,0,1").is_null());
  const std::string text =
      run({"point", "room.yaml", "--at", "2,0,1"}, folder.path()).out;
  EXPECT_NE(text.find("\n  one more uwb_range wouldn't mend it at any of 26 places "
                      "about 3 m away\n"),
            std::string::npos)
      << text;
  EXPECT_NE(one_more(folder, line, "2,0,3")["at"][1], 0);

  const std::string turning = R"(delos: 1
motion: {type: position_velocity, state: pose, q: [0.4, 0.4, 0.4, 0.1, 0.1, 0.1]}
sample: {points: [[0, 0, 0]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [0, 0, 1]}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [5, 0, 2]}
  - {name: c, type: uwb_range, rate: 10 Hz, at: [0, 5, 3]}
)";
  EXPECT_TRUE(one_more(folder, turning, "2,1,1").is_null());
}

/// A `linear` device reads the same wherever it stands: nothing can be said.
TEST(PointCommand, AddsNoDeviceThatHasNoPlace) {
  const Folder folder;
  folder.write("linear.yaml", R"(delos: 1
motion: {type: position, q: [0.4, 0.4, 0.4]}
sample: {points: [[0, 0, 0]]}
devices:
  - {name: a, type: linear, rate: 10 Hz, params: {H: [[1, 0, 0]], R: [[1]]}}
)");
  const Finished done =
      run({"point", "linear.yaml", "--at", "0,0,0", "--json"}, folder.path());
  EXPECT_EQ(done.json()["observable"], false);
  EXPECT_FALSE(done.json().contains("one_more_device"));
}

TEST(PointCommand, RefusesPlacesThatAreNone) {
  for (const char* at : {"1,2", "1,2,3,4", "1,2,3 Hz", "1,2,nan", ""}) {
    const Finished done = run({"point", scene("01-acoustic"), "--at", at, "--json"});
    EXPECT_EQ(done.code, 2) << at;
    EXPECT_EQ(done.out, "") << at;
    EXPECT_NE(done.err.find("--at"), std::string::npos) << done.err;
  }
  EXPECT_EQ(run({"point", scene("01-acoustic")}).code, 2);
}

}  // namespace
}  // namespace delos::test
