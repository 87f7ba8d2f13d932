// Covers of scenes: what candidates see is what their devices say.
#include "delos/optimize/cover_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "delos/layers/candidate_information.h"
#include "optimizers/scenes.h"

namespace delos::test {
namespace {

/// Published solutions number spots with y fastest and facings with pans fastest, the
/// scene's candidates the other way round.
std::size_t candidate_of(int published, int side) {
  const int pan = published % 8, tilt = published / 8 % 3, spot = published / 24;
  const int x = spot / side, y = spot % side;
  return static_cast<std::size_t>(((y * side + x) * 8 + pan) * 3 + tilt);
}

// tests/data/camera-placement/AC_01.txt covers every sample of scene 14, as the cameras
// of the plugin see them; without any one of its cameras it doesn't.
TEST(SceneCover, SeesWhatPublishedSolutionsCover) {
  const Scene scene = load("14-camera-cover");
  const auto all = std::get<0>(write_out_candidates(scene));
  ASSERT_EQ(all.candidates.size(), 2904u);
  const System system = build_system(all.scene, plugins());
  std::vector<TargetPose> poses;
  for (const Eigen::Vector3d& p : make_samples(scene.samples).points)
    poses.push_back({Eigen::Matrix3d::Identity(), p});
  ASSERT_EQ(poses.size(), 605u);
  const CandidateViews views = candidate_views(system, all, poses);
  std::ifstream file(DELOS_TEST_DATA "/camera-placement/AC_01.txt");
  int count = 0;
  ASSERT_TRUE(file >> count);
  std::vector<int> seen(poses.size(), 0);
  for (int published = 0; file >> published;) {
    const std::size_t c = candidate_of(published, 11);
    for (std::size_t i = views.first[c]; i < views.first[c + 1]; ++i)
      ++seen[static_cast<std::size_t>(views.poses[i])];
  }
  EXPECT_EQ(count, 7);
  EXPECT_EQ(*std::min_element(seen.begin(), seen.end()), 1);
}

TEST(SceneCover, FindsThePublishedCount) {
  SelectOptions options;
  options.seconds = 3;
  const SceneCover cover = cover_scene(load("14-camera-cover"), plugins(), options);
  EXPECT_EQ(cover.chosen.size(), 7u);
  EXPECT_EQ(cover.cost, 7);
  EXPECT_LE(cover.lower_bound, 7);
  EXPECT_GE(cover.lower_bound, 5);
  EXPECT_EQ(cover.samples, 605u);
}

/// Anchors that hear no farther than a metre, at x = 0, 1, 2 and 3; samples between.
std::string anchors(const std::string& selection, const std::string& more = "") {
  return R"(delos: 1
name: Anchors
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {points: [[0.5, 0, 0], [1.5, 0, 0], [2.5, 0, 0]]}
devices:
  - {name: a, type: acoustic_range, rate: 50, at: [0, 0, 0], params: {reach: 0.9}}
)" + more +
         "selection: {" + selection +
         ", candidates: [{copies_of: a, points: [[0, 0, 0], [1, 0, 0], [2, 0, 0], "
         "[3, 0, 0]]}]}\n";
}

TEST(SceneCover, CountsWhatIsThereAnyway) {
  const SceneCover once = cover_scene(parse(anchors("cover: 1")), plugins(), {});
  EXPECT_EQ(once.cost, 2);
  EXPECT_EQ(once.stop, CoverStop::proven);
  const SceneCover twice = cover_scene(parse(anchors("cover: 2")), plugins(), {});
  EXPECT_EQ(twice.cost, 4);
  const std::string far =
      "  - {name: always, type: acoustic_range, rate: 50, at: [0, 0, 5]}\n";
  EXPECT_EQ(cover_scene(parse(anchors("cover: 2", far)), plugins(), {}).cost, 2);
  const SceneCover kept =
      cover_scene(parse(anchors("cover: 1, keep: a-0, leave_out: a-1")), plugins(), {});
  EXPECT_EQ(kept.chosen, (std::vector<std::size_t>{0, 2}));
}

// 2904 candidates: first who sees what, then costs.
TEST(SceneCover, TellsHowFarItIs) {
  SelectOptions options;
  options.seconds = 2;
  options.threads = 1;
  std::vector<SelectProgress> told;
  options.progress = [&](const SelectProgress& at) { told.push_back(at); };
  (void)cover_scene(load("14-camera-cover"), plugins(), options);
  const auto searches =
      std::find_if(told.begin(), told.end(),
                   [](const SelectProgress& at) { return std::isfinite(at.value); });
  EXPECT_GT(searches - told.begin(), 10);
  EXPECT_GT(told.end() - searches, 0);
  for (auto at = told.begin(); at != searches; ++at)
    EXPECT_GE(at->ready, at == told.begin() ? 0 : (at - 1)->ready);
  for (auto at = searches; at != told.end(); ++at) {
    EXPECT_EQ(at->ready, 1);
    EXPECT_GE(at->lower_bound, 1);
  }
}

TEST(SceneCover, SaysWhereTheTimeIsTooShort) {
  SelectOptions options;
  options.seconds = 1e-6;
  try {
    (void)cover_scene(load("14-camera-cover"), plugins(), options);
    FAIL();
  } catch (const std::invalid_argument& refusal) {
    EXPECT_NE(std::string(refusal.what())
                  .find("of 2904 candidates were asked what they see of 605 samples "
                        "before the time was over; allow more seconds"),
              std::string::npos)
        << refusal.what();
  }
}

TEST(SceneCover, NamesWhatNoCandidateSees) {
  try {
    (void)cover_scene(parse(anchors("cover: 1, leave_out: [a-0, a-1]")), plugins(), {});
    FAIL();
  } catch (const std::invalid_argument& refusal) {
    EXPECT_EQ(std::string(refusal.what()),
              "1 of 3 samples can't be seen at all, whatever is chosen:\n"
              "  at (0.5, 0, 0)");
  }
  EXPECT_THROW(cover_scene(parse(anchors("count: 1")), plugins(), {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace delos::test
