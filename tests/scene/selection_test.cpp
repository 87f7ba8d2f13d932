// What scenes say of selections, and the candidates that it means.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "delos/device/beacons.h"
#include "delos/scene/candidates.h"
#include "scene/refusal.h"

namespace delos::test {
namespace {

CandidateScene written_out(const Scene& scene) {
  auto all = write_out_candidates(scene);
  EXPECT_EQ(all.index(), 0u);
  return std::get<0>(std::move(all));
}

std::vector<std::string> names(const CandidateScene& all) {
  std::vector<std::string> names;
  for (const Candidate& c : all.candidates) names.push_back(c.name);
  return names;
}

const std::string kRoom =
    "surfaces:\n"
    "  rail: {rail: [[0, 0, 2], [4, 0, 2]]}\n"
    "  ceiling: {patch: {origin: [0, 0, 3], u: [4, 0, 0], v: [0, -2, 0]}}\n"
    "beacons:\n"
    "  leds: {grid: {min: [0, 0, 3], max: [3, 1, 3], step: 1}, panel: [2, 1]}\n"
    "  few: {list: [[0, 0, 1], [1, 0, 1]]}\n";

TEST(Candidates, AreDevicesByName) {
  const Scene scene =
      scene_with("selection: {count: 1, candidates: [{devices: \"s*\", cost: 3}]}\n");
  const CandidateScene all = written_out(scene);
  EXPECT_EQ(names(all), (std::vector<std::string>{"s1", "s2"}));
  EXPECT_EQ(all.of_device, (std::vector<int>{0, 1}));
  EXPECT_EQ(all.candidates[1].cost, 3);
  const std::size_t second[] = {1};
  const Scene chosen = chosen_scene(all, second);
  ASSERT_EQ(chosen.devices.size(), 1u);
  EXPECT_EQ(chosen.devices[0].name, "s2");
  EXPECT_EQ(chosen.selection, Selection{});
}

TEST(Candidates, AreCopiesAtSpots) {
  const Scene scene = scene_with(
      kRoom +
      "selection:\n"
      "  count: 2\n"
      "  candidates:\n"
      "    - {copies_of: s1, grid: {min: [0, 0, 1], max: [1, 0, 1], step: 1},\n"
      "       aims: [[5, 0, 0], [0, 5, 0], [0, 0, 5]]}\n"
      "    - {copies_of: s2, surface: rail, counts: [3]}\n");
  const CandidateScene all = written_out(scene);
  EXPECT_EQ(names(all),
            (std::vector<std::string>{"s1-0-0", "s1-0-1", "s1-0-2", "s1-1-0", "s1-1-1",
                                      "s1-1-2", "s2-0", "s2-1", "s2-2"}));
  // One facing a spot; spots with one facing have nothing to exclude.
  EXPECT_EQ(all.candidates[0].spot, all.candidates[2].spot);
  EXPECT_NE(all.candidates[0].spot, all.candidates[3].spot);
  EXPECT_EQ(all.candidates[6].spot, -1);
  // The patterns themselves aren't there.
  ASSERT_EQ(all.scene.devices.size(), 9u);
  EXPECT_EQ(all.scene.devices[4].placement.at, Eigen::Vector3d(1, 0, 1));
  EXPECT_EQ(std::get<Aim>(all.scene.devices[4].placement.facing).at,
            Eigen::Vector3d(0, 5, 0));
  EXPECT_EQ(device_pose(all.scene, all.scene.devices[7]).p, Eigen::Vector3d(2, 0, 2));
}

// Camera planners' angles: pan from the x axis, tilt up from the horizon; the image's
// right is x, its down y.
TEST(Candidates, FaceByPanAndTilt) {
  const Scene scene = scene_with(
      "selection: {count: 1, candidates: [{copies_of: s1, points: [[0, 0, 1]],\n"
      "  pans: [0, 90 deg], tilts: [0, -45 deg, -90 deg], one_per_spot: no}]}\n");
  const CandidateScene all = written_out(scene);
  ASSERT_EQ(all.candidates.size(), 6u);
  EXPECT_EQ(all.candidates[3].spot, -1);
  const auto axes = [&](std::size_t i) {
    // s2 stands first: it is no candidate.
    return device_pose(all.scene, all.scene.devices[i + 1]).R;
  };
  const double h = std::sqrt(0.5);
  EXPECT_TRUE(axes(0).col(2).isApprox(Eigen::Vector3d(1, 0, 0), 1e-12));
  EXPECT_TRUE(axes(0).col(0).isApprox(Eigen::Vector3d(0, -1, 0), 1e-12));
  EXPECT_TRUE(axes(0).col(1).isApprox(Eigen::Vector3d(0, 0, -1), 1e-12));
  EXPECT_TRUE(axes(1).col(2).isApprox(Eigen::Vector3d(h, 0, -h), 1e-12));
  EXPECT_TRUE(axes(4).col(2).isApprox(Eigen::Vector3d(0, h, -h), 1e-12));
  EXPECT_TRUE(axes(5).col(2).isApprox(Eigen::Vector3d(0, 0, -1), 1e-12));
  EXPECT_TRUE(axes(5).col(1).isApprox(Eigen::Vector3d(0, -1, 0), 1e-12));
}

TEST(Candidates, AreBeaconsByRowColumnAndPanel) {
  const auto by = [&](const std::string& word) {
    return written_out(scene_with(kRoom +
                                  "selection: {count: 1, candidates: [{beacons: leds, "
                                  "by: " +
                                  word + "}]}\n"));
  };
  EXPECT_EQ(names(by("row")), (std::vector<std::string>{"leds-row-0", "leds-row-1"}));
  EXPECT_EQ(by("row").of_beacon[0], (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(by("column").of_beacon[0], (std::vector<int>{0, 0, 1, 1, 0, 0, 1, 1}));
  EXPECT_EQ(by("panel").of_beacon[0], (std::vector<int>{0, 0, 1, 1, 2, 2, 3, 3}));
  EXPECT_EQ(by("panel").candidates[3].name, "leds-panel-1-1");
  const CandidateScene all = by("beacon");
  EXPECT_EQ(all.candidates.size(), 8u);
  EXPECT_EQ(all.of_beacon[1], (std::vector<int>{-1, -1}));
  const std::size_t chosen[] = {2, 5};
  const Scene some = chosen_scene(all, chosen);
  ASSERT_EQ(some.beacons.size(), 2u);
  const std::vector<Beacon> lit = lit_beacons(some.beacons[0]);
  ASSERT_EQ(lit.size(), 2u);
  EXPECT_EQ(lit[0].p, Eigen::Vector3d(2, 0, 3));
  EXPECT_EQ(lit[1].p, Eigen::Vector3d(1, 1, 3));
  EXPECT_EQ(some.beacons[1], all.scene.beacons[1]);
}

// What is said of a pattern is said of its copies.
TEST(Candidates, TakeVariablesAndConstraintsOfTheirPatternAlong) {
  const Scene scene = scene_with(
      "variables:\n"
      "  - {path: devices.s1.at.x, lower: 0, upper: 2, tie: devices.s1.at.y}\n"
      "  - {path: devices.s2.aim.x, lower: 0, upper: 2}\n"
      "constraints:\n"
      "  - {name: apart, spacing: 50 cm, devices: \"*\"}\n"
      "  - {name: sum, sum: {devices.s1.rate: 2}, at_most: 300}\n"
      "selection: {count: 2, candidates: [{copies_of: s1, points: [[0, 0, 1], "
      "[1, 0, 1], [2, 0, 1]]}, {devices: s2}]}\n");
  const CandidateScene all = written_out(scene);
  // s2 stands first, the copies behind the devices.
  EXPECT_EQ(names(all), (std::vector<std::string>{"s1-0", "s1-1", "s1-2", "s2"}));
  const std::size_t chosen[] = {0, 2};
  const Scene some = chosen_scene(all, chosen);
  ASSERT_EQ(some.variables.size(), 2u);
  EXPECT_EQ(some.variables[1].path, "devices.s1-2.at.x");
  EXPECT_EQ(some.variables[1].followers[0].path, "devices.s1-2.at.y");
  EXPECT_EQ(std::get<KeepApart>(some.constraints[0].what).devices,
            (std::vector<std::string>{"s1-0", "s1-2"}));
  EXPECT_EQ(std::get<KeepSum>(some.constraints[1].what).factors.size(), 2u);
  EXPECT_EQ(load(write_scene(some)).findings, std::vector<std::string>{});
}

TEST(SelectionKeys, SurviveTheRoundTrip) {
  const Scene scene = scene_with(
      kRoom +
      "selection:\n"
      "  budget: 12.5\n"
      "  keep: [s2]\n"
      "  leave_out: \"s1-*-1\"\n"
      "  candidates:\n"
      "    - {devices: [s2], cost: 2}\n"
      "    - {beacons: leds, by: panel}\n"
      "    - {beacons: few}\n"
      "    - {copies_of: s1, surface: ceiling, counts: [2, 3], rpy: [[0, 0, 0], "
      "[0, 1, 0]], one_per_spot: no, cost: 0.5}\n");
  const Loaded again = load(write_scene(scene));
  EXPECT_EQ(again.findings, std::vector<std::string>{});
  EXPECT_EQ(again.scene, scene);
  const Scene cover = scene_with(
      "selection: {cover: 2, candidates: [{copies_of: s1, points: [[0, 0, 1]], pans: "
      "[0, 1], tilts: [0.5]}]}\n");
  EXPECT_EQ(load(write_scene(cover)).scene, cover);
}

std::vector<Bad> bad_selections() {
  const auto e = in_scene;
  const auto with = [](const std::string& rest) {
    return kGood + "selection: {" + rest + "}\n";
  };
  return {
      {"NoCandidates",
       with("count: 1"),
       {e("18:12: error: selection.candidates: missing: what can be chosen, a list")}},
      {"ZeroCandidates",
       with("count: 1, candidates: []"),
       {e("18:35: error: selection.candidates: the list is empty: there is nothing to "
          "choose")}},
      {"HowMany",
       with("candidates: [{devices: s1}]"),
       {e("18:12: error: selection.count: missing: say how much may be chosen by count "
          "or budget, or what must be seen by cover")}},
      {"HowManyTwice",
       with("count: 1, budget: 2, candidates: [{devices: s1}]"),
       {e("18:31: error: selection.budget: keep one of count, budget and cover")}},
      {"KeptBeyondTheCount",
       with("count: 1, keep: \"*\", candidates: [{devices: \"*\"}]"),
       {e("18:20: error: selection.count: 2 candidates are kept already")}},
      {"KeptBeyondTheBudget",
       with("budget: 5, keep: [s1, s2], candidates: [{devices: \"*\", cost: 3}]"),
       {e("18:21: error: selection.budget: the candidates that are kept cost 6 "
          "already")}},
      {"Duplicates",
       with("count: 1, candidates: [{devices: s1}, {devices: \"*\"}]"),
       {e("18:12: error: selection: there are two candidates s1")}},
      {"TheSamePlace",
       with("count: 1, candidates: [{copies_of: s1, points: [[0, 0, 1], [0, 0, 1]]}]"),
       {e("18:12: error: selection: the candidates s1-0 and s1-1 are the same device "
          "in the same place")}},
      {"UnknownDevice",
       with("count: 1, candidates: [{devices: s3}]"),
       {e("18:46: error: selection.candidates.0.devices: there is no device 's3'; did "
          "you mean 's1'?")}},
      {"NoSpots",
       with("count: 1, candidates: [{copies_of: s1}]"),
       {e("18:36: error: selection.candidates.0: say where the copies may stand: one "
          "of grid, points and surface")}},
      {"UnknownKept",
       with("count: 1, keep: s9, candidates: [{devices: s1}]"),
       {e("18:12: error: selection: there is no candidate 's9'")}},
      {"KeptAndLeftOut",
       with("count: 1, keep: s1, leave_out: s1, candidates: [{devices: s1}]"),
       {e("18:12: error: selection: s1 is both kept and left out")}},
      {"PansAlone",
       with("count: 1, candidates: [{copies_of: s1, points: [[0, 0, 1]], pans: [1]}]"),
       {e("18:36: error: selection.candidates.0: pans and tilts belong together; give "
          "both")}},
      {"TooManySpots",
       with("count: 1, candidates: [{copies_of: s1, grid: {min: [0, 0, 3], max: [30, "
            "30, 3], step: 1 mm}}]"),
       {e("18:36: error: selection.candidates.0: 900,060,001 candidates; at most "
          "1,000,000: make the grid coarser or the facings fewer")}},
      {"TooManySpotsOfASurface",
       with("count: 1, candidates: [{copies_of: s1, surface: ceiling, counts: [30000, "
            "30000]}]}\nsurfaces: {ceiling: {patch: {origin: [0, 0, 3], u: [4, 0, 0], "
            "v: [0, 2, 0]}}"),
       {e("18:36: error: selection.candidates.0: 900,000,000 candidates; at most "
          "1,000,000: make the grid coarser or the facings fewer")}},
      {"CostsNothing",
       with("count: 1, candidates: [{devices: s1, cost: 0}]"),
       {e("18:56: error: selection.candidates.0.cost: must be above 0")}},
      {"ByWithoutBeacons",
       with("count: 1, candidates: [{devices: s1, by: row}]"),
       {e("18:54: error: selection.candidates.0.by: is of 'beacons', which isn't "
          "given")}},
      {"TwoKinds",
       with(
           "count: 1, candidates: [{devices: s1, copies_of: s2, points: [[1, 1, 1]]}]"),
       {e("18:61: error: selection.candidates.0.copies_of: the candidates are given by "
          "'devices' already; write another entry of the list for these")}},
  };
}

class BadSelection : public testing::TestWithParam<Bad> {};
TEST_P(BadSelection, IsRefusedWithEveryFinding) { expect_refused(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Texts, BadSelection, testing::ValuesIn(bad_selections()),
                         [](const auto& bad) { return std::string(bad.param.name); });

}  // namespace
}  // namespace delos::test
