#include <algorithm>
#include <cmath>
#include <limits>

#include "delos/scene/io.h"
#include "delos/text/format.h"
#include "delos/text/words.h"
#include "report/chart.h"
#include "report/pages.h"
#include "report/words.h"

namespace delos::report {
namespace {

std::string signed_percent(double part) {
  return (part < 0 ? "−" : "+") + percent(std::abs(part));
}

std::size_t evaluations(const StudyReport& r) {
  std::size_t count = 0;
  for (const auto& round : r.evaluations) count += round.size();
  return count;
}

Html headline(const StudyReport& r) {
  const auto value = [&](double v) { return format_quantity(v, r.objective_unit); };
  std::string text = "The " + r.objective + " went from " + value(r.objective_before) +
                     " to " + value(r.objective_after);
  if (r.objective_before != 0)
    text += " (" + signed_percent(r.objective_after / r.objective_before - 1) + ")";
  const FieldStatistics a = summarize(r.field_before), b = summarize(r.field_after);
  text += "; " + std::to_string(b.observable) + " of " + std::to_string(b.samples) +
          " samples are observable, " + std::to_string(a.observable) + " were. ";
  std::vector<std::string> broken;
  for (const ConstraintRow& c : r.constraints)
    if (!c.report.satisfied) broken.push_back(c.report.name);
  if (!r.constraints.empty())
    text += broken.empty() ? "All constraints are kept. "
                           : "NOT kept: " + listed(broken) + ". ";
  const bool ended = !r.summary.rounds.empty() && r.summary.rounds.back().ended;
  text += std::to_string(evaluations(r)) + " evaluations, seed " +
          std::to_string(r.summary.plan.seed) + ".";
  if (!ended) text += " The search hasn't come to its end: this is where it began.";
  return element("p", {{"class", "answer"}}, text);
}

Html question(const StudyReport& r) {
  const auto& terms = r.after.objective.terms;
  const bool up = terms.size() == 1 && terms.front().maximize;
  std::size_t locked = 0;
  for (const VariableRow& v : r.variables) locked += v.locked;
  std::string text = std::string("Make the ") + r.objective +
                     (up ? " large" : " small") + " by changing " +
                     std::to_string(r.variables.size() - locked) +
                     (r.variables.size() - locked == 1 ? " variable" : " variables") +
                     " of " + std::to_string(r.after.devices.size()) + " devices";
  if (locked > 0) text += " (" + std::to_string(locked) + " more are locked)";
  Html all = element("p", text + (r.constraints.empty() ? "." : ", such that"));
  Html list;
  for (const ConstraintRow& c : r.constraints)
    list += element("li", element("b", c.report.name) + ": " + c.words + ".");
  if (!list.empty()) all += element("ul", list);
  return all;
}

Html convergence(const StudyReport& r) {
  Chart chart;
  chart.x_name = "evaluation";
  chart.y_name = r.objective;
  chart.y_unit = r.objective_unit;
  Series every{"every design", Stroke::dots, {}},
      best{"best so far", Stroke::steps, {}};
  double at = 0;
  for (std::size_t round = 0; round < r.evaluations.size(); ++round) {
    for (const StudyAct& act : r.summary.acts)
      if (act.after_round == static_cast<int>(round))
        chart.marks.push_back({at, act.verb + " " + act.argument});
    double least = std::numeric_limits<double>::infinity();
    for (const StudyEvaluation& e : r.evaluations[round]) {
      ++at;
      if (!std::isfinite(e.objective)) continue;
      const double shown = r.maximize ? -e.objective : e.objective;
      every.points.push_back({at, shown});
      if (e.width == 0 && e.feasible) least = std::min(least, e.objective);
      if (std::isfinite(least))
        best.points.push_back({at, r.maximize ? -least : least});
    }
  }
  if (every.points.empty()) return element("p", "Nothing has been evaluated so far.");
  chart.says = "Convergence: the " + r.objective + " over " +
               std::to_string(every.points.size()) + " evaluations";
  if (!best.points.empty())
    chart.says +=
        ", " + format_quantity(best.points.back()[1], r.objective_unit) + " at the end";
  chart.series = {every, best};
  return chart_figure(
      chart,
      "Start after start, on the samples of the search. Designs that were looked at "
      "with soft edges, or that break a constraint, don't count as best. Every round "
      "begins anew; dashed lines are acts of a person.");
}

Html constraints(const StudyReport& r) {
  std::vector<std::vector<Html>> rows;
  for (const ConstraintRow& c : r.constraints)
    rows.push_back({c.report.name, c.words,
                    element("span", {{"class", c.report.satisfied ? "good" : "bad"}},
                            c.report.satisfied ? "kept" : "NOT kept"),
                    format_quantity(c.report.slack, c.unit)});
  return table("On all samples; below zero, so much is missing",
               {"constraint", "demand", "", "slack"}, rows);
}

/// How far a variable may move, "−12 mm to +3 mm".
std::string tolerance(const VariableAnswer& v, const std::string& unit) {
  return "−" + format_quantity(v.down, unit) + (v.down_is_bound ? " (bound)" : "") +
         " to +" + format_quantity(v.up, unit) + (v.up_is_bound ? " (bound)" : "");
}

Html design(const StudyReport& r) {
  std::vector<std::vector<Html>> rows;
  for (const VariableRow& v : r.variables) {
    const auto text = [&](double value) { return format_quantity(value, v.unit, 4); };
    std::string after = text(v.after);
    if (v.locked)
      after += " (locked)";
    else if (v.after == v.lower || v.after == v.upper)
      after += v.after == v.lower ? " (least)" : " (greatest)";
    std::vector<Html> row = {v.path, text(v.before), after};
    if (r.answers) {
      const auto& all = r.answers->variables;
      const auto of = std::find_if(all.begin(), all.end(), [&](const auto& answer) {
        return answer.path == v.path;
      });
      const bool known = of != all.end();
      row.emplace_back(known ? tolerance(*of, v.unit) : "");
      // How much of the objective the whole range would be worth at this slope.
      const double worth =
          known && r.objective_after != 0
              ? of->slope * (v.upper - v.lower) / std::abs(r.objective_after)
              : 0;
      row.emplace_back(known ? format_quantity(100 * worth, "1", 2) + " %" : "");
    }
    rows.push_back(std::move(row));
  }
  std::vector<Html> head = {"variable", "before", "after"};
  std::string caption = "All variables";
  if (r.answers) {
    head.emplace_back("may move by");
    head.emplace_back("slope");
    caption +=
        ". May move by: alone, for under " +
        format_quantity(100 * r.answers->loss, "1") +
        " % loss and with all constraints kept. Slope: of the objective, relative "
        "to it, times the variable's whole range";
  }
  return table(caption, head, rows);
}

Html failures(const StudyReport& r) {
  if (!r.answers || r.answers->devices.empty()) return {};
  std::vector<std::vector<Html>> rows;
  for (const DeviceAnswer& d : r.answers->devices)
    rows.push_back({d.name, signed_percent(d.without)});
  return section("If one device fails",
                 table("Rise of the objective where a device alone is missing",
                       {"device", "objective"}, rows));
}

Html history(const StudyReport& r) {
  std::vector<std::vector<Html>> rows;
  for (const StudyRound& round : r.summary.rounds) {
    std::string acts;
    for (const StudyAct& act : r.summary.acts)
      if (act.after_round == round.number - 1)
        acts += (acts.empty() ? "" : "; ") + act.verb + " " + act.argument;
    const auto value = [&](double v) {
      return round.ended ? format_quantity(r.maximize ? -v : v, r.objective_unit)
                         : std::string("not at its end");
    };
    rows.push_back({std::to_string(round.number), acts.empty() ? "—" : acts,
                    std::to_string(round.evaluations), value(round.initial),
                    value(round.best)});
  }
  Html all = table("Rounds, each with the acts that it began with",
                   {"round", "acts", "evaluations", "from", "to"}, rows);
  std::string waiting;
  for (const StudyAct& act : r.summary.waiting)
    waiting += (waiting.empty() ? "" : "; ") + act.verb + " " + act.argument;
  if (!waiting.empty()) all += element("p", "For the next round: " + waiting + ".");
  return all;
}

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

std::string commands(const StudyReport& r) {
  const StudyPlan& plan = r.summary.plan;
  const std::string file = quoted(r.file);
  std::string text = "delos study " + file + " best scene.yaml --round 0\n" +
                     "delos optimize scene.yaml --study again.study --seed " +
                     std::to_string(plan.seed) + " --algorithm " + plan.algorithm;
  if (plan.starts > 0) text += " --starts " + std::to_string(plan.starts);
  if (plan.evaluations > 0)
    text += " --evaluations " + std::to_string(plan.evaluations);
  text += " --samples " + std::to_string(plan.samples) + "\n";
  for (std::size_t i = 0; i < r.summary.acts.size(); ++i) {
    const StudyAct& act = r.summary.acts[i];
    text += "delos study again.study " + act.verb;
    // Two corners are two words.
    const std::size_t blank =
        act.verb == "forbid" ? act.argument.find(' ') : std::string::npos;
    if (blank != std::string::npos)
      text += " " + act.argument;
    else if (!act.argument.empty())
      text += " " + quoted(act.argument);
    text += "\n";
    const bool last = i + 1 == r.summary.acts.size() ||
                      r.summary.acts[i + 1].after_round != act.after_round;
    if (last) text += "delos study again.study resume\n";
  }
  return text + "delos report again.study -o report.html";
}

}  // namespace

std::string study_page(const StudyReport& r) {
  const Html pictures =
      maps(r.views_before, r.views_after, r.were, r.are, r.larger_is_better);
  Html body = element("h1", r.summary.scene) + headline(r);
  body += section("The question", question(r));
  body +=
      section("Before and after", key_figures({&r.field_before, &r.field_after},
                                              {"before", "after"}, r.larger_is_better) +
                                      pictures);
  body += section("Convergence", convergence(r));
  if (!r.constraints.empty()) body += section("Constraints", constraints(r));
  body += section("The design", design(r));
  body += failures(r) + r.more;
  body += section("Rounds and acts", history(r));
  body += section("To compute it again",
                  element("p",
                          "Acts hold from the end of a round here, and a round that "
                          "was cut short by an act ends where it was.") +
                      element("pre", commands(r)) +
                      versions(r.version, r.summary.plan.version, r.plugins) +
                      element("h3", "The best scene, in SI units") +
                      element("pre", write_scene(r.after)));
  return page(r.summary.scene + " — delos", body);
}

}  // namespace delos::report
