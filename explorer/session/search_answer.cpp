#include "session/search_answer.h"

#include "delos/scene/definition.h"
#include "delos/scene/number.h"
#include "delos/text/words.h"

namespace delos::session {
namespace {

const char* word(Reduction reduction, bool larger_is_better) {
  switch (reduction) {
    case Reduction::mean:
      return "mean";
    case Reduction::p_norm:
      return "p-norm of";
    case Reduction::soft_max:
      return "soft maximum of";
    case Reduction::maximum:
      return larger_is_better ? "least" : "greatest";
    case Reduction::percentile:
      return "percentile of";
    case Reduction::cvar:
      return "mean of the worst";
    case Reduction::fraction:
      return "fraction that misses the limit of";
  }
  return "";
}

Json statistics(const Field& field) {
  const FieldStatistics s = summarize(field);
  return {{"samples", s.samples},      {"observable", s.observable},
          {"mean", number(s.mean)},    {"median", number(s.median)},
          {"p95", number(s.p95)},      {"min", number(s.min.value)},
          {"max", number(s.max.value)}};
}

std::string robust_text(const Scene& scene) {
  const Robustness& robust = scene.objective.robust;
  std::string text;
  if (!robust.failures.empty())
    text += ", worst of " + counted(robust.failures.size(), "failure");
  if (robust.is_drawn())
    text += std::string(robust.combine == DrawRule::mean ? ", mean" : ", worst") +
            " of " + counted(static_cast<std::size_t>(robust.draws), "draw");
  return text;
}

}  // namespace

SceneNumber variable_of(Scene& scene, const std::string& path,
                        PluginRegistry& plugins) {
  return std::get<SceneNumber>(find_number(scene, path, plugins));
}

Json variables_json(Scene scene, PluginRegistry& plugins) {
  Json all = Json::object();
  for (const VariableEntry& v : scene.variables)
    all[v.path] = number(*variable_of(scene, v.path, plugins).value);
  return all;
}

Json constraints_json(const std::vector<ConstraintReport>& constraints) {
  Json all = Json::array();
  for (const ConstraintReport& c : constraints)
    all.push_back(
        {{"name", c.name}, {"satisfied", c.satisfied}, {"slack", number(c.slack)}});
  return all;
}

std::string constraint_unit(const ConstraintEntry& entry, const Scene& scene) {
  if (std::holds_alternative<KeepTilt>(entry.what)) return "rad";
  if (std::holds_alternative<KeepSum>(entry.what)) return "1";
  if (const auto* metric = std::get_if<KeepMetric>(&entry.what))
    return std::get<Metric>(parse_metric(metric->metric, known_metrics(scene))).unit;
  return "m";
}

double objective_shown(const Scene& scene, double objective) {
  const auto& terms = scene.objective.terms;
  return terms.size() == 1 && terms.front().maximize ? -objective : objective;
}

std::string objective_text(const Scene& scene) {
  const auto& terms = scene.objective.terms;
  if (terms.size() > 1)
    return "weighted sum of " + std::to_string(terms.size()) + " terms" +
           robust_text(scene);
  const ObjectiveTerm term = terms.empty() ? ObjectiveTerm{} : terms.front();
  const auto metric = std::get<Metric>(parse_metric(
      term.metric.empty() ? scene.metric : term.metric, known_metrics(scene)));
  return std::string(word(term.reduction, metric.larger_is_better)) + " " +
         metric.name + robust_text(scene);
}

std::string objective_unit(const Scene& scene) {
  const auto& terms = scene.objective.terms;
  if (terms.size() > 1) return "1";
  if (!terms.empty() &&
      (terms.front().reduction == Reduction::fraction || terms.front().weight != 1))
    return "1";
  const std::string name = terms.empty() || terms.front().metric.empty()
                               ? scene.metric
                               : terms.front().metric;
  return std::get<Metric>(parse_metric(name, known_metrics(scene))).unit;
}

Json search_json(const OptimizeResult& result, PluginRegistry& plugins) {
  const Scene& scene = result.scene;
  return {
      {"scene", scene.name},
      {"objective", {{"name", objective_text(scene)}, {"unit", objective_unit(scene)}}},
      {"fusion", to_string(definition_of(scene).fusion)},
      {"covariance", to_string(scene.covariance)},
      {"initial", number(objective_shown(scene, result.initial.objective))},
      {"best", number(objective_shown(scene, result.best.objective))},
      {"plain_initial", number(objective_shown(scene, result.plain_initial))},
      {"plain_best", number(objective_shown(scene, result.plain_best))},
      {"stop", to_string(result.stop)},
      {"algorithm", result.algorithm},
      {"evaluations", result.evaluations},
      {"gradient_evaluations", result.gradient_evaluations},
      {"variables", variables_json(scene, plugins)},
      {"constraints", constraints_json(result.constraints)},
      {"initial_field", statistics(result.initial_field)},
      {"best_field", statistics(result.best_field)},
      {"messages", result.messages},
      {"seconds", number(result.seconds)}};
}

Json answers_json(const Answers& answers) {
  Json variables = Json::object(), devices = Json::object();
  for (const VariableAnswer& v : answers.variables)
    variables[v.path] = {{"slope", number(v.slope)},
                         {"down", number(v.down)},
                         {"up", number(v.up)},
                         {"down_is_bound", v.down_is_bound},
                         {"up_is_bound", v.up_is_bound}};
  for (const DeviceAnswer& d : answers.devices) devices[d.name] = number(d.without);
  return {{"loss", answers.loss}, {"variables", variables}, {"without", devices}};
}

}  // namespace delos::session
