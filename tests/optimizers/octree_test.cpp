// Searches of scenes that are sampled adaptively: each stage on the octree of the
// design that it begins with, the end on a dense grid.
#include <unistd.h>

#include <map>
#include <mutex>
#include <numeric>

#include "delos/field/adaptive.h"
#include "delos/optimize/study.h"
#include "optimizers/scenes.h"
#include "problem/search_samples.h"
#include "support/folder.h"

namespace delos::test {
namespace {

/// Three cameras about a box that a screen hides parts of.
Scene screened() {
  return parse(R"(delos: 1
name: Screened
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
metric: eigmax
sample: {volume: {min: [-0.5, -0.5, -0.5], max: [0.5, 0.5, 0.5], adaptive: {tolerance: 0.5 %, depth: 6}}}
devices:
  - {name: west, rate: 50, type: pinhole_camera, at: [-2, 0, 0.5], aim: [0, 0, 0], params: &p {focal: 8 mm, pitch: 5 um, resolution: [1280, 1024]}}
  - {name: south, rate: 50, type: pinhole_camera, at: [0.3, -2, 0], aim: [0, 0, 0], params: *p}
  - {name: above, rate: 50, type: pinhole_camera, at: [0, 0.4, 2], aim: [0, 0, 0], params: *p}
occluders:
  - {box: {min: [-0.9, -0.3, -0.4], max: [-0.8, 0.1, 0.3]}}
variables:
  - {path: devices.west.at.y, lower: -1.5, upper: 1.5}
  - {path: devices.south.at.x, lower: -1.5, upper: 1.5}
  - {path: devices.above.at.x, lower: -1, upper: 1}
objective: {minimize: mean, guess: 5 cm}
)");
}

constexpr std::size_t kSamples = 400;

OptimizeOptions options_of(int threads) {
  OptimizeOptions options;
  options.evaluations = 80;
  options.starts = 2;
  options.seed = 5;
  options.samples = kSamples;
  options.threads = threads;
  return options;
}

/// Keeps what a search evaluates.
class Notes : public EvaluationLedger {
 public:
  struct Note {
    std::vector<double> x;
    EvaluationRecord record;
  };
  bool recall(const EvaluationKey&, std::span<const double>,
              EvaluationRecord&) override {
    return false;
  }
  void remember(const EvaluationKey& key, std::span<const double> x,
                const EvaluationRecord& record) override {
    const std::lock_guard lock(mutex_);
    notes[{key.start, key.number}] = {{x.begin(), x.end()}, record};
  }
  std::map<std::pair<int, int>, Note> notes;

 private:
  std::mutex mutex_;
};

TEST(OctreeSearch, NodesAreFineWhereTheFieldIsAndFillTheBox) {
  const Scene scene = screened();
  const auto octrees = [&](const AdaptiveSampling& box) {
    return evaluate_adaptive(
               build_system(scene, plugins()), box, scene.orientations,
               std::get<Metric>(parse_metric("eigmax", scene.motion.layout)), {})
        .field();
  };
  const SearchSamples found = search_samples(scene, 100, octrees);
  EXPECT_GT(found.samples.points.size(), 100u);
  EXPECT_NEAR(
      std::accumulate(found.multiplicity.begin(), found.multiplicity.end(), 0.0), 1.0,
      1e-12);
  const auto [least, most] =
      std::minmax_element(found.multiplicity.begin(), found.multiplicity.end());
  EXPECT_GT(*most, 7 * *least);
  // A search takes about as many as it was told to.
  Problem problem(scene, plugins(), {kSamples, 1, std::vector<double>(3, 0.5)});
  EXPECT_LT(problem.samples(), 1.2 * kSamples);
  EXPECT_GT(problem.samples(), kSamples / 4);
}

// The score of every evaluation is that on the octree of the first design of its stage,
// which another design's isn't.
TEST(OctreeSearch, IsFrozenInAStageAndRebuiltBeforeTheNext) {
  const Scene scene = screened();
  Notes notes;
  OptimizeOptions options = options_of(1);
  options.ledger = &notes;
  const OptimizeResult found = optimize(scene, plugins(), options);
  std::unique_ptr<Problem> stage;
  double width = -1;
  int start = -1, stages = 0, compared = 0, differ = 0, rebuilt = 0;
  Problem even(scene, plugins(), {kSamples, 1});
  for (const auto& [key, note] : notes.notes) {
    if (note.record.slope.empty()) continue;  // hard scores are on even samples
    if (note.record.width != width || key.first != start) {
      width = note.record.width;
      start = key.first;
      ++stages;
      if (stage)
        rebuilt +=
            stage->soft_score(note.x, width).objective != note.record.score.objective;
      stage = std::make_unique<Problem>(
          scene, plugins(),
          ProblemOptions{width >= 0.1 ? kSamples / 4 : kSamples, 1, note.x});
    }
    EXPECT_EQ(stage->soft_score(note.x, width).objective, note.record.score.objective)
        << "start " << start << ", width " << width;
    differ += even.soft_score(note.x, width).objective != note.record.score.objective;
    ++compared;
  }
  EXPECT_GE(stages, 8);
  EXPECT_GT(compared, 3 * stages);
  EXPECT_EQ(differ, compared);
  EXPECT_GE(rebuilt, 4);  // later ones begin where the last one ended
  Problem dense(scene, plugins(), {0, 1});
  EXPECT_EQ(found.best.objective, dense.score(found.best_x).objective);
  EXPECT_GT(dense.samples(), 40'000u);
  EXPECT_LT(found.best.objective, found.initial.objective);
}

TEST(OctreeSearch, IsTheSameForAnyThreadsAndWhenResumed) {
  const Folder folder;
  const OptimizeOptions one = options_of(1);
  const StudyPlan plan = {.evaluations = one.evaluations,
                          .starts = one.starts,
                          .seed = one.seed,
                          .samples = one.samples};
  const auto begun = [&](const char* name) {
    return Study::create(folder / name, screened(), ".", plan, plugins());
  };
  Study whole = begun("whole");
  (void)whole.run(one);
  Study part = begun("part");
  std::atomic<bool> cancel = false;
  OptimizeOptions stopped = one;
  stopped.cancel = &cancel;
  stopped.progress = [&](const SearchProgress& at) {
    if (at.evaluations >= 25) cancel = true;
  };
  (void)part.run(stopped);
  EXPECT_LT(part.evaluations(1).size(), whole.evaluations(1).size());
  (void)part.run(options_of(2));
  EXPECT_EQ(part.dump(), whole.dump());
}

}  // namespace
}  // namespace delos::test
