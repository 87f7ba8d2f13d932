#include "select_report.h"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "delos/text/format.h"
#include "delos/text/words.h"
#include "summary.h"

namespace delos::cli {
namespace {

void print_names(std::ostream& out, const char* label,
                 const std::vector<std::string>& names) {
  constexpr std::size_t kWidth = 78;
  std::string line = std::string(14 - std::string_view(label).size(), ' ');
  out << "  " << label;
  std::size_t width = 2 + 14;
  for (const std::string& name : names) {
    if (width + name.size() + 1 > kWidth) {
      out << "\n" << std::string(16, ' ');
      width = 16;
      line.clear();
    }
    out << line << name;
    line = " ";
    width += name.size() + 1;
  }
  out << "\n";
}

/// What stands behind a value of which some samples are blind.
std::string judged_by_guess(std::size_t blind, double guess) {
  if (blind == 0) return "";
  return ", " + counted(blind, "blind sample") + " by a guess of " +
         format_quantity(guess, "m", 4);
}

}  // namespace

void print_selection(std::ostream& out, const SelectResult& r) {
  const auto line = [&](const char* label) -> std::ostream& {
    return out << "  " << cell(label, 14);
  };
  out << r.all.scene.name << ": " << r.chosen.size() << " of "
      << counted(r.all.candidates.size(), "candidate") << "\n";
  line("value") << format_quantity(r.value, r.unit, 4) << ", " << r.quantity << "\n";
  line("of the") << to_string(definition_of(r.all.scene)) << "\n";
  line("lower bound") << format_quantity(r.lower_bound, r.unit, 4)
                      << (r.blind > 0 && r.blind == r.always_blind
                              ? ": no choice that leaves nothing else blind has less\n"
                              : ": no choice that the scene allows has less\n");
  if (r.blind > 0)
    line("blind") << counted(r.blind, "sample") << ", judged by a guess of "
                  << format_quantity(r.guess, "m", 4) << " and rad"
                  << (r.always_blind > 0 ? "; " + std::to_string(r.always_blind) +
                                               " whatever is chosen"
                                         : std::string())
                  << "\n";
  line("gap") << std::setprecision(3) << 100 * r.gap << " %"
              << (r.gap == r.variance_gap ? "" : ", of variances ");
  if (r.gap != r.variance_gap)
    out << std::setprecision(3) << 100 * r.variance_gap << " %";
  out << ", after " << r.nodes << " nodes and " << r.seconds << " s\n";
  print_names(out, "chosen", chosen_names(r.all, r.chosen));
  std::vector<std::string> every;
  for (std::size_t i = 0; i < r.in_every.size(); ++i)
    if (r.in_every[i] && !r.all.candidates[i].kept)
      every.push_back(r.all.candidates[i].name);
  if (!every.empty()) print_names(out, "in every one", every);
  const auto none = std::count(r.in_none.begin(), r.in_none.end(), 1);
  if (none > 0)
    line("in none") << counted(static_cast<std::size_t>(none), "candidate")
                    << " of the choices that are as good\n";
}

void print_cover(std::ostream& out, const SceneCover& cover) {
  const int times = *cover.all.scene.selection.cover;
  out << cover.all.scene.name << ": " << cover.chosen.size() << " of "
      << counted(cover.all.candidates.size(), "candidate") << " see "
      << counted(cover.samples, "sample") << ' '
      << (times == 1 ? "each" : std::to_string(times) + " times each") << "\n"
      << "  cost          " << cover.cost << ", at best " << cover.lower_bound
      << (cover.stop == CoverStop::proven ? ": proven" : "") << ", after "
      << std::setprecision(3) << cover.seconds << " s\n";
  print_names(out, "chosen", chosen_names(cover.all, cover.chosen));
}

void print_curve(std::ostream& out, const CountCurve& curve) {
  out << curve.all.scene.name << ": " << curve.quantity << "\n"
      << "  of the " << to_string(definition_of(curve.all.scene)) << "\n"
      << "  count  found         at best       gap\n";
  for (const CountPoint& p : curve.points)
    out << "  " << cell(std::to_string(p.count), 7)
        << cell(format_quantity(p.value, curve.unit, 4), 14)
        << cell(format_quantity(p.lower_bound, curve.unit, 4), 14)
        << percent(gap_of(p.value, p.lower_bound))
        << judged_by_guess(p.blind, curve.guess) << "\n";
}

void print_removals(std::ostream& out, const RemovalOrder& order) {
  out << order.all.scene.name << ": " << order.quantity << "\n  of the "
      << to_string(definition_of(order.all.scene)) << "\n  with all "
      << order.all.candidates.size() << "  "
      << format_quantity(order.all_chosen, order.unit, 4) << "\n"
      << "  left   value         at best       by removing\n";
  for (const Removal& r : order.removals)
    out << "  " << cell(std::to_string(r.left), 7)
        << cell(format_quantity(r.value, order.unit, 4), 14)
        << cell(format_quantity(r.lower_bound, order.unit, 4), 14)
        << order.all.candidates[r.candidate].name
        << judged_by_guess(r.blind, order.guess) << "\n";
}

}  // namespace delos::cli
