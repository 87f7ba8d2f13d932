// delos select, as a user runs it.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include "program.h"

namespace delos::test {
namespace {

/// Few samples, few spots and a long reach: a fraction of a second.
std::vector<std::string> anchors(const std::vector<std::string>& more) {
  std::vector<std::string> words = {
      "select",    scene("12-ceiling-anchors"),
      "--threads", "1",
      "--set",     "selection.candidates.0.grid.step=[1.1, 1.1, 1]",
      "--set",     "selection.count=12",
      "--set",     "sample.volume.step=[1.35, 1.35, 1.2]",
      "--set",     "devices.anchor.params.reach=9"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Select, WritesTheContractsDocumentAndAScene) {
  const Folder folder;
  const Finished done =
      run(anchors({"--gap", "0.02", "--json", "--out", "chosen.yaml"}), folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  EXPECT_EQ(json["chosen"].size(), 12u);
  EXPECT_LE(json["lower_bound"], json["value"]);
  EXPECT_LE(json["gap"], 0.02);
  EXPECT_EQ(json["stop"], "proven");
  EXPECT_GT(json["samples"], 0);
  EXPECT_EQ(json["blind"], 0);
  EXPECT_EQ(json["always_blind"], 0);
  EXPECT_GE(json["seconds"], 0);

  // What was written is what was chosen, and no guess has a share in it.
  const std::string chosen = (folder.path() / "chosen.yaml").string();
  const Finished field =
      run({"field", chosen, "--metric", "trace", "--json"}, folder.path());
  ASSERT_EQ(field.code, 0) << field.err;
  EXPECT_NEAR(std::sqrt(field.json()["mean"].get<double>()), json["value"],
              1e-6 * json["value"].get<double>());
  // optimize goes on from it, with the pattern's variables for each.
  const Finished polished =
      run({"optimize", chosen, "--evaluations", "20", "--starts", "1", "--json"},
          folder.path());
  ASSERT_EQ(polished.code, 0) << polished.err;
  EXPECT_EQ(polished.json()["variables"].size(), 24u);
  EXPECT_LE(polished.json()["best"], polished.json()["initial"]);
}

/// Four of five anchors, of which one that isn't worth choosing has another rate: what
/// is certified of the four is what a field of them says.
TEST(Select, WritesTheFusionThatItJudgedBy) {
  const Folder folder;
  folder.write("anchors.yaml", R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.1]}
sample: {points: [[1, 1, 1]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [0, 0, 2], params: &u {sigma: 10 cm}}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [5, 5, 0], params: *u}
  - {name: c, type: uwb_range, rate: 10 Hz, at: [0, 5, 1], params: *u}
  - {name: d, type: uwb_range, rate: 10 Hz, at: [5, 0, 3], params: *u}
  - {name: slow, type: uwb_range, rate: 0.1 Hz, at: [2, 2, 3], params: {sigma: 5 m}}
objective: {minimize: mean, of: eigmax}
selection: {count: 4, candidates: [{devices: "*"}]}
)");
  const Finished done =
      run({"select", "anchors.yaml", "--gap", "0", "--out", "chosen.yaml", "--json"},
          folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  EXPECT_EQ(json["chosen"], (Json{"a", "b", "c", "d"}));
  EXPECT_EQ(json["fusion"], "continuous");
  const Json field = run({"field", "chosen.yaml", "--json"}, folder.path()).json();
  EXPECT_EQ(field["fusion"], "continuous");
  EXPECT_NEAR(field["mean"], json["value"], 1e-3 * json["value"].get<double>());
}

TEST(Select, TellsWhatIsCertified) {
  const Finished done = run(anchors({"--gap", "0.1"}));
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.out.find("Ceiling anchors: 12 of 36 candidates"), std::string::npos)
      << done.out;
  EXPECT_NE(done.out.find("root of the mean of sigma_position² over 50 samples"),
            std::string::npos)
      << done.out;
}

// Two ranges leave a direction open everywhere.
TEST(Select, NamesTheGuessOfWhatStaysBlind) {
  const std::vector<std::string> two = {"--set", "selection.count=2", "--seconds",
                                        "0.2"};
  const Finished done = run(anchors(two));
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.out.find("blind         50 samples, judged by a guess of "),
            std::string::npos)
      << done.out;
  std::vector<std::string> as_json = two;
  as_json.push_back("--json");
  const Json json = run(anchors(as_json)).json();
  EXPECT_EQ(json["blind"], 50);
  EXPECT_EQ(json["always_blind"], 0);
  EXPECT_LE(json["lower_bound"], json["value"]);
}

// A band: values and bounds fall with the count, and agree with single runs.
TEST(Select, DrawsTheCurveOverCounts) {
  const Finished done = run(anchors({"--gap", "0.05", "--counts", "10..13", "--json"}));
  ASSERT_EQ(done.code, 0) << done.err;
  const Json curve = done.json()["curve"];
  ASSERT_EQ(curve.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(curve[i]["chosen"].size(), 10 + i);
    EXPECT_LE(curve[i]["lower_bound"], curve[i]["value"]);
    if (i > 0) {
      EXPECT_LE(curve[i]["lower_bound"], curve[i - 1]["lower_bound"]);
    }
  }
  EXPECT_EQ(run(anchors({"--counts", "9"})).code, 2);
}

TEST(Select, OrdersWhatCanGo) {
  const Finished done = run(anchors({"--remove", "--json"}));
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  ASSERT_EQ(json["removals"].size(), 24u);
  double before = json["all_chosen"];
  for (const Json& removal : json["removals"]) {
    EXPECT_GE(removal["value"], before);
    EXPECT_LE(removal["lower_bound"], removal["value"]);
    before = removal["value"];
  }
  EXPECT_EQ(json["removals"][23]["left"], 12);
}

// No choice is below the envelope at any sample.
TEST(Select, WritesTheEnvelope) {
  const Folder folder;
  const Finished done =
      run(anchors({"--gap", "0.05", "--envelope", "best.csv", "--out", "chosen.csv"}),
          folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  std::istringstream best(read_file(folder.path() / "best.csv")),
      chosen(read_file(folder.path() / "chosen.csv"));
  std::string at_best, at_chosen;
  std::getline(best, at_best);
  std::getline(chosen, at_chosen);
  int rows = 0;
  const auto value = [](const std::string& row) {
    std::istringstream cells(row);
    std::string cell;
    for (int c = 0; c < 4; ++c) std::getline(cells, cell, ',');
    return std::stod(cell);
  };
  while (std::getline(best, at_best) && std::getline(chosen, at_chosen)) {
    EXPECT_LE(value(at_best), value(at_chosen) * 1.001);
    ++rows;
  }
  EXPECT_EQ(rows, 50);
}

// Stopped and taken up again, a search ends with the choice and bound of one that
// wasn't.
TEST(Select, GoesOnFromItsFile) {
  const Folder folder;
  const std::vector<std::string> whole = anchors({"--gap", "0.008", "--json"});
  const auto started = std::chrono::steady_clock::now();
  const Finished once = run(whole, folder.path());
  ASSERT_EQ(once.code, 0) << once.err;
  // As long as the program needs here, so that a slow one gets somewhere too.
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - started;
  std::vector<std::string> pieces = whole;
  for (const std::string& word :
       {std::string("--study"), std::string("kept.sqlite"), std::string("--seconds"),
        std::to_string(std::max(0.15, took.count() / 4))})
    pieces.push_back(word);
  Json json;
  for (int i = 0; i < 100; ++i) {
    const Finished piece = run(pieces, folder.path());
    ASSERT_EQ(piece.code, 0) << piece.err;
    json = piece.json();
    if (json["stop"] == "proven") break;
  }
  EXPECT_EQ(json["stop"], "proven");
  EXPECT_LE(json["gap"], 0.008);
  EXPECT_NEAR(json["value"], once.json()["value"],
              0.008 * once.json()["value"].get<double>());
  // A file is about one selection.
  const Finished other =
      run(anchors({"--set", "selection.count=11", "--study", "kept.sqlite"}),
          folder.path());
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.err.find("kept.sqlite is about another scene"), std::string::npos)
      << other.err;
}

TEST(Select, CoversEverySample) {
  const Folder folder;
  const Finished done = run({"select", scene("14-camera-cover"), "--seconds", "3",
                             "--json", "--out", "cover.yaml"},
                            folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.json()["value"], 7);
  EXPECT_EQ(done.json()["chosen"].size(), 7u);
  const Finished field =
      run({"field", (folder.path() / "cover.yaml").string(), "--json"}, folder.path());
  ASSERT_EQ(field.code, 0) << field.err;
  EXPECT_GE(field.json()["min"]["value"], 1);
}

TEST(Select, RefusesWhatHasNoBound) {
  const auto refused = [](const std::vector<std::string>& words,
                          const std::string& why) {
    const Finished done = run(words);
    EXPECT_EQ(done.code, 1);
    EXPECT_NE(done.err.find(why), std::string::npos) << done.err;
  };
  refused({"select", scene("01-acoustic")}, "the scene has no selection");
  refused(anchors({"--set", "metric=det"}),
          "det isn't a convex function of the covariance");
  refused(anchors({"--set", "objective={minimize: percentile}"}),
          "other objectives have no bound");
  refused({"select", scene("hiball/strips"), "--set", "devices.hiball.select=mean"},
          "use 'select: all'");
  refused(anchors({"--set",
                   "selection={budget: 1, candidates: [{copies_of: anchor, "
                   "points: [[1, 1, 3]], cost: 2}]}"}),
          "no candidate fits into the budget: the cheapest costs 2, selection.budget "
          "is 1");
  refused(anchors({"--set",
                   "selection={count: 1, candidates: [{devices: anchor}], "
                   "leave_out: anchor}"}),
          "selection.leave_out names every candidate, so that none can be chosen");
}

}  // namespace
}  // namespace delos::test
