// Studies: what their files hold, and what happens where the disk is full.
#include "delos/optimize/study.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <tuple>

#include "optimizers/scenes.h"
#include "study/database.h"
#include "support/folder.h"

namespace delos::test {
namespace {

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
  Study study = begun(folder / "s");
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
  Study whole = begun(folder / "whole");
  (void)whole.run(one_thread());
  for (const std::size_t after : {1, 5, 8, 9, 10, 23, 47}) {
    Study part = begun(folder / ("part" + std::to_string(after)));
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
  Study whole = begun(folder / "whole");
  (void)whole.run(one_thread());
  int stopped = 0;
  for (const rlim_t room : {40'000, 60'000, 100'000}) {
    const std::filesystem::path file = folder / ("full" + std::to_string(room));
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
  Study study = begun(folder / "s");
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

TEST(Study, TakesActsTogetherOrNoneOfThem) {
  const Folder folder;
  Study study = begun(folder / "s");
  const Scene before = study.scene();
  EXPECT_THROW(study.act({{0, 0, "lock", "devices.s1.at.x"},
                          {0, 0, "set", "devices.nobody.at.x=1"}}),
               std::invalid_argument);
  EXPECT_TRUE(study.summary().acts.empty());
  EXPECT_TRUE(study.summary().locked.empty());
  // Each follows from those before it.
  study.act({{0, 0, "lock", "devices.s1.at.x"},
             {0, 0, "set", "devices.s1.at.x=-0.2"},
             {0, 0, "undo", ""}});
  EXPECT_EQ(study.summary().acts.size(), 3u);
  EXPECT_TRUE(study.scene() == before);
  EXPECT_EQ(study.summary().locked, std::vector<std::string>{"devices.s1.at.x"});
}

// Acts of rounds that have ended: what the act changed is as before, what searches have
// found since stays.
TEST(Study, UndoesActsOfEarlierRounds) {
  const Folder folder;
  Study study = begun(folder / "s");
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
  EXPECT_TRUE(Study(folder / "s", plugins()).scene() == study.scene());
}

TEST(Study, UndoesAnExtensionUntilItIsSpent) {
  const Folder folder;
  Study study = begun(folder / "s");
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
  Study study = begun(folder / "s");
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
  Study study = begun(folder / "s");
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
  const Scene now = study.scene();
  const auto& again = std::get<KeepInside>(now.constraints.back().what);
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

// ---- files that aren't as they were written ----

/// What a call refuses with; fails the test where it doesn't.
template <class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const std::runtime_error& failure) {
    return failure.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

/// A study that has come to its end, and changes to its file.
std::filesystem::path finished(const Folder& folder, const std::string& name,
                               const char* change = nullptr) {
  const std::filesystem::path file = folder / name;
  (void)begun(file).run(one_thread());
  if (change) Database(file, false).run(change);
  return file;
}

TEST(Study, RefusesListsOfOtherLengths) {
  const Folder folder;
  for (const char* change :
       {"UPDATE evaluations SET slacks = x''",
        "UPDATE evaluations SET slope = x'' WHERE length(slope) > 0",
        "UPDATE evaluations SET slope = zeroblob(8) WHERE slope IS NULL",
        "UPDATE evaluations SET slopes = x'0000000000000000' WHERE length(slopes) > "
        "0"}) {
    const auto file = finished(folder, "s", change);
    Study study(file, plugins());
    const std::string text = refusal([&] { (void)study.run(one_thread()); });
    EXPECT_NE(text.find("has lists of other lengths"), text.npos) << text;
    std::filesystem::remove(file);
  }
}

TEST(Study, RefusesDesignsThatNoSearchLookedAt) {
  const Folder folder;
  const auto file = finished(folder, "s");
  const Study study(file, plugins());
  const std::vector<StudyEvaluation> sound = study.evaluations(1);
  const auto with = [&](std::vector<double> x) {
    Database(file, false)
        .prepare("UPDATE evaluations SET x = ? WHERE start = 1 AND number = 3")
        .bind(1, std::span<const double>(x))
        .step();
    return refusal([&] { (void)study.evaluations(1); });
  };
  const auto at = std::find_if(
      sound.begin(), sound.end(),
      [](const StudyEvaluation& e) { return e.key.start == 1 && e.key.number == 3; });
  ASSERT_NE(at, sound.end());
  for (const double wrong : {-1e238, 1.5, -0.1, double{NAN}, double{INFINITY}}) {
    std::vector<double> x = at->x;
    x[1] = wrong;
    EXPECT_NE(with(x).find("evaluation 3 of start 1 of round 1 isn't a design"),
              std::string::npos)
        << wrong;
  }
  std::vector<double> shorter = at->x;
  shorter.pop_back();
  EXPECT_FALSE(with(shorter).empty());
  Database(file, false)
      .prepare("UPDATE evaluations SET x = ? WHERE start = 1 AND number = 3")
      .bind(1, std::span<const double>(at->x))
      .step();
  EXPECT_EQ(study.evaluations(1).size(), sound.size());
  Database(file, false).run("UPDATE evaluations SET slacks = x'' WHERE number = 3");
  EXPECT_FALSE(refusal([&] { (void)study.evaluations(1); }).empty());
}

TEST(Study, RefusesFactsThatAreNoNumbers) {
  const Folder folder;
  for (const char* name : {"seed", "starts", "evaluations", "samples"})
    for (const char* value : {"", "x", "3x", "-1", "99999999999999999999999"}) {
      const auto file = folder / (std::string(name) + '=' + value);
      const Study study = begun(file);
      Database(file, false)
          .prepare("UPDATE facts SET value = ? WHERE name = ?")
          .bind(1, std::string(value))
          .bind(2, std::string(name))
          .step();
      EXPECT_NE(refusal([&] { (void)study.summary(); })
                    .find("the study is damaged: its " + std::string(name) + " is '" +
                          value + "'"),
                std::string::npos);
    }
}

// Wherever within its last pages a file is cut.
TEST(Study, RefusesFilesThatAreCutShort) {
  const Folder folder;
  const auto file = finished(folder, "s");
  const auto size = std::filesystem::file_size(file);
  for (const std::uintmax_t cut : {1, 100, 700, 2048, 4000, 4095, 4096, 5000, 8192}) {
    const auto part = folder / "part";
    std::filesystem::copy_file(file, part,
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(part, size - cut);
    EXPECT_FALSE(refusal([&] { (void)Study(part, plugins()).dump(); }).empty()) << cut;
  }
}

// Two processes at the same moment: one begins the study, the other is told.
TEST(Study, IsBegunByOneOfTwo) {
  const Folder folder;
  const Scene scene = load("10-better-speakers");
  for (int round = 0; round < 20; ++round) {
    const std::filesystem::path file = folder / ("s" + std::to_string(round));
    int gate[2];
    ASSERT_EQ(pipe(gate), 0);
    pid_t children[2];
    for (pid_t& child : children) {
      child = fork();
      if (child != 0) continue;
      close(gate[1]);
      char byte = 0;
      (void)!read(gate[0], &byte, 1);  // until the parent closes it
      try {
        (void)Study::create(file, scene, DELOS_SCENES, kPlan, plugins());
        _exit(0);
      } catch (const std::runtime_error& failure) {
        const std::string text = failure.what();
        _exit(text.find("exists already") != text.npos ? 1 : 2);
      }
    }
    close(gate[0]);
    close(gate[1]);
    int codes = 0;
    for (const pid_t child : children) {
      int status = 0;
      waitpid(child, &status, 0);
      ASSERT_TRUE(WIFEXITED(status));
      EXPECT_LT(WEXITSTATUS(status), 2);
      codes += WEXITSTATUS(status);
    }
    EXPECT_EQ(codes, 1) << "one begins, one is told";
    EXPECT_EQ(Study(file, plugins()).summary().rounds.size(), 1u);
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().filename().string().find(".new"), std::string::npos);
}

// A file and a folder that nobody may write: looked at as ever, acts refused.
TEST(Study, CanBeLookedAtWhereNothingCanBeWritten) {
  const Folder folder;
  const auto file = finished(folder, "of 100 %?#");
  const std::string dump = Study(file, plugins()).dump();
  using std::filesystem::perms;
  const perms looks = perms::owner_read | perms::group_read | perms::others_read;
  const perms enters = perms::owner_exec | perms::group_exec | perms::others_exec;
  std::filesystem::permissions(file, looks);
  std::filesystem::permissions(folder.path(), looks | enters);
  const pid_t child = fork();
  if (child == 0) {
    // Permissions don't hold back the superuser.
    if (geteuid() == 0 && setresuid(65534, 65534, 65534) != 0) _exit(9);
    try {
      Study study(file, plugins());
      if (study.dump() != dump || study.evaluations(1).empty()) _exit(1);
      try {
        study.act("lock", "devices.s1.at.x");
        _exit(2);
      } catch (const std::runtime_error& failure) {
        const std::string text = failure.what();
        _exit(text.find("can't be written") != text.npos ? 0 : 3);
      }
    } catch (const std::exception& failure) {
      std::fprintf(stderr, "%s\n", failure.what());
      _exit(4);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  std::filesystem::permissions(folder.path(), perms::owner_all);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(Study, NoticesThatItsFileIsGone) {
  const Folder folder;
  for (const bool replaced : {false, true}) {
    const auto file = folder / "s";
    Study study = begun(file);
    std::size_t reached = 0;
    OptimizeOptions options = one_thread();
    options.progress = [&](const SearchProgress& at) {
      reached = at.evaluations;
      if (at.evaluations < 10 || !std::filesystem::exists(file)) return;
      std::filesystem::remove(file);
      if (replaced) std::ofstream(file) << "something else";
    };
    const std::string text = refusal([&] { (void)study.run(options); });
    EXPECT_NE(text.find("was deleted or replaced while it was searched"), text.npos);
    EXPECT_LT(reached, 15u);
    std::filesystem::remove(file);
  }
}

}  // namespace
}  // namespace delos::test
