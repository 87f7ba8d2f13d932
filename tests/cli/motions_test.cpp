// Several motions of a scene, motions by name and in words, parts of a recording.
#include <gtest/gtest.h>

#include <cmath>

#include "program.h"

namespace delos::test {
namespace {

const std::string kThreeRanges = R"(delos: 1
motion: {named: walk}
motions:
  slow: {type: position_velocity, q: [0.01, 0.01, 0.01]}
  fast: {type: position_velocity, q: [4, 4, 4]}
sample: {points: [[0, 0, 0], [1, 1, 0.5]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [-4, 0, 2]}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [4, -3, 2]}
  - {name: c, type: uwb_range, rate: 10 Hz, at: [0, 4, 0.5]}
)";

TEST(Motions, EachHasItsFieldAndTheWorstIsTheirEnvelope) {
  const Folder folder;
  folder.write("s.yaml", kThreeRanges);
  const auto mean = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"field", "s.yaml", "--json"});
    const Finished done = run(words, folder.path());
    EXPECT_EQ(done.code, 0) << done.err;
    return done.json();
  };
  const auto slow = mean({"--motion", "slow"}), fast = mean({"--motion", "fast"}),
             all = mean({"--motion", "all"});
  EXPECT_EQ(slow["mean"], mean({"--set",
                                "motion={type: position_velocity, q: [0.01, "
                                "0.01, 0.01]}"})["mean"]);
  EXPECT_LT(slow["mean"].get<double>(), fast["mean"].get<double>());
  ASSERT_EQ(all["motions"].size(), 2u);
  EXPECT_EQ(all["motions"][0]["motion"], "slow");
  EXPECT_EQ(all["motions"][0]["mean"], slow["mean"]);
  EXPECT_EQ(all["mean"], fast["mean"]) << "whose values are worse at each sample";
  EXPECT_EQ(all["max"], fast["max"]);
  const auto coverage = mean({"--motion", "all", "--metric", "coverage"});
  EXPECT_EQ(coverage["mean"], 3);
}

TEST(Motions, AreRefusedWithASentence) {
  const Folder folder;
  folder.write("s.yaml", kThreeRanges);
  const auto refused = [&](std::vector<std::string> words, const std::string& part) {
    const Finished done = run(words, folder.path());
    EXPECT_EQ(done.code, 2) << done.err;
    EXPECT_NE(done.err.find(part), std::string::npos) << done.err;
  };
  refused({"field", "s.yaml", "--motion", "punch"}, "there are slow, fast");
  refused({"field", scene("01-acoustic"), "--motion", "all"},
          "the scene has no motions");
  refused({"field", "s.yaml", "--motion", "all", "--out", "a.csv"}, "about one motion");
  refused({"motions", "wlak"}, "there are still, walk");
  refused({"motions", "--speed", "1 m/s"}, "words need --speed");
  refused({"motions", "--speed", "0 m/s", "--changes-within", "1 s"}, "above 0");
  refused({"motions", "walk", "--speed", "1 m/s"}, "by name or in words");
}

TEST(Motions, AreWrittenAsBlocksOfAScene) {
  const Finished words = run({"motions", "--speed", "1.5 m/s", "--changes-within",
                              "0.5 s", "--vertical", "20 cm/s"});
  ASSERT_EQ(words.code, 0) << words.err;
  EXPECT_NE(words.out.find("q: [4.5, 4.5, 0.16]"), std::string::npos) << words.out;
  const Finished list = run({"motions"});
  EXPECT_NE(list.out.find("hiball_head"), std::string::npos);
  EXPECT_NE(list.out.find("Eq. 57"), std::string::npos);
  const Folder folder;
  const Finished walk = run({"motions", "walk"});
  folder.write("s.yaml", "delos: 1\n" + walk.out +
                             kThreeRanges.substr(kThreeRanges.find("sample")));
  EXPECT_EQ(run({"check", "s.yaml"}, folder.path()).code, 0) << walk.out;
}

/// A recording that stands still and then walks about becomes two motions, which a
/// scene takes.
TEST(ReadingCommands, AnswerInNumbers) {
  const Finished noise =
      run({"noise", "--current", "297.8466526 nA", "--at", "0.5", "--json"});
  ASSERT_EQ(noise.code, 0) << noise.err;
  const auto window = noise.json()["windows"][0];
  EXPECT_NEAR(window["linear"].get<double>(), 0.001751273, 1e-9);
  EXPECT_EQ(window["ends"][0]["sources"].size(), 6u);
  const Finished power =
      run({"power", "--sigma", "2", "--effect", "1", "--two-means", "--estimated"});
  EXPECT_NE(power.out.find("Two means of 64 readings each"), std::string::npos)
      << power.out << power.err;
  const Finished shutter = run({"shutter", "11", "--time", "10 ms", "--json"});
  ASSERT_EQ(shutter.code, 0) << shutter.err;
  EXPECT_NEAR(shutter.json()["motion"]["position_velocity"].get<double>(), 1e-6 / 20,
              1e-15);
}

TEST(ReadingCommands, RefuseWhatIsNoQuestion) {
  const auto refused = [](std::vector<std::string> words, int code,
                          const std::string& part) {
    const Finished done = run(words);
    EXPECT_EQ(done.code, code) << done.err;
    EXPECT_NE(done.err.find(part), std::string::npos) << done.err;
  };
  refused({"power", "--sigma", "1"}, 2, "give --effect, --readings or both");
  refused(
      {"power", "--sigma", "1", "--effect", "1", "--readings", "9", "--power", "0.5"},
      2, "give two, ask for one");
  refused({"power", "--sigma", "-1", "--effect", "1"}, 2, "sigma must be above 0");
  refused({"power", "--sigma", "1", "--readings", "1", "--estimated"}, 2, "from 2 to");
  refused({"power", "--sigma", "1", "--effect", "1e-12"}, 1, "aren't enough");
  refused({"noise", "--current", "0 A"}, 2, "must be above 0");
  refused({"shutter", "1021", "--time", "1 ms"}, 2, "must be of 0 and 1");
}

}  // namespace
}  // namespace delos::test
