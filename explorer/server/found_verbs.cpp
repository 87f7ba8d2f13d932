#include <algorithm>
#include <stdexcept>

#include "server/request.h"
#include "server/search_request.h"
#include "session/front_run.h"
#include "session/selection_run.h"
#include "session/term_values.h"

namespace delos::server {
namespace {

using session::SearchRun;

const Scene& scene_of_design(const Work& work) {
  return work.visitor.design.loaded().scene;
}

bool is_at_work(const session::Job& job) {
  const session::Phase phase = job.phase();
  return phase == session::Phase::running || phase == session::Phase::waiting;
}

/// The design with the best values so far.
std::optional<Reply> follow(const Work& work, Searched& searched) {
  const auto best = run_of(searched).best();
  if (!best) return std::nullopt;
  const Scene& scene = scene_of_design(work);
  return take_over(work, searched,
                   session::changes_between(
                       scene, session::with_values(scene, best->values, work.plugins)));
}

/// The values of those variables that there still are.
session::VariableValues still_there(const session::VariableValues& all,
                                    const Scene& scene) {
  session::VariableValues some;
  for (std::size_t i = 0; i < all.paths.size(); ++i) {
    if (std::none_of(scene.variables.begin(), scene.variables.end(),
                     [&](const VariableEntry& v) { return v.path == all.paths[i]; }))
      continue;
    some.paths.push_back(all.paths[i]);
    some.values.push_back(all.values[i]);
  }
  return some;
}

}  // namespace

Searched& now(const Work& work) {
  Searched* searched = work.visitor.searches.now();
  if (!searched) throw BadRequest("nothing is searched for");
  return *searched;
}

SearchRun& run_of(Searched& searched) {
  auto* run = dynamic_cast<SearchRun*>(searched.job.get());
  if (!run) throw BadRequest("this is no search for values of variables");
  return *run;
}

/// Take over what a search has found: a step of the design, or a part of one. The
/// search isn't told, since it knows.
std::optional<Reply> take_over(const Work& work, Searched& searched,
                               std::vector<Override> changes) {
  if (changes.empty()) return std::nullopt;
  Visitor& visitor = work.visitor;
  Diagnostics findings;
  if (!visitor.design.change(std::move(changes), searched.gesture(), work.plugins,
                             findings))
    return refusal(Status::unprocessable,
                   findings.empty() ? "" : findings.front().message, findings);
  ++visitor.revision;
  searched.step = visitor.design.history().steps();
  return std::nullopt;
}

void tell_search(Visitor& visitor) {
  Searched* searched = visitor.searches.now();
  auto* run = searched ? dynamic_cast<SearchRun*>(searched->job.get()) : nullptr;
  if (!run) return;
  ++searched->kept;  // what is found from here on is a step of its own
  run->edited(visitor.design.loaded().scene);
}

/// {}: the design is the best so far
Reply search_follow(const Work& work) {
  return follow(work, now(work))
      .value_or(json_reply(described(work.visitor, work.plugins)));
}

/// {}: it stays
Reply search_accept(const Work& work) {
  Searched& searched = now(work);
  if (is_at_work(*searched.job)) throw BadRequest("stop the search first");
  if (const auto* selection =
          dynamic_cast<const session::SelectionRun*>(searched.job.get())) {
    auto refused = take_over(work, searched, selection->changes());
    if (refused) return *std::move(refused);
  } else if (auto refused = follow(work, searched)) {
    return *std::move(refused);
  }
  ++searched.kept;
  return json_reply(described(work.visitor, work.plugins));
}

/// {}: the variables are again what they were when the search began
Reply search_reject(const Work& work) {
  Searched& searched = now(work);
  searched.job->pause();
  Visitor& visitor = work.visitor;
  const Scene& scene = scene_of_design(work);
  const std::vector<Override> back = session::changes_between(
      scene,
      session::with_values(scene, still_there(searched.before, scene), work.plugins));
  if (back.empty()) return json_reply(described(visitor, work.plugins));
  // Where nothing was done since, that is undoing it.
  if (searched.kept > 0 || searched.step != visitor.design.history().steps())
    return changed(work, back, "");
  visitor.design.undo(work.plugins);
  ++visitor.revision;
  tell_search(visitor);
  return json_reply(described(visitor, work.plugins));
}

/// {search, incumbents: [number]}: what each term of the objective is worth of them
Reply terms(const Work& work) {
  constexpr std::size_t kMostDesigns = 100, kSamples = 1500;
  Searched* searched = work.visitor.searches.find(
      static_cast<int>(number_or(work.request, "search", 0, 1e9)));
  if (!searched) throw BadRequest("there is no such search any more");
  const Json& asked = member(work.request, "incumbents");
  if (!asked.is_array() || asked.empty() || asked.size() > kMostDesigns)
    throw BadRequest("'incumbents' must be a list of 1 to 100 numbers");
  std::vector<session::VariableValues> designs;
  for (const Json& one : asked) {
    if (!one.is_number_unsigned())
      throw BadRequest("'incumbents' must be a list of 1 to 100 numbers");
    designs.push_back(run_of(*searched).incumbent(one.get<std::size_t>()));
  }
  Json json = session::term_values(scene_of_design(work), designs, kSamples,
                                   work.threads, work.stop, work.plugins);
  if (*work.stop) return refusal(Status::conflict, "a newer request took its place");
  return json_reply(json);
}

/// {search, incumbent} or {search, point}, by number: that design, as a step
Reply search_reinstate(const Work& work) {
  Searched* searched = work.visitor.searches.find(
      static_cast<int>(number_or(work.request, "search", 0, 1e9)));
  if (!searched) throw BadRequest("there is no such search any more");
  const auto index = [&](const char* key) {
    return static_cast<std::size_t>(number_or(work.request, key, 0, 1e9));
  };
  const auto* front = dynamic_cast<const session::FrontRun*>(searched->job.get());
  const session::VariableValues values =
      front ? front->point(index("point"))
            : run_of(*searched).incumbent(index("incumbent"));
  const Scene& scene = scene_of_design(work);
  const std::vector<Override> changes = session::changes_between(
      scene, session::with_values(scene, values, work.plugins));
  if (changes.empty()) return json_reply(described(work.visitor, work.plugins));
  return changed(work, changes, "");
}

}  // namespace delos::server
