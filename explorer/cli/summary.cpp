#include "summary.h"

#include <algorithm>
#include <iomanip>
#include <ostream>

#include "delos/text/format.h"
#include "delos/text/words.h"
#include "session/palette.h"
#include "session/point_answer.h"

namespace delos::cli {
namespace {

/// "18.2 ± 0.3 %"
std::string part_text(double part, double error) {
  return format_quantity(100 * part, "1") + " ± " +
         format_quantity(100 * error, "1", 2) + " %";
}

/// How much is observable: samples, or parts of a volume.
std::string counts_text(const FieldStatistics& s) {
  std::string text = counted(s.samples, "sample");
  const std::string inside =
      s.inside > 0 ? "; " + std::to_string(s.inside) + " inside solids left out" : "";
  if (s.volume) {
    const VolumeStatistics& v = *s.volume;
    text += " of an octree" + inside + "\n" +
            part_text(v.observable, v.observable_error) + " of the volume observable";
    if (v.one_short > 0)
      text += ", " + part_text(v.one_short, v.one_short_error) +
              " one direction short of it";
    return text;
  }
  text += ", " + std::to_string(s.observable) + " observable";
  if (s.one_short > 0)
    text += ", " + std::to_string(s.one_short) + " one direction short of it";
  return text + inside;
}

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

void print_statistics(std::ostream& out, const Field& field) {
  const FieldStatistics s = summarize(field);
  const auto value = [&](double v) { return format_quantity(v, field.unit); };
  out << counts_text(s) << "\n";
  if (s.finite == 0) {
    out << "  " << field.metric
        << " is finite nowhere: no sample is seen well enough\n";
    return;
  }
  const auto error = [&](double VolumeStatistics::*of) {
    return s.volume ? " ± " + format_quantity((*s.volume).*of, field.unit, 2) : "";
  };
  const Extreme &best = s.best(), &worst = s.worst();
  out << "  best    " << value(best.value) << "  at " << coordinates(best.at) << " m\n"
      << "  mean    " << value(s.mean) << error(&VolumeStatistics::mean_error) << "\n"
      << "  median  " << value(s.median) << error(&VolumeStatistics::median_error)
      << "\n"
      << "  95 %    " << value(s.p95) << error(&VolumeStatistics::p95_error) << "\n"
      << "  worst   " << value(worst.value) << "  at " << coordinates(worst.at)
      << " m\n";
  if (s.volume) {
    out << "over " << counted(s.volume->points, "point")
        << " of the volume, ± with 95 % confidence; at most "
        << format_quantity(100 * s.volume->beyond, "1", 2)
        << " % of it is beyond best or worst\n";
  }
  if (field.discretization_error) {
    out << "pictures and files read the octree: between its nodes it is within "
        << format_quantity(100 * *field.discretization_error, "1", 2)
        << " % over 95 % of the volume\n";
  }
}

void print_summary(std::ostream& out, const LoadedScene& loaded, const Field& field) {
  out << loaded.scene.name << "\n"
      << field.metric << " of the " << to_string(field.definition) << ", "
      << counted(loaded.system.devices.size(), "device") << "\n";
  for (const ClutterEntry& clutter : loaded.scene.clutter)
    out << clutter.name << ": "
        << counted(static_cast<std::size_t>(clutter.count), "occluder")
        << " drawn at random, seed " << clutter.seed << "\n";
  for (const std::string& preset : preset_sources(loaded.scene))
    out << "preset " << preset << "\n";
  print_statistics(out, field);
  if (summarize(field).finite == 0) {
    for (const std::string& why : why_blind(loaded, field)) out << "  " << why << "\n";
    return;
  }
  const bool scatter =
      loaded.metric.kind != MetricKind::footprint && !counts_bias(loaded.system);
  if (scatter && (field.unit == "m" || field.unit == "rad")) {
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
