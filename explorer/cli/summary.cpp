#include "summary.h"

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "delos/observe/beacon_use.h"
#include "delos/text/format.h"
#include "delos/text/words.h"

namespace delos::cli {
namespace {

/// What keeps devices on the target from seeing anything.
std::vector<std::string> why_blind(const LoadedScene& loaded, const Field& field) {
  return blind_devices(loaded.system,
                       field_poses(field.samples, loaded.scene.orientations));
}

}  // namespace

std::string cell(const std::string& text, std::size_t width) {
  const auto characters =
      static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
      }));
  return text + std::string(width - std::min(width, characters), ' ');
}

void print_summary(std::ostream& out, const LoadedScene& loaded, const Field& field) {
  const FieldStatistics s = summarize(field);
  const auto value = [&](double v) { return format_quantity(v, field.unit); };
  out << loaded.scene.name << "\n"
      << field.metric << " of the " << to_string(field.definition) << ", "
      << counted(loaded.system.devices.size(), "device") << "\n"
      << counted(s.samples, "sample") << ", " << s.observable << " observable";
  if (s.one_short > 0) out << ", " << s.one_short << " one direction short of it";
  if (s.inside > 0) out << "; " << s.inside << " inside solids left out";
  out << "\n";
  if (s.finite == 0) {
    out << "  " << field.metric
        << " is finite nowhere: no sample is seen well enough\n";
    for (const std::string& why : why_blind(loaded, field)) out << "  " << why << "\n";
    return;
  }
  const Extreme &best = s.best(), &worst = s.worst();
  out << "  best    " << value(best.value) << "  at " << coordinates(best.at) << " m\n"
      << "  mean    " << value(s.mean) << "\n"
      << "  median  " << value(s.median) << "\n"
      << "  95 %    " << value(s.p95) << "\n"
      << "  worst   " << value(worst.value) << "  at " << coordinates(worst.at)
      << " m\n";
  if (field.discretization_error) {
    out << "  between the nodes, 95 % of the volume is within " << std::setprecision(2)
        << 100 * *field.discretization_error << " %\n";
  }
  if (field.unit == "m" || field.unit == "rad") {
    out << "This is scatter: a bias that the scene doesn't model comes on top.\n";
  }
  out << counted(field.evaluations, "evaluation") << " in " << std::setprecision(3)
      << field.seconds << " s on " << field.threads
      << (field.threads == 1 ? " thread\n" : " threads\n");
}

void print_octree(std::ostream& out, const AdaptiveReport& report) {
  out << counted(report.leaves, "leaf cell") << " of " << report.levels
      << " levels over " << counted(report.nodes, "node") << "; stopped by "
      << to_string(report.stop) << "\n";
  if (report.rays + report.rays_saved == 0) return;
  out << counted(report.rays, "ray") << ", " << std::setprecision(3)
      << 100 * static_cast<double>(report.rays_saved) /
             static_cast<double>(report.rays + report.rays_saved)
      << " % of the sight lines needed none\n";
}

}  // namespace delos::cli
