// Studies: what their files hold, and what happens where the disk is full.
#include "delos/optimize/study.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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

}  // namespace
}  // namespace delos::test
