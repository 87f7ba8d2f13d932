// Searches by several processes, and by parts that are joined later: what one process
// finds alone is what they must find, to the last byte.
#include "delos/optimize/crew.h"

#include <barrier>
#include <functional>
#include <thread>

#include "delos/optimize/study.h"
#include "delos/optimize/tradeoff.h"
#include "optimizers/scenes.h"
#include "study/database.h"
#include "support/folder.h"

namespace delos::test {
namespace {

/// What the members of a crew share where they are threads of one process.
struct Room {
  explicit Room(std::size_t size)
      : barrier(static_cast<std::ptrdiff_t>(size)), said(size) {}
  std::barrier<> barrier;
  std::vector<std::string> said;
};

/// A member of a crew of threads: MPI's semantics without MPI.
class ThreadCrew final : public Crew {
 public:
  ThreadCrew(Room& room, std::size_t rank) : room_(room), rank_(rank) {}
  [[nodiscard]] std::size_t rank() const override { return rank_; }
  [[nodiscard]] std::size_t size() const override { return room_.said.size(); }
  [[nodiscard]] std::string host() const override { return "here"; }
  [[nodiscard]] std::vector<std::string> exchange(const std::string& said) override {
    room_.said[rank_] = said;
    room_.barrier.arrive_and_wait();
    std::vector<std::string> all = room_.said;
    room_.barrier.arrive_and_wait();
    bytes += said.size();
    return all;
  }
  std::size_t bytes = 0;

 private:
  Room& room_;
  std::size_t rank_;
};

/// Let rank 0 ask while the others serve.
void with_crew(std::size_t size, const std::function<void(Crew&)>& ask) {
  Room room(size);
  std::vector<std::thread> others;
  for (std::size_t rank = 1; rank < size; ++rank)
    others.emplace_back([&room, rank] {
      ThreadCrew crew(room, rank);
      PluginRegistry own({DELOS_PLUGINS});
      serve(crew, own, 1);
    });
  ThreadCrew first(room, 0);
  ask(first);
  dismiss(first);
  for (std::thread& other : others) other.join();
}

OptimizeOptions five_starts() {
  OptimizeOptions options;
  options.evaluations = 200;
  options.starts = 5;
  options.seed = 3;
  options.samples = 100;
  options.threads = 1;
  return options;
}

const StudyPlan kPlan = {.evaluations = 200, .starts = 5, .seed = 3, .samples = 100};

void expect_same(const OptimizeResult& a, const OptimizeResult& b) {
  EXPECT_EQ(a.best_x, b.best_x);
  EXPECT_EQ(a.best.objective, b.best.objective);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.gradient_evaluations, b.gradient_evaluations);
  EXPECT_EQ(a.stop, b.stop);
  EXPECT_EQ(a.best_field.value, b.best_field.value);
}

TEST(Crew, FindsWhatOneProcessFinds) {
  const Scene scene = load("10-better-speakers");
  const OptimizeResult alone = search(scene, five_starts());
  for (const std::size_t size : {1, 2, 3, 7}) {  // more than there are starts, too
    SCOPED_TRACE(size);
    with_crew(size, [&](Crew& crew) {
      OptimizeOptions options = five_starts();
      options.crew = &crew;
      expect_same(search(scene, options), alone);
      expect_same(search(scene, options),
                  alone);  // they serve until they are dismissed
    });
  }
}

TEST(Crew, DividesTheEvaluations) {
  std::vector<std::size_t> bytes;
  Room room(2);
  const Scene scene = load("10-better-speakers");
  std::thread other([&] {
    ThreadCrew crew(room, 1);
    PluginRegistry own({DELOS_PLUGINS});
    serve(crew, own, 1);
    bytes.push_back(crew.bytes);
  });
  ThreadCrew crew(room, 0);
  OptimizeOptions options = five_starts();
  options.crew = &crew;
  (void)search(scene, options);
  dismiss(crew);
  other.join();
  // Three of five starts, and two of the three that are finished, are rank 0's.
  EXPECT_GT(bytes.front(), crew.bytes / 4);
  EXPECT_LT(bytes.front(), crew.bytes);
}

TEST(Crew, FindsTheFrontThatOneProcessFinds) {
  const Scene scene = load("10-better-speakers");
  const std::string limit = scene.constraints.front().name;
  OptimizeOptions options = five_starts();
  Scene given = scene;
  const double level = constraint_limit(given, limit);
  const auto alone =
      search_front(scene, plugins(), limit, {level, 0.9 * level}, options);
  with_crew(3, [&](Crew& crew) {
    options.crew = &crew;
    const auto all =
        search_front(scene, plugins(), limit, {level, 0.9 * level}, options);
    ASSERT_EQ(all.size(), alone.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_EQ(all[k].objective, alone[k].objective);
      EXPECT_EQ(all[k].scene.devices, alone[k].scene.devices);
    }
  });
}

/// Rank 0 keeps all, whoever evaluated it; stopped, others go on from it in any number.
TEST(Crew, KeepsOneStudy) {
  const Folder folder;
  const Scene scene = load("10-better-speakers");
  Study alone = Study::create(folder / "alone", scene, DELOS_SCENES, kPlan, plugins());
  (void)alone.run(five_starts());
  Study study = Study::create(folder / "crew", scene, DELOS_SCENES, kPlan, plugins());
  std::atomic<bool> cancel = false;
  with_crew(3, [&](Crew& crew) {
    OptimizeOptions options = five_starts();
    options.crew = &crew;
    options.cancel = &cancel;
    options.progress = [&](const SearchProgress& at) { cancel = at.evaluations > 30; };
    EXPECT_EQ(study.run(options).stop, SearchStop::cancelled);
  });
  EXPECT_LT(study.evaluations(1).size(), alone.evaluations(1).size());
  std::size_t made = 0;
  with_crew(2, [&](Crew& crew) {
    OptimizeOptions options = five_starts();
    options.crew = &crew;
    options.progress = [&](const SearchProgress& at) { made = at.evaluations; };
    (void)study.run(options);
  });
  EXPECT_GT(made, 0u);
  EXPECT_EQ(study.dump(), alone.dump());
}

TEST(Crew, IsRefusedByOneSentence) {
  Scene scene = load("10-better-speakers");
  scene.variables.clear();
  const auto sentence = [&](const OptimizeOptions& options) {
    try {
      (void)search(scene, options);
    } catch (const std::invalid_argument& refusal) {
      return std::string(refusal.what());
    }
    return std::string();
  };
  const std::string alone = sentence(five_starts());
  EXPECT_FALSE(alone.empty());
  with_crew(2, [&](Crew& crew) {
    OptimizeOptions options = five_starts();
    options.crew = &crew;
    EXPECT_EQ(sentence(options), alone);
  });
}

TEST(Crew, TellsOfAnotherPlugin) {
  const Folder folder;
  Room room(2);
  std::string theirs;
  std::thread other([&] {
    ThreadCrew crew(room, 1);
    PluginRegistry own({folder / "empty"});
    try {
      serve(crew, own, 1);
    } catch (const std::runtime_error& failure) {
      theirs = failure.what();
    }
  });
  ThreadCrew crew(room, 0);
  OptimizeOptions options = five_starts();
  options.crew = &crew;
  std::string mine;
  try {
    (void)search(load("10-better-speakers"), options);
  } catch (const std::runtime_error& failure) {
    mine = failure.what();
  }
  EXPECT_TRUE(crew.abandoned());
  other.join();
  EXPECT_NE(mine.find("process 1 on here has another plugin 'acoustic_range'"),
            std::string::npos)
      << mine;
  EXPECT_EQ(theirs, mine);
}

Study part_of(const std::filesystem::path& file, std::size_t index, std::size_t of,
              StudyPlan plan = kPlan) {
  plan.part = {index, of};
  return Study::create(file, load("10-better-speakers"), DELOS_SCENES, plan, plugins());
}

TEST(Parts, AreTheWholeSearch) {
  const Folder folder;
  Study whole = Study::create(folder / "whole", load("10-better-speakers"),
                              DELOS_SCENES, kPlan, plugins());
  const OptimizeResult alone = whole.run(five_starts());
  std::vector<std::filesystem::path> files;
  std::size_t most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    files.push_back(folder / ("part" + std::to_string(k)));
    Study part = part_of(files.back(), k, 3);
    (void)part.run(five_starts());
    most = std::max(most, part.evaluations(1).size());
  }
  EXPECT_LT(most, whole.evaluations(1).size());
  std::swap(files[0], files[2]);  // in any order
  Study merged = Study::merge(folder / "merged", files, plugins());
  expect_same(merged.run(five_starts()), alone);
  EXPECT_EQ(merged.dump(), whole.dump());
  // It is a study as any other, without its parts.
  Study again(folder / "merged", plugins());
  expect_same(again.run(five_starts()), alone);
}

TEST(Parts, ThatDontFitAreNamed) {
  const Folder folder;
  (void)part_of(folder / "one", 0, 3);
  (void)part_of(folder / "two", 1, 3);
  StudyPlan other = kPlan;
  other.version = "0.0.7";
  (void)part_of(folder / "old", 2, 3, other);
  other = kPlan;
  other.seed = 4;
  (void)part_of(folder / "seed", 2, 3, other);
  (void)Study::create(folder / "whole", load("10-better-speakers"), DELOS_SCENES, kPlan,
                      plugins());
  const auto refusal = [&](const std::vector<std::string>& names) {
    std::vector<std::filesystem::path> files;
    for (const std::string& name : names) files.push_back(folder / name);
    try {
      (void)Study::merge(folder / "merged", files, plugins());
    } catch (const std::invalid_argument& no) {
      return std::string(no.what());
    }
    return std::string("merged");
  };
  const auto says = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                                : testing::AssertionFailure() << text;
  };
  EXPECT_TRUE(says(refusal({"one", "two"}), "the part 3/3 is missing"));
  EXPECT_TRUE(says(refusal({"one", "two", "two"}), "are the same part"));
  EXPECT_TRUE(says(refusal({"one", "two", "old"}), "old was begun by version 0.0.7"));
  EXPECT_TRUE(
      says(refusal({"one", "two", "seed"}), "seed is a part of another search"));
  EXPECT_TRUE(says(refusal({"one", "whole"}), "whole isn't a part"));
  EXPECT_FALSE(std::filesystem::exists(folder / "merged"));
}

/// What is read again is data: a part that can't be one isn't taken for an index.
TEST(Parts, ThatAreDamagedAreRefused) {
  const Folder folder;
  (void)part_of(folder / "one", 0, 2);
  (void)part_of(folder / "two", 1, 2);
  Database(folder / "two", false)
      .run("UPDATE facts SET value = '7' WHERE name = 'part'");
  EXPECT_THROW((void)Study::merge(folder / "merged", {folder / "one", folder / "two"},
                                  plugins()),
               std::runtime_error);
}

}  // namespace
}  // namespace delos::test
