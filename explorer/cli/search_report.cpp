#include "search_report.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>

#include "delos/scene/definition.h"
#include "delos/scene/number.h"
#include "delos/text/format.h"
#include "summary.h"
#include "warnings.h"

namespace delos::cli {
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

SceneNumber number_of(Scene& scene, const std::string& path, PluginRegistry& plugins) {
  return std::get<SceneNumber>(find_number(scene, path, plugins));
}

}  // namespace

std::string constraint_unit(const ConstraintEntry& entry, const Scene& scene) {
  if (std::holds_alternative<KeepTilt>(entry.what)) return "rad";
  if (std::holds_alternative<KeepSum>(entry.what)) return "1";
  if (const auto* metric = std::get_if<KeepMetric>(&entry.what))
    return std::get<Metric>(parse_metric(metric->metric, known_metrics(scene))).unit;
  return "m";
}

/// What a maximised objective is, without the sign that minimising gave it.
double objective_shown(const Scene& scene, double objective) {
  const auto& terms = scene.objective.terms;
  return terms.size() == 1 && terms.front().maximize ? -objective : objective;
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
  Scene scene = result.scene;
  Json variables = Json::object();
  for (const VariableEntry& v : scene.variables)
    variables[v.path] = number(*number_of(scene, v.path, plugins).value);
  Json constraints = Json::array();
  for (const ConstraintReport& c : result.constraints)
    constraints.push_back(
        {{"name", c.name}, {"satisfied", c.satisfied}, {"slack", number(c.slack)}});
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
      {"variables", variables},
      {"constraints", constraints},
      {"initial_field", statistics(result.initial_field)},
      {"best_field", statistics(result.best_field)},
      {"messages", result.messages},
      {"seconds", number(result.seconds)}};
}

void print_search(std::ostream& out, const OptimizeResult& result,
                  PluginRegistry& plugins) {
  Scene before = result.initial_scene, after = result.scene;
  const std::string unit = objective_unit(before);
  const double from = objective_shown(before, result.initial.objective),
               to = objective_shown(before, result.best.objective);
  out << before.name << "\n"
      << objective_text(before) << ": " << format_quantity(from, unit) << " before, "
      << format_quantity(to, unit) << " after";
  if (from != 0)
    out << " (" << std::showpos << std::setprecision(3) << 100 * (to / from - 1)
        << std::noshowpos << " %)";
  out << "\nof the " << to_string(definition_of(before)) << "\n";
  if (before.objective.robust != Robustness{}) {
    const auto plain = [&](double objective) {
      return format_quantity(objective_shown(before, objective), unit);
    };
    out << "where nothing fails or is off: " << plain(result.plain_initial)
        << " before, " << plain(result.plain_best) << " after\n";
  }
  const FieldStatistics a = summarize(result.initial_field),
                        b = summarize(result.best_field);
  out << "observable samples: " << a.observable << " before, " << b.observable
      << " after, of " << b.samples << "\n";
  for (std::size_t i = 0; i < result.constraints.size(); ++i) {
    const ConstraintReport& c = result.constraints[i];
    const std::string of = constraint_unit(before.constraints[i], before);
    out << "  " << c.name << ": "
        << (c.satisfied ? "kept, with " + format_quantity(c.slack, of) + " to spare"
            : std::isfinite(c.slack) ? "NOT kept, by " + format_quantity(-c.slack, of)
                                     : "NOT kept: a sample is blind")
        << "\n";
  }
  for (const VariableEntry& v : after.variables) {
    const SceneNumber old = number_of(before, v.path, plugins),
                      now = number_of(after, v.path, plugins);
    const auto text = [&](double value) { return format_quantity(value, now.unit, 4); };
    out << "  " << cell(v.path, 36) << cell(text(*old.value), 12) << " -> "
        << text(*now.value)
        << (*now.value == v.lower   ? "  (its least)"
            : *now.value == v.upper ? "  (its greatest)"
                                    : "")
        << "\n";
  }
  out << "stopped: " << to_string(result.stop) << "; " << result.algorithm << ", "
      << counted(result.gradient_evaluations, "evaluation") << " with slopes, "
      << result.evaluations << " without, " << std::setprecision(3) << result.seconds
      << " s\n";
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

void print_answers(std::ostream& out, const Answers& answers, Scene scene,
                   PluginRegistry& plugins) {
  out << "For under " << 100 * answers.loss << " % loss, alone, may move by\n";
  for (const VariableAnswer& v : answers.variables) {
    const std::string unit = number_of(scene, v.path, plugins).unit;
    out << "  " << cell(v.path, 36) << "-" << format_quantity(v.down, unit)
        << (v.down_is_bound ? " (its least)" : "") << " to +"
        << format_quantity(v.up, unit) << (v.up_is_bound ? " (its greatest)" : "")
        << "\n";
  }
  if (answers.devices.empty()) return;
  out << "Where one device fails, the objective rises by\n";
  for (const DeviceAnswer& d : answers.devices)
    out << "  " << cell(d.name, 18) << std::setprecision(3) << 100 * d.without
        << " %\n";
}

SearchLine::SearchLine(const Scene& scene)
    : line_(scene.name),
      objective_(objective_text(scene)),
      unit_(objective_unit(scene)) {}

void SearchLine::update(const SearchProgress& at) {
  const std::string best = std::isfinite(at.best)
                               ? format_quantity(std::abs(at.best), unit_)
                               : std::string("none yet");
  line_.update(objective_ + ' ' + best + " after " + std::to_string(at.evaluations) +
               " of " + std::to_string(at.of) + " evaluations");
}

void SearchLine::clear() { line_.clear(); }

int finish_search(const std::function<OptimizeResult()>& search, SearchLine& line,
                  const std::filesystem::path& about,
                  const std::filesystem::path& study, PluginRegistry& plugins,
                  bool json,
                  const std::function<Answers(const OptimizeResult&)>& explain,
                  const Diagnostics& warnings) {
  OptimizeResult result;
  try {
    result = search();
  } catch (const std::invalid_argument& refusal) {
    line.clear();
    throw Failure{kDiagnostics, about.string() + ": " + refusal.what()};
  } catch (const std::runtime_error& failure) {
    line.clear();
    throw Failure{kDiagnostics, failure.what()};
  }
  line.clear();
  for (const std::string& message : result.messages)
    std::cerr << "delos: " << message << "\n";
  std::optional<Answers> answers;
  if (explain) answers = explain(result);
  if (json) {
    Json document = search_json(result, plugins);
    document["study"] = study.empty() ? Json() : Json(study.string());
    if (answers) document["answers"] = answers_json(*answers);
    if (!warnings.empty()) document["warnings"] = diagnostics_json(warnings);
    print_document(document);
  } else {
    print_search(std::cout, result, plugins);
    if (answers) print_answers(std::cout, *answers, result.scene, plugins);
  }
  if (result.stop == SearchStop::infeasible) {
    std::cerr << "delos: no design was found that keeps all constraints\n";
    return kDiagnostics;
  }
  if (result.stop != SearchStop::cancelled) return kDone;
  std::cerr << "delos: stopped; this is the best so far\n";
  return kCancelled;
}

}  // namespace delos::cli
