// What is kept of a search, and what makes one scene out of another.
#include "session/search_record.h"

#include <gtest/gtest.h>

#include <cmath>

#include "delos/scene/io.h"
#include "designs.h"

namespace delos::session {
namespace {

/// Scene 10's six variables, at the same part of each one's range.
StudyEvaluation evaluated(int number, double objective, double part = 0.5) {
  return {1, {0, number}, 0, objective, true, std::vector<double>(6, part)};
}

struct Recorded {
  Design design = design_of("10-better-speakers");
  SearchRecord record;
  Recorded() { record.begin_round(1, design.loaded().scene, plugins()); }
};

TEST(SearchRecord, KeepsWhatWasTheBestOfItsTime) {
  Recorded kept;
  SearchRecord& record = kept.record;
  StudyEvaluation soft = evaluated(0, 1), missed = evaluated(1, 2);
  soft.width = 0.1;
  missed.feasible = false;
  for (const StudyEvaluation& e :
       {soft, missed, evaluated(2, 5), evaluated(3, 6), evaluated(4, 4, 1),
        evaluated(4, 3), evaluated(2, 0)})
    record.add(e);
  EXPECT_EQ(record.evaluations(), 5u) << "what is recalled counts once";
  ASSERT_EQ(record.incumbents(), 2u);
  EXPECT_EQ(record.best()->objective, 4);
  const VariableValues best = record.values(std::size_t{1});
  EXPECT_EQ(best.paths[2], "devices.s1.at.z");
  EXPECT_EQ(best.values[2], 1.2) << "its upper bound";
  EXPECT_EQ(record.values(std::size_t{0}).values[2], 0.9 + 0.5 * (1.2 - 0.9));
  EXPECT_THROW((void)record.values(std::size_t{2}), std::invalid_argument);

  const Json news = record.json({1, 4}, -1);
  ASSERT_EQ(news["incumbents"].size(), 1u);
  EXPECT_EQ(news["incumbents"][0]["number"], 1);
  EXPECT_EQ(news["incumbents"][0]["objective"], -4);
  ASSERT_EQ(news["designs"].size(), 1u);

  record.part_from_rounds(1);
  EXPECT_EQ(record.best(), nullptr);
  record.add(evaluated(5, 1));
  EXPECT_EQ(record.best(), nullptr) << "it is of what was before a hand";
  record.begin_round(2, kept.design.loaded().scene, plugins());
  StudyEvaluation next = evaluated(0, 7);
  next.round = 2;
  record.add(next);
  ASSERT_NE(record.best(), nullptr);
  EXPECT_EQ(record.best()->objective, 7);
  EXPECT_EQ(record.incumbents(), 3u);
}

/// Several threads begin with several starts; none is better than what there was before
/// that is known.
TEST(SearchRecord, BeginsWithTheDesignThatThereWas) {
  Recorded kept;
  const auto other = [](int start, double objective) {
    StudyEvaluation e = evaluated(0, objective);
    e.key.start = start;
    return e;
  };
  kept.record.add(other(1, 9));
  kept.record.add(other(2, 3));
  EXPECT_EQ(kept.record.best(), nullptr);
  kept.record.add(evaluated(0, 5));
  const Json incumbents = kept.record.json({}, 1)["incumbents"];
  ASSERT_EQ(incumbents.size(), 2u);
  EXPECT_EQ(incumbents[0]["objective"], 5);
  EXPECT_EQ(incumbents[0]["evaluation"], 3);
  EXPECT_EQ(incumbents[1]["objective"], 3);
  kept.record.add(other(3, 4));
  EXPECT_EQ(kept.record.incumbents(), 2u);
}

TEST(SearchRecord, StaysBoundedOverTenThousandEvaluations) {
  Recorded kept;
  for (int i = 0; i < 10'000; ++i) kept.record.add(evaluated(i, 1.0 / (i + 1)));
  const Json all = kept.record.json({}, 1);
  EXPECT_EQ(all["evaluations"], 10'000);
  EXPECT_LE(all["designs"].size(), SearchRecord::kMostDesigns);
  EXPECT_GE(all["designs"].size(), SearchRecord::kMostDesigns / 2);
  EXPECT_EQ(all["incumbents"].size(), SearchRecord::kMostIncumbents);
  EXPECT_EQ(all["incumbents"].back()["number"], 9'999);
  // Evenly: each as far from the one before.
  const auto& designs = all["designs"];
  const int stride = designs[0]["evaluation"].get<int>();
  for (std::size_t i = 0; i < designs.size(); ++i)
    EXPECT_EQ(designs[i]["evaluation"], (static_cast<int>(i) + 1) * stride);
  EXPECT_THROW((void)kept.record.values(std::size_t{0}), std::invalid_argument)
      << "forgotten";
}

TEST(SearchRecord, StaysBoundedOverAThousandRounds) {
  Recorded kept;
  for (int round = 2; round <= 1000; ++round) {
    kept.record.begin_round(round, kept.design.loaded().scene, plugins());
    StudyEvaluation first = evaluated(0, 1);
    first.round = round;
    kept.record.add(first);
  }
  const Json all = kept.record.json({}, 1);
  EXPECT_EQ(all["rounds"].size(), SearchRecord::kMostRounds);
  EXPECT_EQ(all["incumbents"].size(), SearchRecord::kMostRounds);
  EXPECT_EQ(all["incumbents"].back()["number"], 998);
  EXPECT_EQ(kept.record.json({0, 0, 999}, 1)["rounds"].size(), 1u);
}

TEST(SceneChanges, MakeOneSceneOutOfAnother) {
  const char* const names[] = {"12-ceiling-anchors", "10-better-speakers",
                               "09-camera-room",     "17-crowded-room",
                               "22-lighthouse",      "02-eight-cameras"};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    Design design = design_of(names[i]);
    const Design other = design_of(names[(i + 1) % std::size(names)]);
    const Scene& scene = other.loaded().scene;
    change(design, changes_between(design.loaded().scene, scene));
    EXPECT_EQ(write_scene(design.loaded().scene), write_scene(scene)) << names[i];
    EXPECT_TRUE(changes_between(design.loaded().scene, scene).empty());
    EXPECT_TRUE(design.undo(plugins()));
    EXPECT_EQ(design.loaded().scene.name, design_of(names[i]).loaded().scene.name);
  }
}

TEST(SceneChanges, SetVariablesAndWhatFollowsThem) {
  const Design design = design_of("10-better-speakers");
  const Scene& scene = design.loaded().scene;
  const Scene moved =
      with_values(scene, {{"devices.s1.at.x", "devices.s1.at.z"}, {0.1, 1}}, plugins());
  EXPECT_EQ(moved.devices[0].placement.at, Eigen::Vector3d(0.1, 0, 1));
  // Mirrored about 0.2 m, and tied: as the scene says.
  EXPECT_NEAR(moved.devices[3].placement.at.x(), 0.3, 1e-15);
  EXPECT_EQ(moved.devices[3].placement.at.z(), 1);
  ASSERT_EQ(changes_between(scene, moved).size(), 1u);
  EXPECT_EQ(changes_between(scene, moved)[0].path, "devices");
  EXPECT_EQ(values_of(moved, plugins()).values[0], 0.1);
  EXPECT_THROW((void)with_values(scene, {{"devices.s4.at.x"}, {1}}, plugins()),
               std::invalid_argument);
}

}  // namespace
}  // namespace delos::session
