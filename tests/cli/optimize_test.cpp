// delos optimize and delos study, as a user runs them.
#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>

#include "program.h"
#include "studies.h"

namespace delos::test {
namespace {

const std::vector<std::string> kSmall = {"optimize",      scene("10-better-speakers"),
                                         "--evaluations", "60",
                                         "--starts",      "2",
                                         "--samples",     "100",
                                         "--threads",     "1"};

std::vector<std::string> small(const std::vector<std::string>& more) {
  std::vector<std::string> words = kSmall;
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Optimize, WritesTheContractsDocument) {
  const Folder folder;
  const Finished done = run(small({"--json", "--out", "best.yaml"}), folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  EXPECT_LT(json["best"], json["initial"]);
  EXPECT_EQ(json["variables"].size(), 6u);
  EXPECT_GT(json["gradient_evaluations"], 0);
  EXPECT_TRUE(json["study"].is_null());
  ASSERT_EQ(json["constraints"].size(), 1u);
  EXPECT_EQ(json["constraints"][0]["name"], "budget");
  EXPECT_EQ(json["constraints"][0]["satisfied"], true);

  // The scene that was written is the one that was found.
  const Finished field =
      run({"field", (folder.path() / "best.yaml").string(), "--json"}, folder.path());
  ASSERT_EQ(field.code, 0) << field.err;
  EXPECT_NEAR(field.json()["mean"], json["best_field"]["mean"], 1e-12);
}

/// More is known at a higher rate: 10 Hz, where the rates are equal, is the best,
/// though the default fusion of the scenes below it is another one than at it.
TEST(Optimize, DoesntMistakeAnotherDefinitionForABetterDesign) {
  const Folder folder;
  folder.write("anchors.yaml", R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.1]}
sample: {points: [[1, 1, 1]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [0, 0, 2], params: &u {sigma: 10 cm}}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [5, 5, 0], params: *u}
  - {name: c, type: uwb_range, rate: 10 Hz, at: [0, 5, 1], params: *u}
variables: [{path: devices.a.rate, lower: 1 Hz, upper: 10 Hz}]
)");
  const Finished done =
      run({"optimize", "anchors.yaml", "--seed", "1", "--out", "best.yaml", "--json"},
          folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  EXPECT_EQ(json["best"], json["initial"]);
  EXPECT_EQ(json["variables"]["devices.a.rate"], 10);
  EXPECT_EQ(json["fusion"], "continuous");
  EXPECT_NE(read_file(folder.path() / "best.yaml").find("fusion: continuous"),
            std::string::npos);
  // What is written says what it was found to be.
  const Json field = run({"field", "best.yaml", "--json"}, folder.path()).json();
  EXPECT_EQ(field["fusion"], "continuous");
  EXPECT_EQ(field["mean"], json["best_field"]["mean"]);
  // A fourth anchor would have a rate of its own.
  const Json curve = run({"tradeoff", "anchors.yaml", "--devices", "3..4", "--starts",
                          "1", "--evaluations", "8", "--json"},
                         folder.path())
                         .json();
  EXPECT_EQ(curve["fusion"], "continuous");
  EXPECT_EQ(curve["covariance"], "prior");
}

TEST(Optimize, TellsWhatChanged) {
  const Finished done = run(small({}));
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.out.find("p-norm of eigmax: 61.9 mm before, "), std::string::npos)
      << done.out;
  EXPECT_NE(done.out.find("budget: kept, with "), std::string::npos) << done.out;
}

// What a failure costs is told on all samples, however few the search looked at: as an
// objective that withstands that failure is.
TEST(Optimize, ExplainsFailuresOnAllSamples) {
  const std::vector<std::string> words = {
      "optimize",      scene("09-camera-room"),
      "--set",         "variables=[{path: devices.west.aim.x, lower: 2, upper: 4}]",
      "--evaluations", "1",
      "--starts",      "1",
      "--json"};
  auto explained = words;
  explained.insert(explained.end(), {"--samples", "40", "--explain"});
  const double rise = run(explained).json()["answers"]["without"]["east"];
  auto robust = words;
  robust.insert(robust.end(), {"--set", "objective.robust.failures=east"});
  const Json worst = run(robust).json();
  EXPECT_GT(rise, 0.1);
  EXPECT_NEAR(worst["best"], worst["plain_best"].get<double>() * (1 + rise), 1e-9);
}

TEST(Optimize, RefusesAWordOfTheUserLineByLine) {
  const Finished done =
      run({"optimize", scene("01-acoustic"), "--set",
           "variables=[{path: devices.s5.at.z, lower: 0, upper: 1}]"});
  EXPECT_EQ(done.code, 1);
  EXPECT_NE(done.err.find("there is no number 's5' here; did you mean 's"),
            std::string::npos)
      << done.err;
  const Finished none = run({"optimize", scene("01-acoustic")});
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.err.find("the scene has no variables"), std::string::npos) << none.err;
  EXPECT_EQ(run({"optimize", scene("01-acoustic"), "--algorithm", "magic"}).code, 2);
}

TEST(Optimize, KeepsTheBestAtCtrlC) {
  const Folder folder;
  Running program({"optimize", scene("09-camera-room"), "--threads", "1", "--json",
                   "--out", "best.yaml"},
                  folder.path());
  ASSERT_TRUE(reached(
      program, [&] { return program.err().find(" after ") != std::string::npos; }));
  program.send(SIGINT);
  const Finished done = program.wait();
  ASSERT_EQ(done.code, 3) << done.err;
  EXPECT_EQ(done.json()["stop"], "cancelled");
  EXPECT_LE(done.json()["best"], done.json()["initial"]);
  EXPECT_FALSE(read_file(folder.path() / "best.yaml").empty());
}

// ---- studies ----

// As one begins: in the scene's own folder, with a body beside it.
TEST(Study, BeginsInTheScenesOwnFolder) {
  const Folder folder;
  folder.write("wall.obj", "v 9 0 0\nv 9 1 0\nv 9 0 1\nf 1 2 3\n");
  folder.write("room.yaml", R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {points: [[0, 0, 0]]}
occluders: [{name: wall, mesh: wall.obj}]
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [2, 0, 0], params: {sigma: 10 cm}}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [0, 2, 0], params: {sigma: 10 cm}}
  - {name: c, type: uwb_range, rate: 10 Hz, at: [1, 1, 2], params: {sigma: 10 cm}}
variables: [{path: devices.c.at.z, lower: 1, upper: 3}]
)");
  const Finished begun = run({"optimize", "room.yaml", "--evaluations", "5", "--study",
                              "s.study", "--out", "best.yaml"},
                             folder.path());
  EXPECT_EQ(begun.code, 0) << begun.err;
  EXPECT_EQ(run({"check", "best.yaml"}, folder.path()).code, 0);
  // The study knows where its scene was, wherever it is taken up.
  const Folder elsewhere;
  const Finished shown =
      run({"study", (folder.path() / "s.study").string(), "best", "best.yaml"},
          elsewhere.path());
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_EQ(run({"check", "best.yaml"}, elsewhere.path()).code, 0);
}

TEST(Study, IsNotOverwritten) {
  const Folder folder;
  const std::string file = (folder.path() / "s").string();
  ASSERT_EQ(run(small({"--study", file})).code, 0);
  const std::string before = exported(file);
  const Finished again = run(small({"--study", file}));
  EXPECT_EQ(again.code, 1);
  EXPECT_NE(again.err.find("exists already"), std::string::npos) << again.err;
  EXPECT_EQ(exported(file), before);
}

TEST(Study, IsSearchedByOneProcessAtATime) {
  const Folder folder;
  const std::string file = (folder.path() / "s").string();
  Running first(
      {"optimize", scene("09-camera-room"), "--threads", "1", "--study", file});
  ASSERT_TRUE(reached(first, [&] { return evaluations(file) > 0; }));
  const Finished second = run({"study", file, "resume"});
  EXPECT_EQ(second.code, 1);
  EXPECT_NE(second.err.find("is being searched by another process"), std::string::npos)
      << second.err;
  // Looking and pausing are for everybody.
  EXPECT_EQ(run({"study", file, "show"}).code, 0);
  EXPECT_EQ(run({"study", file, "pause"}).code, 0);
  EXPECT_EQ(first.wait().code, 3);
}

// A person locks two speakers and forbids a corner; the search respects both.
TEST(Study, RespectsActs) {
  const Folder folder;
  const std::string file = (folder.path() / "s").string();
  ASSERT_EQ(run(small({"--study", file})).code, 0);
  ASSERT_EQ(run({"study", file, "best", (folder.path() / "first.yaml").string()}).code,
            0);
  const auto act = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all = {"study", file};
    all.insert(all.end(), words.begin(), words.end());
    return run(all);
  };
  ASSERT_EQ(act({"set", "devices.s1.at.x=-0.1"}).code, 0);
  ASSERT_EQ(act({"lock", "devices.s1"}).code, 0);
  ASSERT_EQ(act({"forbid", "0.55,-1,0", "2,2,2"}).code, 0);
  const Finished done = act({"resume", "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  EXPECT_EQ(json["variables"]["devices.s1.at.x"], -0.1);
  EXPECT_LE(json["variables"]["devices.s2.at.x"], 0.55);
  ASSERT_EQ(json["constraints"].size(), 2u);
  EXPECT_EQ(json["constraints"][1]["name"], "forbidden1");
  EXPECT_EQ(json["constraints"][1]["satisfied"], true);

  const Json study = shown(file);
  EXPECT_EQ(study["acts"].size(), 3u);
  EXPECT_EQ(study["rounds"].size(), 2u);
  EXPECT_EQ(study["locked"].size(), 3u);
  // Past designs stay.
  const std::string again = (folder.path() / "again.yaml").string();
  ASSERT_EQ(act({"best", again, "--round", "1"}).code, 0);
  EXPECT_EQ(read_file(again), read_file(folder.path() / "first.yaml"));
  // Unlocked and extended, it goes on from the best.
  ASSERT_EQ(act({"unlock", "devices.s1"}).code, 0);
  ASSERT_EQ(act({"extend", "40"}).code, 0);
  const Finished more = act({"resume", "--json"});
  ASSERT_EQ(more.code, 0) << more.err;
  EXPECT_LE(more.json()["best"], json["best"]);
}

// Every act while the search runs: it ends a round and begins the next, which respects
// it; and all of them can be taken back.
TEST(Study, TakesActsInFlight) {
  const Folder folder;
  const std::string file = (folder.path() / "s").string();
  Running search({"optimize", scene("09-camera-room"), "--threads", "1", "--samples",
                  "200", "--evaluations", "1000000", "--json", "--study", file});
  std::size_t round = 1;
  const auto act = [&](const std::vector<std::string>& words) {
    ASSERT_TRUE(reached(search, [&] { return evaluations(file, round) > 3; })) << round;
    std::vector<std::string> all = {"study", file};
    all.insert(all.end(), words.begin(), words.end());
    const Finished done = run(all);
    ASSERT_EQ(done.code, 0) << done.err;
    ++round;
  };
  act({"lock", "devices.west"});
  act({"lock", "devices.east.aim"});
  act({"set", "devices.east.aim.z=0.7"});  // locked, it stays
  act({"forbid", "{sphere: {radius: 40 cm}, at: [3, 2.5, 3]}"});
  act({"keep", "{name: far, spacing: 70 cm, devices: \"*\"}"});
  act({"drop", "apart"});
  act({"set", "objective={minimize: p_norm, p: 4, of: eigmax}"});
  act({"unlock", "devices.west"});
  act({"inject", scene("09-camera-room")});
  act({"undo"});
  act({"extend", "24"});
  const Finished done = search.wait();
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json(), study = shown(file);
  EXPECT_EQ(study["acts"].size(), 11u);
  EXPECT_EQ(study["rounds"].size(), 12u);
  EXPECT_EQ(json["objective"]["name"], "p-norm of eigmax");
  std::vector<std::string> kept;
  for (const Json& constraint : json["constraints"]) {
    kept.push_back(constraint["name"]);
    EXPECT_EQ(constraint["satisfied"], true) << constraint;
  }
  EXPECT_EQ(kept, (std::vector<std::string>{"beam", "forbidden1", "far"}));
  EXPECT_EQ(json["variables"]["devices.east.aim.z"], 0.7);

  // What was locked from the second round to the eighth stayed as the first left it.
  const auto west = [&](const std::string& number) {
    const std::filesystem::path best = folder.path() / (number + ".yaml");
    EXPECT_EQ(run({"study", file, "best", best.string(), "--round", number}).code, 0);
    const std::string text = read_file(best);
    const std::size_t begin = text.find("name: west"), end = text.find("name: east");
    EXPECT_LT(begin, end);
    return text.substr(begin, end - begin);
  };
  EXPECT_EQ(west("8"), west("1"));

  // It is the same to look again, and to go on where there is nothing to do.
  const std::string before = exported(file);
  const Finished again = run({"study", file, "resume", "--json"});
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.json()["variables"], json["variables"]);
  EXPECT_EQ(exported(file), before);
  for (int i = 0; i < 8; ++i) ASSERT_EQ(run({"study", file, "undo"}).code, 0) << i;
  EXPECT_EQ(run({"study", file, "undo"}).code, 1);
  EXPECT_EQ(shown(file)["locked"].size(), 0u);
}

TEST(Study, RefusesActsThatCannotBe) {
  const Folder folder;
  const std::string file = (folder.path() / "s").string();
  ASSERT_EQ(run(small({"--study", file})).code, 0);
  const auto error = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all = {"study", file};
    all.insert(all.end(), words.begin(), words.end());
    const Finished done = run(all);
    EXPECT_EQ(done.code, 1) << done.out;
    return done.err;
  };
  EXPECT_NE(error({"lock", "devices.s9"}).find("no variable fits 'devices.s9'"),
            std::string::npos);
  EXPECT_NE(error({"lock", "*"}).find("would lock every variable"), std::string::npos);
  EXPECT_NE(error({"set", "devices.s1.at.q=3"}).find("there is no such member"),
            std::string::npos);
  EXPECT_NE(error({"forbid", "0,0,0", "0,1,1"}).find("the box is flat"),
            std::string::npos);
  EXPECT_NE(error({"undo"}).find("there is no act to undo"), std::string::npos);
  EXPECT_EQ(shown(file)["acts"].size(), 0u);
  EXPECT_EQ(run({"study", (folder.path() / "none").string(), "show"}).code, 1);
  const auto other = folder.write("other.txt", "not a study");
  EXPECT_EQ(run({"study", other.string(), "show"}).code, 1);
}

}  // namespace
}  // namespace delos::test
