#include <cmath>

#include "server/request.h"
#include "server/search_request.h"
#include "session/front_run.h"
#include "session/search_run.h"
#include "session/search_task.h"
#include "session/selection_run.h"

namespace delos::server {
namespace {

using session::Job;
using session::SearchRun;

constexpr double kMostLevels = 50, kMostSeconds = 1e6, kMostEvaluations = 1e8;

const session::LoadedScene& scene_of(const Work& work) {
  return work.visitor.design.loaded();
}

std::vector<std::string> texts_at(const Json& request, const char* key) {
  std::vector<std::string> texts;
  if (!request.contains(key)) return texts;
  for (const Json& one : request[key]) {
    if (!one.is_string())
      throw BadRequest("'" + std::string(key) + "' must be a list of texts");
    texts.push_back(one.get<std::string>());
  }
  return texts;
}

std::optional<std::string> text_if_there(const Json& request, const char* key) {
  return request.contains(key) ? std::optional(text_at(request, key)) : std::nullopt;
}

/// The study that a request names, beside the scene and nowhere else; else one that
/// goes. @throws BadRequest
std::pair<std::filesystem::path, bool> study_of(const Work& work) {
  const std::string name = text_or_empty(work.request, "study");
  if (name.empty()) return {work.place.unnamed(), false};
  constexpr const char* kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  if (name.find_first_not_of(kAllowed) != std::string::npos || name.front() == '.' ||
      !name.ends_with(".study"))
    throw BadRequest(
        "'study' must be a name such as room.study: letters, digits, _, - and ., and "
        ".study at its end; it stands beside the scene");
  return {work.visitor.design.file().parent_path() / name, true};
}

Reply told(const Searched& searched) {
  return json_reply(searched_json(searched.number, *searched.job));
}

Reply begun(const Work& work, std::shared_ptr<Job> job) {
  const Searched& searched = work.visitor.searches.begin(
      job, session::values_of(scene_of(work).scene, work.plugins));
  work.place.launch(std::move(job));
  return told(searched);
}

StudyPlan plan_of(const Json& request) {
  StudyPlan plan;
  if (request.contains("algorithm")) plan.algorithm = text_at(request, "algorithm");
  plan.evaluations =
      static_cast<int>(number_or(request, "evaluations", 0, kMostEvaluations));
  plan.starts = static_cast<int>(number_or(request, "starts", 0, 10000));
  plan.seed = static_cast<std::uint64_t>(number_or(request, "seed", 1, 1e9));
  plan.samples = static_cast<std::size_t>(number_or(request, "samples", 1500, 1e6, 1));
  return plan;
}

}  // namespace

/// {}
Reply task(const Work& work) {
  Json json = session::search_task(scene_of(work), work.plugins);
  json["revision"] = work.visitor.revision;
  return json_reply(json);
}

/// {path, lower, upper}: quantities, as scenes write them
Reply vary(const Work& work) {
  return changed(work,
                 session::varying(scene_of(work), text_at(work.request, "path"),
                                  text_if_there(work.request, "lower"),
                                  text_if_there(work.request, "upper"), work.plugins),
                 "");
}

/// {path}
Reply fix(const Work& work) {
  return changed(
      work,
      session::fixing(scene_of(work), text_at(work.request, "path"), work.plugins), "");
}

/// {}
Reply searches(const Work& work) {
  Json list = Json::array();
  for (const Searched& one : work.visitor.searches.all())
    list.push_back(searched_json(one.number, *one.job));
  return json_reply({{"searches", list}});
}

/// {evaluations, seconds, starts, seed, samples, algorithm, locked: [path], study}
Reply search_start(const Work& work) {
  const auto [file, kept] = study_of(work);
  session::SearchWish wish{plan_of(work.request),
                           number_or(work.request, "seconds", 0, kMostSeconds),
                           work.threads, texts_at(work.request, "locked")};
  const bool goes_on = std::filesystem::exists(file);
  std::shared_ptr<SearchRun> run;
  try {
    run = std::make_shared<SearchRun>(file, kept, scene_of(work).scene,
                                      work.visitor.design.file().parent_path(),
                                      std::move(wish), work.plugins);
  } catch (const std::runtime_error& error) {
    throw BadRequest(error.what());  // the file, or its folder
  }
  const Reply reply = begun(work, run);
  if (!goes_on) return reply;
  // The design is the study's from now on: their numbers are of one scene.
  return take_over(work, now(work),
                   session::changes_between(scene_of(work).scene, run->scene()))
      .value_or(reply);
}

/// {gap, seconds, samples, seed, study}
Reply select_start(const Work& work) {
  const auto [file, kept] = study_of(work);
  SelectOptions options;
  options.gap = number_or(work.request, "gap", options.gap, 1e6);
  options.seconds = number_or(work.request, "seconds", options.seconds, kMostSeconds);
  options.samples =
      static_cast<std::size_t>(number_or(work.request, "samples", 1500, 1e6));
  options.seed = static_cast<std::uint64_t>(number_or(work.request, "seed", 1, 1e9));
  options.threads = work.threads;
  options.study = file;
  return begun(work, std::make_shared<session::SelectionRun>(
                         scene_of(work).scene, std::move(options), kept, work.plugins));
}

/// {constraint, from, to, levels, evaluations, starts, seed}: of the limit, SI
Reply front_start(const Work& work) {
  constexpr double kAny = 1e12;
  const double from = number_or(work.request, "from", 0, kAny, -kAny),
               to = number_or(work.request, "to", 0, kAny, -kAny);
  const int levels =
      static_cast<int>(number_or(work.request, "levels", 6, kMostLevels, 1));
  std::vector<double> limits;
  for (int i = 0; i < levels; ++i)
    limits.push_back(levels == 1 ? from : std::lerp(from, to, i / (levels - 1.0)));
  const StudyPlan plan = plan_of(work.request);
  OptimizeOptions options;
  options.evaluations = plan.evaluations;
  options.starts = plan.starts;
  options.seed = plan.seed;
  options.samples = plan.samples;
  options.threads = work.threads;
  return begun(work, std::make_shared<session::FrontRun>(
                         scene_of(work).scene, text_at(work.request, "constraint"),
                         std::move(limits), std::move(options), work.plugins));
}

/// {}
Reply search_pause(const Work& work) {
  now(work).job->pause();
  return told(now(work));
}

/// {evaluations}: so many more, where it has ended
Reply search_resume(const Work& work) {
  Searched& searched = now(work);
  if (searched.job->phase() == session::Phase::ended &&
      work.request.contains("evaluations"))
    run_of(searched).extend(static_cast<int>(
        number_or(work.request, "evaluations", 0, kMostEvaluations, 1)));
  if (searched.job->resume()) work.place.launch(searched.job);
  return told(searched);
}

/// {path, locked}
Reply search_lock(const Work& work) {
  const Json& locked = member(work.request, "locked");
  if (!locked.is_boolean()) throw BadRequest("'locked' must be true or false");
  run_of(now(work)).lock(text_at(work.request, "path"), locked.get<bool>());
  return told(now(work));
}

}  // namespace delos::server
