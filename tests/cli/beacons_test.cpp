// Devices on the target: what field, point and compare say of the beacons that they
// see.
#include <gtest/gtest.h>

#include <cmath>

#include "program.h"

namespace delos::test {
namespace {

const std::string kSix = scene("hiball/six-lepd"), kFour = scene("hiball/four-lepd");

TEST(PointCommand, ListsViewsAndBeacons) {
  const Finished done = run({"point", kSix, "--at", "4.5,7.5,1.9", "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json sightings = done.json()["sightings"];
  ASSERT_GT(sightings.size(), 20u);
  double total = 0;
  for (const Json& s : sightings) {
    EXPECT_EQ(s["device"], "hiball");
    EXPECT_EQ(s["view"].get<std::string>().substr(0, 11), "photodiode ");
    EXPECT_EQ(s["beacon"][2], 2.8);
    const double flat = std::hypot(s["beacon"][0].get<double>() - 4.5,
                                   s["beacon"][1].get<double>() - 7.5);
    // From a lens, which is 19.1 mm from the middle of the ball.
    EXPECT_NEAR(s["distance"].get<double>(), std::hypot(flat, 0.9), 0.0192);
    total += s["share"].get<double>();
  }
  EXPECT_NEAR(total, 1, 1e-12);  // select: mean, one sighting an update
  const Finished text = run({"point", kSix, "--at", "4.5,7.5,1.9"});
  EXPECT_NE(text.out.find("hiball, photodiode 0 through lens 0 "), std::string::npos)
      << text.out;
}

TEST(FieldCommand, SaysWhyNoBeaconIsSeen) {
  const Finished done =
      run({"field", kSix, "--set", "devices.hiball.rpy=[180 deg, 0, 0]"});
  EXPECT_EQ(done.code, 0);
  EXPECT_NE(
      done.out.find("hiball sees no beacon from any sample: none of 5,824 is in a "
                    "view's cone"),
      std::string::npos)
      << done.out;
}

TEST(CheckCommand, RefusesFieldsOfViewThatCannotBe) {
  for (const auto& [field, problem] :
       {std::pair{"0 deg", "0 rad is below the least value 1e-04 rad"},
        {"180 deg", "is above the greatest value 3.1 rad"}}) {
    const Finished done = run(
        {"check", kSix, "--set", std::string("devices.hiball.params.field=") + field});
    EXPECT_EQ(done.code, 1);
    EXPECT_NE(done.err.find("--set devices.hiball.params.field: error: "
                            "devices.hiball.params.field: "),
              std::string::npos)
        << done.err;
    EXPECT_NE(done.err.find(problem), std::string::npos) << done.err;
  }
}

// The same scene three times: as it is, and with a change on one side only.
TEST(CompareCommand, ChangesOneSide) {
  const Finished done =
      run({"compare", kSix, kSix + "+beacons.ceiling.pattern=half",
           kSix + "+devices.hiball.params.r=2.1e-5+sample.plane.counts=[13, 13]",
           "--better-than", "0.25 mm", "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  ASSERT_EQ(json["scenes"].size(), 3u);
  const Json &full = json["scenes"][0], &half = json["scenes"][1];
  EXPECT_EQ(half["scene"],
            "HiBall, six photodiodes, at head height + beacons.ceiling.pattern=half");
  // Half of the rows: half of the beacons in view.
  EXPECT_NEAR(half["beacons_used"].get<double>(),
              full["beacons_used"].get<double>() / 2, 2);
  EXPECT_LT(half["views_used"].get<double>(), 26);
  EXPECT_NEAR(full["better_than"].get<double>(), 168 / 169.0, 1e-12);
  EXPECT_EQ(json["differences"][1]["max"], 0.0);  // the third is the first again
  EXPECT_NE(json["differences"][0]["max"], 0.0);
}

TEST(CompareCommand, RefusesAChangeOfNothing) {
  const Finished done = run({"compare", kSix, kSix + "+beacons.cieling.pattern=half"});
  EXPECT_EQ(done.code, 1);
  EXPECT_NE(done.err.find("cieling"), std::string::npos) << done.err;
  EXPECT_EQ(run({"compare", kSix, kFour, "--better-than", "3 kg"}).code, 2);
}

}  // namespace
}  // namespace delos::test
