#include "session/search_run.h"

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <utility>

#include "delos/scene/definition.h"
#include "delos/text/units.h"
#include "session/search_answer.h"

namespace delos::session {
namespace {

/// A hand that hasn't moved for so long rests.
constexpr std::chrono::milliseconds kRest{400};
constexpr std::chrono::milliseconds kGlance{20};

/// The file of a study, and what SQLite and the lock of its runs put beside it.
void remove_study(const std::filesystem::path& file) {
  for (const char* end : {"", "-wal", "-shm", ".lock"}) {
    std::error_code ignored;
    std::filesystem::remove(file.string() + end, ignored);
  }
}

/// A scene judged as those of a study are: with the guess and the fusion that it wrote
/// down, where nobody says another.
Scene judged_like(Scene scene, const Scene& study) {
  if (scene.objective.guess == 0) scene.objective.guess = study.objective.guess;
  return with_definition(std::move(scene));
}

/// A design as the act `inject` writes it.
std::string text_of(const VariableValues& design) {
  std::string text;
  for (std::size_t i = 0; i < design.paths.size(); ++i)
    text += (i > 0 ? "\n" : "") + design.paths[i] + '=' + shortest(design.values[i]);
  return text;
}

/// The values that a scene's variables have, or the bounds that they are beyond.
VariableValues within_bounds(const Scene& scene, PluginRegistry& plugins) {
  VariableValues all = values_of(scene, plugins);
  for (std::size_t i = 0; i < all.values.size(); ++i)
    all.values[i] =
        std::clamp(all.values[i], scene.variables[i].lower, scene.variables[i].upper);
  return all;
}

}  // namespace

SearchRun::SearchRun(std::filesystem::path file, bool kept, const Scene& scene,
                     const std::filesystem::path& folder, SearchWish wish,
                     PluginRegistry& plugins)
    : file_(std::move(file)), kept_(kept), wish_(std::move(wish)), plugins_(plugins) {
  const bool exists = std::filesystem::exists(file_);
  Study study = exists ? Study(file_, plugins)
                       : Study::create(file_, scene, folder, wish_.plan, plugins);
  try {
    for (const std::string& path : wish_.locked) study.act("lock", path);
    if (!wish_.locked.empty()) {
      // The round that has begun could change all: it ends, and nothing of it counts.
      study.act("inject", text_of(within_bounds(study.scene(), plugins_)));
      record_.part_from_rounds(study.summary().rounds.back().number);
    }
  } catch (...) {
    if (!exists) remove_study(file_);
    throw;
  }
  if (exists) recall(study);
  const Scene stands = study.scene();
  locked_ = study.summary().locked;
  objective_ = {{"name", objective_text(stands)}, {"unit", objective_unit(stands)}};
  sign_ = objective_shown(stands, 1);
}

/// What a study that is gone on with has looked at.
void SearchRun::recall(const Study& study) {
  for (const StudyRound& round : study.summary().rounds) {
    record_.begin_round(round.number, study.searched_scene(round.number), plugins_);
    for (const StudyEvaluation& evaluation : study.evaluations(round.number))
      record_.add(evaluation);
  }
}

SearchRun::~SearchRun() {
  if (!kept_) remove_study(file_);
}

void SearchRun::edited(Scene scene) {
  const std::lock_guard lock(mutex_);
  edited_ = std::move(scene);
  edited_at_ = Clock::now();
  judged_.reset();
  record_.part_from_rounds(record_.round());
  stop_ = true;
  tell();
}

void SearchRun::lock(const std::string& pattern, bool locked) {
  Study study(file_, plugins_);
  const auto shown = best();
  // By itself the round would go on from what is best on all samples, which may be
  // another design than the one that was looked at and locked.
  std::vector<StudyAct> acts{{0, 0, locked ? "lock" : "unlock", pattern}};
  if (shown) acts.push_back({0, 0, "inject", text_of(shown->values)});
  study.act(acts);
  const std::lock_guard hold(mutex_);
  locked_ = study.summary().locked;
  record_.part_from_rounds(record_.round());
  judged_.reset();
  tell();
}

void SearchRun::extend(int evaluations) {
  Study(file_, plugins_).act("extend", std::to_string(evaluations));
}

Scene SearchRun::scene() const { return Study(file_, plugins_).scene(); }

bool SearchRun::advance() {
  Study study(file_, plugins_);
  follow_hand(study);
  {
    const std::lock_guard lock(mutex_);
    if (edited_ || !wanted()) return false;
    since_ = Clock::now();
  }
  OptimizeOptions options;
  options.threads = wish_.threads;
  options.cancel = &stop_;
  options.progress = [&](const SearchProgress& at) {
    const std::lock_guard lock(mutex_);
    of_ = at.of;
  };
  const Study reader(file_, plugins_);
  try {
    take(study.run(options, [&](const StudyEvaluation& e) { hear(e, reader); }));
  } catch (...) {
    const std::lock_guard lock(mutex_);
    since_.reset();
    throw;
  }
  return !stop_;
}

/// Once the hand has rested, the study is changed into what it has made.
void SearchRun::follow_hand(Study& study) {
  std::optional<Scene> edited;
  for (; !edited; std::this_thread::sleep_for(kGlance)) {
    const std::lock_guard lock(mutex_);
    if (!edited_ || !wanted()) return;
    if (Clock::now() - edited_at_ < kRest) continue;
    edited.swap(edited_);
    stop_ = false;
  }
  const Scene stands = study.scene();
  std::vector<StudyAct> acts;
  for (const Override& change : changes_between(stands, judged_like(*edited, stands)))
    acts.push_back({0, 0, "set", change.path + "=" + change.value});
  study.act(acts);
}

void SearchRun::hear(const StudyEvaluation& evaluation, const Study& study) {
  const std::lock_guard lock(mutex_);
  if (evaluation.round != record_.round())
    record_.begin_round(evaluation.round, study.searched_scene(evaluation.round),
                        plugins_);
  record_.add(evaluation);
  const std::chrono::duration<double> worked = Clock::now() - *since_;
  if (wish_.seconds > 0 && worked.count() > wish_.seconds) give_over();
  tell();
}

void SearchRun::take(const OptimizeResult& result) {
  Json all = search_json(result, plugins_);
  const std::lock_guard lock(mutex_);
  worked_ += Clock::now() - *since_;
  since_.reset();
  result_ = Json::object();
  for (const char* key :
       {"initial", "best", "stop", "algorithm", "constraints", "messages"})
    result_[key] = std::move(all[key]);
  if (!edited_ && !record_.parted())
    judged_ = Best{record_.round(), values_of(result.scene, plugins_)};
  tell();
}

std::optional<SearchRun::Best> SearchRun::best() const {
  const std::lock_guard lock(mutex_);
  if (judged_ && !since_) return judged_;
  const SearchedDesign* best = record_.best();
  if (!best) return std::nullopt;
  return Best{best->round, record_.values(*best)};
}

VariableValues SearchRun::incumbent(std::size_t number) const {
  const std::lock_guard lock(mutex_);
  return record_.values(number);
}

Json SearchRun::json(const Heard& heard) const {
  const std::lock_guard lock(mutex_);
  Json json = head("search");
  const auto worked = since_ ? worked_ + (Clock::now() - *since_) : worked_;
  json["study"] = kept_ ? Json(file_.filename().string()) : Json();
  json["objective"] = objective_;
  json["locked"] = locked_;
  json["of"] = of_;
  json["best"] = record_.best() ? number(sign_ * record_.best()->objective) : Json();
  json["judged"] = judged_ && !since_;
  json["seconds"] = std::chrono::duration<double>(worked).count();
  json["result"] = result_;
  json.update(record_.json(heard, sign_));
  return json;
}

}  // namespace delos::session
