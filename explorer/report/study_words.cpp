#include "report/study_words.h"

#include <cmath>

#include "delos/text/format.h"
#include "delos/text/words.h"

namespace delos::report {
namespace {

/// What a shell reads as one word.
std::string quoted(const std::string& word) {
  if (word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                             "0123456789._-/=,:+") == std::string::npos)
    return word;
  std::string text = "'";
  for (const char c : word)
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string act_command(const StudyAct& act) {
  std::string text = "delos study again.study " + act.verb;
  if (act.argument.empty()) return text + "\n";
  // Two corners are two words.
  const bool corners =
      act.verb == "forbid" && act.argument.find(' ') != std::string::npos;
  return text + " " + (corners ? act.argument : quoted(act.argument)) + "\n";
}

}  // namespace

std::string headline_of(const SearchFigures& f, const StudySummary& summary) {
  const auto value = [&](double v) { return format_quantity(v, f.unit); };
  std::string text =
      "The " + f.objective + " went from " + value(f.before) + " to " + value(f.after);
  if (f.before != 0) {
    const double change = f.after / f.before - 1;
    text +=
        std::string(" (") + (change < 0 ? "−" : "+") + percent(std::abs(change)) + ")";
  }
  text += "; " + std::to_string(f.field_after.observable) + " of " +
          std::to_string(f.field_after.samples) + " samples are observable, " +
          std::to_string(f.field_before.observable) + " were. ";
  if (f.constrained)
    text += f.broken.empty() ? "All constraints are kept. "
                             : "NOT kept: " + listed(f.broken) + ". ";
  text += std::to_string(f.evaluations) + " evaluations, seed " +
          std::to_string(summary.plan.seed) + ".";
  if (summary.rounds.empty() || !summary.rounds.back().ended)
    text += " The search hasn't come to its end: this is where it began.";
  return text;
}

std::string commands_of(const StudySummary& summary, const std::string& file) {
  const StudyPlan& plan = summary.plan;
  std::string text = "delos study " + quoted(file) + " best scene.yaml --round 0\n" +
                     "delos optimize scene.yaml --study again.study --seed " +
                     std::to_string(plan.seed) + " --algorithm " + plan.algorithm;
  if (plan.starts > 0) text += " --starts " + std::to_string(plan.starts);
  if (plan.evaluations > 0)
    text += " --evaluations " + std::to_string(plan.evaluations);
  text += " --samples " + std::to_string(plan.samples) + "\n";
  for (std::size_t i = 0; i < summary.acts.size(); ++i) {
    const StudyAct& act = summary.acts[i];
    text += act_command(act);
    const bool last = i + 1 == summary.acts.size() ||
                      summary.acts[i + 1].after_round != act.after_round;
    if (last) text += "delos study again.study resume\n";
  }
  return text + "delos report again.study -o report.html";
}

}  // namespace delos::report
