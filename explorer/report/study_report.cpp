#include <algorithm>
#include <stdexcept>

#include "report/installation.h"
#include "report/shown.h"
#include "report/stills.h"
#include "report/study_words.h"
#include "report/words.h"
#include "session/comparison.h"
#include "session/consensus_answer.h"
#include "session/difference.h"
#include "session/search_answer.h"
#include "session/search_record.h"
#include "session/study_answer.h"

namespace delos::report {
namespace {

using session::Json;

/// Layouts that a consensus is of, at most.
constexpr std::size_t kMostLayouts = 10;

/// The scene as it was given, judged as the last one is.
Scene judged_alike(Scene given, const Scene& last) {
  given.samples = last.samples;
  given.orientations = last.orientations;
  given.metric = last.metric;
  given.covariance = last.covariance;
  given.objective = last.objective;
  given.constraints = last.constraints;
  given.regions = last.regions;
  given.variables = last.variables;
  return given;
}

/// A study's first and last design, and what the search makes of them.
struct Searched {
  StudySummary summary;
  Scene before, after;
  SearchFigures figures;
  Json constraints = Json::array();
};

Searched searched(const Study& study) {
  Searched s;
  s.summary = study.summary();
  s.after = study.scene();
  s.before = judged_alike(study.scene(0), s.after);
  const Scene* both[] = {&s.before, &s.after};
  if (const auto fusion = common_fusion(both))
    s.before.fusion = s.after.fusion = *fusion;
  s.figures.objective = session::objective_text(s.after);
  s.figures.unit = session::objective_unit(s.after);
  for (const StudyRound& round : s.summary.rounds)
    s.figures.evaluations += study.evaluations(round.number).size();
  return s;
}

/// Objective before and after, and how constraints are kept, on all samples.
void judge(Searched& s, const Making& making, PluginRegistry& plugins) {
  Problem before(s.before, plugins, {0, making.options.threads}),
      after(s.after, plugins, {0, making.options.threads});
  const Score best = after.score(after.design().start());
  const auto objective = [&](const Score& score) {
    return session::objective_shown(s.after, score.objective);
  };
  s.figures.before = objective(before.score(before.design().start()));
  s.figures.after = objective(best);
  const auto reports = constraint_reports(after, best);
  s.figures.constrained = !reports.empty();
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const ConstraintEntry& entry = s.after.constraints[i];
    if (!reports[i].satisfied) s.figures.broken.push_back(reports[i].name);
    s.constraints.push_back({{"name", reports[i].name},
                             {"words", constraint_words(entry, s.after)},
                             {"satisfied", reports[i].satisfied},
                             {"slack", session::number(reports[i].slack)},
                             {"unit", session::constraint_unit(entry, s.after)}});
  }
}

Json variables_json(Searched& s, PluginRegistry& plugins) {
  Json all = Json::array();
  for (const VariableEntry& v : s.after.variables) {
    const SceneNumber was = session::variable_of(s.before, v.path, plugins),
                      is = session::variable_of(s.after, v.path, plugins);
    const auto& locked = s.summary.locked;
    all.push_back({{"path", v.path},
                   {"unit", is.unit},
                   {"before", session::number(*was.value)},
                   {"after", session::number(*is.value)},
                   {"lower", session::number(v.lower)},
                   {"upper", session::number(v.upper)},
                   {"locked", std::ranges::find(locked, v.path) != locked.end()}});
  }
  return all;
}

/// As a page is told of searches that go on.
Json search_json(const Study& study, const Searched& s, PluginRegistry& plugins) {
  session::SearchRecord record;
  for (const StudyRound& round : s.summary.rounds) {
    record.begin_round(round.number, study.searched_scene(round.number), plugins);
    for (const StudyEvaluation& evaluation : study.evaluations(round.number))
      record.add(evaluation);
  }
  const double sign = session::objective_shown(s.after, 1);
  Json json = record.json({}, sign);
  json["objective"] = {{"name", s.figures.objective}, {"unit", s.figures.unit}};
  json["best"] =
      record.best() ? session::number(sign * record.best()->objective) : Json();
  return json;
}

Json study_part(const StudySummary& summary, double sign) {
  Json json = session::study_json(summary);
  for (Json& round : json["rounds"])
    for (const char* value : {"initial", "best"})
      if (!round[value].is_null()) round[value] = sign * round[value].get<double>();
  json["waiting"] = Json::array();
  for (const StudyAct& act : summary.waiting)
    json["waiting"].push_back({{"verb", act.verb}, {"argument", act.argument}});
  return json;
}

Json answers_part(const Searched& s, const Making& making, const StudyWish& wish,
                  PluginRegistry& plugins) {
  if (!wish.answers) return {};
  Problem problem(s.after, plugins, {kAnswerSamples, making.options.threads});
  const Answers found = answers(problem, problem.design().start(), wish.loss,
                                making.options.cancel, wish.progress);
  making.between();
  return session::answers_json(found);
}

/// What the starts of the last round agree on; nothing before one has found a design.
Json consensus_part(const Study& study, PluginRegistry& plugins) {
  if (session::best_of_starts(study, -1).empty()) return {};
  return session::consensus_json(
      session::study_consensus(study, plugins, -1, kMostLayouts));
}

Json difference_part(const Shown& before, const Shown& after) {
  session::DrawnField change =
      session::drawn_change(before.drawn.field, after.drawn.field);
  change.summary["definition"] = to_string(after.field.definition);
  return packed_json(std::move(change));
}

}  // namespace

Report study_report(const Study& study, const Making& making, const StudyWish& wish,
                    PluginRegistry& plugins) {
  Searched s = searched(study);
  const session::LoadedScene given = session::loaded_from(s.before, plugins),
                             last = session::loaded_from(s.after, plugins);
  const Shown before = shown(given, making), after = shown(last, making);
  judge(s, making, plugins);
  s.figures.field_before = summarize(before.field);
  s.figures.field_after = summarize(after.field);
  const double sign = session::objective_shown(s.after, 1);

  Report report{
      s.summary.scene, headline_of(s.figures, s.summary), {}, stills_of(before, after)};
  report.data = {
      {"kind", "study"},
      {"headline", report.headline},
      {"file", making.file},
      {"versions", versions_json(making, s.summary.plan.version, s.after, plugins)},
      {"text", write_scene(s.after)},
      {"commands", commands_of(s.summary, making.file)},
      {"before", design_json(before, plugins)},
      {"after", design_json(after, plugins)},
      {"difference", difference_part(before, after)},
      {"objective",
       {{"name", s.figures.objective},
        {"unit", s.figures.unit},
        {"before", session::number(s.figures.before)},
        {"after", session::number(s.figures.after)},
        {"maximize", sign < 0}}},
      {"constraints", s.constraints},
      {"variables", variables_json(s, plugins)},
      {"search", search_json(study, s, plugins)},
      {"study", study_part(s.summary, sign)},
      {"answers", answers_part(s, making, wish, plugins)},
      {"consensus", consensus_part(study, plugins)},
      {"tradeoffs", wish.tradeoffs},
      {"installation", installation_json(installation_of(last.scene, last.system))}};
  return report;
}

}  // namespace delos::report
