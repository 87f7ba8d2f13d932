#include "search_report.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <optional>

#include "delos/text/format.h"
#include "session/search_answer.h"
#include "summary.h"
#include "warnings.h"

namespace delos::cli {

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
    const SceneNumber old = session::variable_of(before, v.path, plugins),
                      now = session::variable_of(after, v.path, plugins);
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

void print_answers(std::ostream& out, const Answers& answers, Scene scene,
                   PluginRegistry& plugins) {
  out << "For under " << 100 * answers.loss << " % loss, alone, may move by\n";
  for (const VariableAnswer& v : answers.variables) {
    const std::string unit = session::variable_of(scene, v.path, plugins).unit;
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
