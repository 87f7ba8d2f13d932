#include "delos/optimize/study.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "delos/scene/io.h"
#include "delos/text/units.h"
#include "study/acts.h"
#include "study/database.h"
#include "study/journal.h"
#include "study/ledger.h"
#include "study/parts.h"
#include "study/run_lock.h"
#include "study/telling_ledger.h"

namespace delos {
namespace {

constexpr const char* kStudyTables = R"(
CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE rounds (
  number INTEGER PRIMARY KEY, scene TEXT NOT NULL, locked TEXT NOT NULL,
  acts INTEGER NOT NULL, evaluations INTEGER NOT NULL,
  ended INTEGER NOT NULL DEFAULT 0, best_scene TEXT, initial REAL, best REAL);
CREATE TABLE evaluations (
  round INTEGER, start INTEGER, number INTEGER, x BLOB NOT NULL, width REAL NOT NULL,
  objective REAL NOT NULL, slacks BLOB, slope BLOB, slopes BLOB,
  PRIMARY KEY (round, start, number)) WITHOUT ROWID;
CREATE TABLE acts (
  number INTEGER PRIMARY KEY, after_round INTEGER NOT NULL, verb TEXT NOT NULL,
  argument TEXT NOT NULL);
)";
constexpr const char* kFormat = "delos study 1";

/// Whether a search can have looked there.
bool in_unit_interval(double x) { return x >= -1e-6 && x <= 1 + 1e-6; }

}  // namespace

struct Study::State {
  State(const std::filesystem::path& path, bool create, PluginRegistry& registry)
      : file(path), database(path, create), plugins(registry) {
    stat(file.c_str(), &identity);
  }

  std::filesystem::path file;
  struct stat identity {};
  Database database;
  PluginRegistry& plugins;
  std::vector<std::unique_ptr<State>> parts;  ///< whose evaluations are recalled

  [[nodiscard]] std::string fact(const std::string& name) const {
    Statement s = database.prepare("SELECT value FROM facts WHERE name = ?");
    s.bind(1, name);
    return s.step() ? s.text(0) : std::string();
  }
  [[noreturn]] void damaged(const std::string& what) const {
    throw std::runtime_error(file.string() + ": the study is damaged: " + what);
  }
  /// A fact that is a whole number, ≥ 0.
  template <class Number>
  [[nodiscard]] Number whole_fact(const std::string& name) const {
    const std::string text = fact(name);
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [at, problem] = std::from_chars(text.data(), end, value);
    if (problem != std::errc() || at != end || value < Number{0})
      damaged("its " + name + " is '" + text + "', not a whole number");
    return value;
  }
  void set_fact(const std::string& name, const std::string& value) {
    database.prepare("INSERT INTO facts VALUES (?, ?)")
        .bind(1, name)
        .bind(2, value)
        .step();
  }

  [[nodiscard]] StudyPlan plan() const {
    StudyPlan plan;
    plan.algorithm = fact("algorithm");
    plan.starts = whole_fact<int>("starts");
    plan.evaluations = whole_fact<int>("evaluations");
    plan.seed = whole_fact<std::uint64_t>("seed");
    plan.samples = whole_fact<std::size_t>("samples");
    plan.version = fact("version");
    if (!fact("parts").empty())
      plan.part = {whole_fact<std::size_t>("part"), whole_fact<std::size_t>("parts")};
    if (plan.part.index >= plan.part.of)
      damaged("it is part " + fact("part") + " of " + fact("parts") + ", from 0");
    return plan;
  }

  [[nodiscard]] Scene parsed(const std::string& text) const {
    Diagnostics findings;
    const std::filesystem::path place =
        std::filesystem::path(fact("folder")) / "scene.yaml";
    auto scene = parse_scene(text, place, {}, plugins, findings);
    if (!scene)
      throw std::runtime_error(file.string() + ": " + to_string(findings.front()));
    return *scene;
  }

  [[nodiscard]] int last_round() const {
    Statement s = database.prepare("SELECT max(number) FROM rounds");
    s.step();
    return static_cast<int>(s.integer(0));
  }
  [[nodiscard]] int acts_so_far() const {
    Statement s = database.prepare("SELECT coalesce(max(number), 0) FROM acts");
    s.step();
    return static_cast<int>(s.integer(0));
  }

  /// A round as it began, and where it got.
  struct Round {
    StudyPosition position;
    int acts = 0, evaluations = 0;
    bool ended = false;
    std::string best_scene;
  };
  [[nodiscard]] Round round(int number) const {
    Statement s = database.prepare(
        "SELECT scene, locked, acts, evaluations, ended, best_scene FROM rounds "
        "WHERE number = ?");
    s.bind(1, std::int64_t{number});
    if (!s.step())
      throw std::invalid_argument("there is no round " + std::to_string(number));
    Round round;
    round.position.scene = parsed(s.text(0));
    round.position.locked = lines_of(s.text(1));
    round.acts = static_cast<int>(s.integer(2));
    round.evaluations = static_cast<int>(s.integer(3));
    round.ended = s.integer(4) != 0;
    round.best_scene = s.text(5);
    return round;
  }
  void begin_round(int number, const StudyPosition& position, int acts,
                   int evaluations) {
    database
        .prepare(
            "INSERT INTO rounds (number, scene, locked, acts, evaluations) "
            "VALUES (?, ?, ?, ?, ?)")
        .bind(1, std::int64_t{number})
        .bind(2, write_scene(position.scene))
        .bind(3, text_of(position.locked))
        .bind(4, std::int64_t{acts})
        .bind(5, std::int64_t{evaluations})
        .step();
  }

  [[nodiscard]] std::vector<StudyAct> acts_from(int number) const {
    Statement s = database.prepare(
        "SELECT number, after_round, verb, argument FROM acts WHERE number > ? "
        "ORDER BY number");
    s.bind(1, std::int64_t{number});
    std::vector<StudyAct> acts;
    while (s.step())
      acts.push_back({static_cast<int>(s.integer(0)), static_cast<int>(s.integer(1)),
                      s.text(2), s.text(3)});
    return acts;
  }

  /// The journal up to now.
  /// @param verb of an act to come: what may be undone needs all rounds, else the last
  ///             one says where the study stands
  [[nodiscard]] Journal journal(const std::string& verb = {}) const {
    Journal journal(fact("folder"), plugins);
    const int last = last_round();
    const std::vector<StudyAct> all = acts_from(0);
    const bool whole =
        verb == "undo" || std::any_of(all.begin(), all.end(), [](const StudyAct& act) {
          return act.verb == "undo";
        });
    Round at = round(whole ? 1 : last);
    for (int r = whole ? 1 : last; r <= last; ++r) {
      if (at.ended) at.position.scene = parsed(at.best_scene);
      journal.arrive(std::move(at.position));
      const int begin = at.acts;
      int end = std::numeric_limits<int>::max();
      if (r < last) {
        at = round(r + 1);
        end = at.acts;
      }
      for (const StudyAct& act : all)
        if (act.number > begin && act.number <= end) journal.act(act);
    }
    return journal;
  }
  [[nodiscard]] StudyPosition position() const { return journal().position(); }

  /// @throws std::runtime_error somebody has deleted or replaced the file: what is
  ///         written to it is lost
  void check_there() const {
    struct stat now {};
    if (stat(file.c_str(), &now) == 0 && now.st_ino == identity.st_ino &&
        now.st_dev == identity.st_dev)
      return;
    throw std::runtime_error(file.string() +
                             " was deleted or replaced while it was searched; begin "
                             "another study");
  }

  [[nodiscard]] bool asked_to_stop(const OptimizeOptions& options) const {
    return (options.cancel && options.cancel->load()) || !fact("pause").empty();
  }
  bool begin_next_round();
  void end_round(int number, const std::string& best_scene,
                 std::optional<double> initial, std::optional<double> best);
  OptimizeResult run_round(int number, const OptimizeOptions& options,
                           const Told& told);
};

Study::Study(Study&&) noexcept = default;
Study::~Study() = default;

Study Study::create(const std::filesystem::path& file, const Scene& scene,
                    const std::filesystem::path& folder, const StudyPlan& plan,
                    PluginRegistry& plugins) {
  const auto exists = [&] {
    return std::runtime_error(file.string() +
                              " exists already; resume it, or choose another name");
  };
  if (std::filesystem::exists(file)) throw exists();
  // Made under another name, of this process alone, so that a study is whole or isn't
  // there.
  const std::filesystem::path unborn =
      file.string() + ".new-" + std::to_string(getpid());
  std::filesystem::remove(unborn);
  {
    State state(unborn, true, plugins);
    state.database.run("BEGIN IMMEDIATE");
    state.database.run(kStudyTables);
    state.set_fact("format", kFormat);
    // A scene in the current folder has "" for its own.
    state.set_fact("folder", std::filesystem::absolute(folder.empty() ? "." : folder)
                                 .lexically_normal()
                                 .string());
    state.set_fact("algorithm", plan.algorithm);
    state.set_fact("evaluations", std::to_string(plan.evaluations));
    state.set_fact("starts", std::to_string(plan.starts));
    state.set_fact("seed", std::to_string(plan.seed));
    state.set_fact("samples", std::to_string(plan.samples));
    state.set_fact("version", plan.version);
    if (plan.part.of > 1) {
      state.set_fact("part", std::to_string(plan.part.index));
      state.set_fact("parts", std::to_string(plan.part.of));
    }
    state.begin_round(1, {with_guess(scene, plugins), {}}, 0, plan.evaluations);
    state.database.run("COMMIT");
  }
  if (!publish(unborn, file)) throw exists();
  return Study(file, plugins);
}

Study::Study(const std::filesystem::path& file, PluginRegistry& plugins) {
  if (!std::filesystem::is_regular_file(file))
    throw std::runtime_error("there is no study " + file.string());
  state_ = std::make_unique<State>(file, false, plugins);
  std::string format;
  try {
    format = state_->fact("format");
  } catch (const std::runtime_error&) {
    // Some other file, or a database of somebody else.
  }
  if (format != kFormat)
    throw std::runtime_error(file.string() + " isn't a study that this version reads");
  state_->database.check_whole();
}

Study Study::merge(const std::filesystem::path& file,
                   const std::vector<std::filesystem::path>& parts,
                   PluginRegistry& plugins) {
  std::vector<Study> all;
  for (const auto& part : parts) all.emplace_back(part, plugins);
  check_parts(parts, all);
  StudyPlan whole = all.front().summary().plan;
  whole.part = {};
  Study merged =
      create(file, all.front().scene(0), all.front().folder(), whole, plugins);
  for (Study& part : all) merged.state_->parts.push_back(std::move(part.state_));
  return merged;
}

StudySummary Study::summary() const {
  const State& s = *state_;
  StudySummary all;
  all.plan = s.plan();
  Statement rounds = s.database.prepare(
      "SELECT number, ended, initial, best, (SELECT count(*) FROM evaluations e WHERE "
      "e.round = r.number) FROM rounds r ORDER BY number");
  while (rounds.step())
    all.rounds.push_back({static_cast<int>(rounds.integer(0)), rounds.integer(1) != 0,
                          static_cast<std::size_t>(rounds.integer(4)), rounds.real(2),
                          rounds.real(3)});
  const State::Round last = s.round(s.last_round());
  all.scene = last.position.scene.name;
  all.acts = s.acts_from(0);
  all.waiting = s.acts_from(last.acts);
  all.locked = s.position().locked;
  return all;
}

Scene Study::scene(int round) const {
  const State& s = *state_;
  if (round < 0) return s.position().scene;
  const State::Round at = s.round(std::max(round, 1));
  return round > 0 && at.ended ? s.parsed(at.best_scene) : at.position.scene;
}

Scene Study::searched_scene(int round) const {
  const State& s = *state_;
  StudyPosition began = s.round(round < 0 ? s.last_round() : round).position;
  remove_locked(began.scene, began.locked);
  return std::move(began.scene);
}

std::vector<StudyEvaluation> Study::evaluations(int round) const {
  Statement s = state_->database.prepare(
      "SELECT start, number, width, objective, slacks, x FROM evaluations WHERE round "
      "= ? ORDER BY start, number");
  s.bind(1, std::int64_t{round});
  std::vector<StudyEvaluation> all;
  std::optional<std::size_t> variables, limits;
  while (s.step()) {
    const Score score{s.real(3), s.numbers(4)};
    all.push_back({round,
                   {static_cast<int>(s.integer(0)), static_cast<int>(s.integer(1))},
                   s.real(2),
                   score.objective,
                   score.feasible(),
                   s.numbers(5)});
    const StudyEvaluation& e = all.back();
    if (!variables) variables = searched_scene(round).variables.size();
    if (!limits) limits = score.slacks.size();
    if (e.x.size() != *variables || score.slacks.size() != *limits ||
        !std::all_of(e.x.begin(), e.x.end(), in_unit_interval) ||
        std::isnan(e.objective))
      state_->damaged("evaluation " + std::to_string(e.key.number) + " of start " +
                      std::to_string(e.key.start) + " of round " +
                      std::to_string(round) + " isn't a design of its variables");
  }
  return all;
}

void Study::act(const std::string& verb, const std::string& argument) {
  act({{0, 0, verb, argument}});
}

void Study::act(const std::vector<StudyAct>& acts) {
  State& s = *state_;
  s.database.run("BEGIN IMMEDIATE");
  try {
    for (const StudyAct& asked : acts) {
      // Tried before it is journalled.
      const int number = s.acts_so_far() + 1, after = s.last_round();
      s.journal(asked.verb).act({number, after, asked.verb, asked.argument});
      s.database.prepare("INSERT INTO acts VALUES (?, ?, ?, ?)")
          .bind(1, std::int64_t{number})
          .bind(2, std::int64_t{after})
          .bind(3, asked.verb)
          .bind(4, asked.argument)
          .step();
    }
    s.database.run("COMMIT");
  } catch (...) {
    s.database.run("ROLLBACK");
    throw;
  }
}

void Study::pause() {
  state_->database.run("INSERT OR REPLACE INTO facts VALUES ('pause', 'asked')");
}

std::filesystem::path Study::folder() const { return state_->fact("folder"); }

OptimizeResult Study::State::run_round(int number, const OptimizeOptions& options,
                                       const Told& told) {
  const Round at = round(number);
  const StudyPlan of_study = plan();
  std::atomic<bool> stop = false;
  DatabaseLedger ledger(database, number, [&] {
    check_there();
    if (acts_so_far() > at.acts || asked_to_stop(options)) stop = true;
  });
  PartsLedger whole(ledger);
  for (const auto& part : parts) whole.add(part->database, number);
  OptimizeOptions search = options;
  search.parts = of_study.part;
  search.algorithm = of_study.algorithm;
  search.starts = of_study.starts;
  search.evaluations = at.evaluations;
  search.seed = of_study.seed;
  search.samples = of_study.samples;
  search.cancel = &stop;
  TellingLedger telling(whole, number, told);
  search.ledger = told ? static_cast<EvaluationLedger*>(&telling) : &whole;
  Scene active = at.position.scene;
  remove_locked(active, at.position.locked);
  OptimizeResult result = optimize(active, plugins, search);
  // Locked variables stand in the scene again.
  result.scene.variables = at.position.scene.variables;

  if (asked_to_stop(options) && acts_so_far() <= at.acts) return result;
  end_round(number, write_scene(result.scene), result.initial.objective,
            result.best.objective);
  return result;
}

/// Acts that come after it was looked hold for the round after the next.
/// @returns whether there were acts since the last round, which has ended
bool Study::State::begin_next_round() {
  database.run("BEGIN IMMEDIATE");
  try {
    const int number = last_round();
    const Round last = round(number);
    const std::vector<StudyAct> acts = acts_from(last.acts);
    const bool begins = last.ended && !acts.empty();
    if (begins) {
      StudyPosition now = position();
      const int evaluations =
          now.evaluations > 0 ? now.evaluations : plan().evaluations;
      begin_round(number + 1, now, acts.back().number, evaluations);
    }
    database.run("COMMIT");
    return begins;
  } catch (...) {
    database.run("ROLLBACK");
    throw;
  }
}

void Study::State::end_round(int number, const std::string& best_scene,
                             std::optional<double> initial,
                             std::optional<double> best) {
  Statement s = database.prepare(
      "UPDATE rounds SET ended = 1, best_scene = ?, initial = ?, best = ? WHERE "
      "number = ?");
  s.bind(1, best_scene).bind(4, std::int64_t{number});
  if (initial) s.bind(2, *initial);
  if (best) s.bind(3, *best);
  s.step();
}

OptimizeResult Study::run(const OptimizeOptions& options, const Told& told) {
  State& s = *state_;
  const RunLock lock(s.file);
  s.database.run("DELETE FROM facts WHERE name = 'pause'");
  for (;;) {
    if (s.begin_next_round()) continue;
    const int number = s.last_round();
    const State::Round last = s.round(number);
    try {
      // A round that has ended is run again from what is remembered of it.
      OptimizeResult result = s.run_round(number, options, told);
      s.check_there();
      if (s.asked_to_stop(options) || s.acts_from(last.acts).empty()) return result;
    } catch (const std::invalid_argument&) {
      // Nothing can be searched here. Acts that came since may mend that.
      if (s.acts_from(last.acts).empty()) throw;
      s.end_round(number, write_scene(last.position.scene), {}, {});
    }
  }
}

std::string Study::dump() const {
  const State& s = *state_;
  std::ostringstream out;
  Statement facts = s.database.prepare(
      "SELECT name, value FROM facts WHERE name NOT IN ('folder', 'pause') ORDER BY "
      "name");
  while (facts.step()) out << facts.text(0) << ": " << facts.text(1) << "\n";
  const auto list = [&](const std::vector<double>& numbers) {
    out << " [";
    for (std::size_t i = 0; i < numbers.size(); ++i)
      out << (i > 0 ? " " : "") << shortest(numbers[i]);
    out << "]";
  };
  Statement rounds = s.database.prepare(
      "SELECT number, locked, acts, ended, scene, best_scene, initial, best FROM "
      "rounds "
      "ORDER BY number");
  while (rounds.step()) {
    out << "round " << rounds.integer(0) << " locked [" << rounds.text(1) << "] acts "
        << rounds.integer(2) << " ended " << rounds.integer(3) << " initial "
        << shortest(rounds.real(6)) << " best " << shortest(rounds.real(7)) << "\n"
        << rounds.text(4) << "best:\n"
        << rounds.text(5);
  }
  for (const StudyAct& act : s.acts_from(0))
    out << "act " << act.number << " after " << act.after_round << ": " << act.verb
        << " " << act.argument << "\n";
  Statement evaluations = s.database.prepare(
      "SELECT round, start, number, width, objective, x, slacks, slope, slopes FROM "
      "evaluations ORDER BY round, start, number");
  while (evaluations.step()) {
    out << evaluations.integer(0) << "." << evaluations.integer(1) << "."
        << evaluations.integer(2) << " width " << shortest(evaluations.real(3)) << " "
        << shortest(evaluations.real(4));
    for (int column = 5; column < 9; ++column) list(evaluations.numbers(column));
    out << "\n";
  }
  return out.str();
}

}  // namespace delos
