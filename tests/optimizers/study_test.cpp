// Studies: what their files hold, and what happens where the disk is full.
#include "delos/optimize/study.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <tuple>

#include "optimizers/scenes.h"

namespace delos::test {
namespace {

/// A folder of its own that is removed with this object.
class Folder {
 public:
  Folder() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "study-XXXXXX").string();
    path = mkdtemp(pattern.data());
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};

const StudyPlan kPlan = {.evaluations = 80, .starts = 2, .seed = 3, .samples = 100};

OptimizeOptions one_thread() {
  OptimizeOptions options;
  options.threads = 1;
  return options;
}

Study begun(const std::filesystem::path& file) {
  return Study::create(file, load("10-better-speakers"), DELOS_SCENES, kPlan,
                       plugins());
}

TEST(Study, IsTheSearchWithoutAFile) {
  const Folder folder;
  Study study = begun(folder.path / "s");
  const OptimizeResult kept = study.run(one_thread());
  OptimizeOptions options = one_thread();
  options.evaluations = kPlan.evaluations;
  options.starts = kPlan.starts;
  options.seed = kPlan.seed;
  options.samples = kPlan.samples;
  const OptimizeResult free = search(load("10-better-speakers"), options);
  EXPECT_EQ(kept.best_x, free.best_x);
  const StudySummary summary = study.summary();
  ASSERT_EQ(summary.rounds.size(), 1u);
  EXPECT_TRUE(summary.rounds[0].ended);
  EXPECT_EQ(summary.rounds[0].evaluations,
            free.evaluations + free.gradient_evaluations);
  EXPECT_EQ(summary.rounds[0].best, free.best.objective);
  // What was written is the scene that was found, and the first one stays.
  EXPECT_EQ(study.scene().devices, free.scene.devices);
  EXPECT_EQ(study.scene(0).devices, load("10-better-speakers").devices);
}

// Stopped within a stage or between two, it goes on as if it hadn't been.
TEST(Study, GoesOnWhereverItWasStopped) {
  const Folder folder;
  Study whole = begun(folder.path / "whole");
  (void)whole.run(one_thread());
  for (const std::size_t after : {1, 5, 8, 9, 10, 23, 47}) {
    Study part = begun(folder.path / ("part" + std::to_string(after)));
    std::atomic<bool> cancel = false;
    OptimizeOptions options = one_thread();
    options.cancel = &cancel;
    options.progress = [&](const SearchProgress& at) {
      if (at.evaluations >= after) cancel = true;
    };
    const OptimizeResult stopped = part.run(options);
    EXPECT_EQ(stopped.stop, SearchStop::cancelled);
    EXPECT_LT(part.evaluations(1).size(), after + 3);
    (void)part.run(one_thread());
    EXPECT_EQ(part.dump(), whole.dump()) << after;
  }
}

// Every place at which a file may not grow any more: a clear sentence, and a study that
// goes on once there is room.
TEST(Study, OutlivesAFullDisk) {
  const Folder folder;
  Study whole = begun(folder.path / "whole");
  (void)whole.run(one_thread());
  int stopped = 0;
  for (const rlim_t room : {40'000, 60'000, 100'000}) {
    const std::filesystem::path file = folder.path / ("full" + std::to_string(room));
    (void)begun(file);
    const pid_t child = fork();
    if (child == 0) {
      signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{room, room};
      setrlimit(RLIMIT_FSIZE, &limit);
      try {
        Study study(file, plugins());
        (void)study.run(one_thread());
      } catch (const std::runtime_error& failure) {
        const std::string text = failure.what();
        const bool clear = text.find("is intact: make room and resume") != text.npos;
        _exit(clear ? 42 : 43);
      }
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    ASSERT_NE(WEXITSTATUS(status), 43);
    if (WEXITSTATUS(status) == 42) ++stopped;
    Study study(file, plugins());
    (void)study.run(one_thread());
    EXPECT_EQ(study.dump(), whole.dump());
  }
  EXPECT_GT(stopped, 0);
}

TEST(Study, UndoesActsThatNoRoundHasBegunWith) {
  const Folder folder;
  Study study = begun(folder.path / "s");
  const Scene before = study.scene();
  study.act("set", "devices.s1.at.x=-0.2");
  // What mirrors the variable moves with it.
  EXPECT_EQ(study.scene().devices[3].placement.at.x(), 0.6000000000000001);
  study.act("lock", "devices.s2.at.y");
  EXPECT_EQ(study.summary().locked, std::vector<std::string>{"devices.s2.at.y"});
  study.act("undo", "");
  EXPECT_TRUE(study.summary().locked.empty());
  study.act("undo", "");
  EXPECT_TRUE(study.scene() == before);
  EXPECT_EQ(study.summary().acts.size(), 4u);
  EXPECT_THROW(study.act("undo", ""), std::invalid_argument);
}

// Acts of rounds that have ended: what the act changed is as before, what searches have
// found since stays.
TEST(Study, UndoesActsOfEarlierRounds) {
  const Folder folder;
  Study study = begun(folder.path / "s");
  (void)study.run(one_thread());
  const Scene first = study.scene();
  study.act("set", "devices.s1.at.x=-0.3");
  study.act("lock", "devices.s1.at.x");
  study.act("keep", "{name: apart, spacing: 0.4, devices: \"*\"}");
  (void)study.run(one_thread());
  const Scene second = study.scene();
  ASSERT_EQ(second.devices[0].placement.at.x(), -0.3);
  ASSERT_NE(second.devices[1].placement.at, first.devices[1].placement.at);
  ASSERT_EQ(second.constraints.size(), 2u);

  study.act("undo", "");
  EXPECT_EQ(study.scene().constraints, first.constraints);
  EXPECT_EQ(study.scene().devices, second.devices);
  study.act("undo", "");
  EXPECT_TRUE(study.summary().locked.empty());
  EXPECT_EQ(study.scene().devices, second.devices);
  (void)study.run(one_thread());  // the journal goes on through rounds
  const Scene third = study.scene();
  study.act("undo", "");
  Scene moved = third;
  moved.devices[0].placement.at.x() = first.devices[0].placement.at.x();
  moved.devices[3].placement.at.x() = first.devices[3].placement.at.x();
  EXPECT_EQ(study.scene().devices, moved.devices);
  EXPECT_THROW(study.act("undo", ""), std::invalid_argument);
  // The journal replays to the same.
  EXPECT_TRUE(Study(folder.path / "s", plugins()).scene() == study.scene());
}

TEST(Study, UndoesAnExtensionUntilItIsSpent) {
  const Folder folder;
  Study study = begun(folder.path / "s");
  (void)study.run(one_thread());
  study.act("extend", "40");
  study.act("undo", "");
  (void)study.run(one_thread());
  EXPECT_GT(study.summary().rounds[1].evaluations, 60u);
  study.act("extend", "40");
  (void)study.run(one_thread());
  // And for each of two starts the first score and those of five stages' ends.
  EXPECT_LE(study.summary().rounds[2].evaluations, 40u + 12);
  EXPECT_THROW(study.act("undo", ""), std::invalid_argument);
}

// Acts after which nothing keeps all constraints: said, and mended by taking them back.
TEST(Study, GoesOnAfterAnActThatLeavesNoDesign) {
  const Folder folder;
  Study study = begun(folder.path / "s");
  (void)study.run(one_thread());
  study.act("forbid", "{sphere: {radius: 50}}");
  EXPECT_THROW((void)study.run(one_thread()), std::invalid_argument);
  EXPECT_THROW((void)study.run(one_thread()), std::invalid_argument);
  study.act("undo", "");
  const OptimizeResult found = study.run(one_thread());
  EXPECT_TRUE(found.best.feasible());
  const StudySummary summary = study.summary();
  ASSERT_EQ(summary.rounds.size(), 3u);
  EXPECT_TRUE(std::isnan(summary.rounds[1].best));
  EXPECT_LE(summary.rounds[2].best, summary.rounds[0].best);
}

TEST(Study, KeepsDropsForbidsAndInjects) {
  const Folder folder;
  Study study = begun(folder.path / "s");
  const auto names = [&] {
    std::vector<std::string> all;
    for (const ConstraintEntry& c : study.scene().constraints) all.push_back(c.name);
    return all;
  };
  using Names = std::vector<std::string>;
  study.act("keep", "{spacing: 30 cm, devices: \"s*\"}");
  EXPECT_EQ(names(), (Names{"budget", "spacing_1"}));
  study.act("drop", "budget");
  EXPECT_EQ(names(), Names{"spacing_1"});
  study.act("forbid", "{cylinder: {radius: 0.2, height: 3}, at: [0.5, 0.5, 0]}");
  study.act("forbid", "forbidden1");
  EXPECT_EQ(names(), (Names{"spacing_1", "forbidden1", "forbidden2"}));
  const auto& again = std::get<KeepInside>(study.scene().constraints.back().what);
  EXPECT_EQ(again.region, "forbidden1");
  EXPECT_TRUE(again.outside);
  EXPECT_EQ(again.devices.size(), 4u);
  study.act("inject", "devices.s1.at.x=0.1\ndevices.s2.at.z=1.1");
  EXPECT_EQ(study.scene().devices[0].placement.at.x(), 0.1);
  EXPECT_EQ(study.scene().devices[3].placement.at.x(), 0.4 - 0.1);  // mirrored
  EXPECT_EQ(study.scene().devices[2].placement.at.z(), 1.1);        // tied

  for (const auto& [verb, argument, says] :
       std::vector<std::tuple<const char*, const char*, const char*>>{
           {"keep", "{spacing: 30 cm}", "devices: missing for spacing"},
           {"keep", "{name: spacing_1, tilt: 0.1, devices: \"*\"}", "already"},
           {"drop", "budget", "there is no constraint 'budget'; there are spacing_1"},
           {"forbid", "{sphere: {radius: -1}}", "radius"},
           {"forbid", "there", "expected a region's name"},
           {"inject", "devices.s1.at.x=7", "the bounds of the variable are -0.4"},
           {"inject", "devices.s4.at.x=0", "expected VARIABLE=VALUE"}}) {
    try {
      study.act(verb, argument);
      ADD_FAILURE() << verb << " " << argument;
    } catch (const std::invalid_argument& refusal) {
      EXPECT_NE(std::string(refusal.what()).find(says), std::string::npos)
          << refusal.what();
    }
  }
  EXPECT_EQ(study.summary().acts.size(), 5u);
}

}  // namespace
}  // namespace delos::test
