#include <algorithm>

#include "delos/field/blind.h"
#include "delos/text/format.h"
#include "delos/text/words.h"
#include "report/installation.h"
#include "report/shown.h"
#include "report/stills.h"
#include "session/blind_json.h"
#include "session/device_worth.h"
#include "session/ellipsoids.h"

namespace delos::report {
namespace {

using session::Json;

/// Samples that devices are weighed on, at most; regions that are told; points of the
/// lattice of ellipsoids.
constexpr std::size_t kWorthSamples = 20'000, kRegions = 12, kLattice = 150;

std::string headline(const Field& field) {
  const FieldStatistics s = summarize(field);
  const auto value = [&](double v) { return format_quantity(v, field.unit); };
  std::string text = field.metric;
  if (s.finite == 0) return text + " is finite nowhere: no sample is seen well enough.";
  text += " is " + value(s.mean) + " in the mean, from " + value(s.min.value) + " to " +
          value(s.max.value) + "; ";
  text += s.observable == s.samples
              ? "all " + std::to_string(s.samples) + " samples are observable."
              : std::to_string(s.observable) + " of " + std::to_string(s.samples) +
                    " samples are observable.";
  const ErrorPart part = field.definition.error.value_or(ErrorPart::scatter);
  if (part == ErrorPart::scatter && (field.unit == "m" || field.unit == "rad"))
    text += " This is scatter: a bias that the scene doesn't model comes on top.";
  return text;
}

/// Which part of the samples outside solids each device sees, in any orientation.
Json sees_json(const session::LoadedScene& loaded, const Field& field) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < field.value.size(); ++i)
    if (field.inside.empty() || !field.inside[i])
      points.push_back(field.samples.points[i]);
  const auto seen = seen_points(loaded.system, loaded.scene.orientations, points);
  Json parts = Json::object();
  for (std::size_t i = 0; i < seen.size(); ++i)
    parts[loaded.system.devices[i].name] =
        static_cast<double>(std::count(seen[i].begin(), seen[i].end(), true)) /
        static_cast<double>(std::max<std::size_t>(points.size(), 1));
  return parts;
}

Json worth(const session::LoadedScene& loaded, const Making& making) {
  const Samples samples =
      make_samples(session::coarser(loaded.scene.samples, kWorthSamples));
  const auto all = session::device_worth(loaded, samples, making.options);
  making.between();
  return session::worth_json(all, samples);
}

}  // namespace

Report scene_report(const session::LoadedScene& loaded, const Making& making,
                    PluginRegistry& plugins) {
  const Shown all = shown(loaded, making);
  Report report{loaded.scene.name, headline(all.field), {}, stills_of(all)};
  report.data = {
      {"kind", "scene"},
      {"headline", report.headline},
      {"file", making.file},
      {"versions", versions_json(making, "", loaded.scene, plugins)},
      {"text", write_scene(loaded.scene)},
      {"design", design_json(all, plugins)},
      {"sees", sees_json(loaded, all.field)},
      {"worth", worth(loaded, making)},
      {"blind", session::blind_json(loaded, all.field, kRegions)},
      {"lattice",
       {{"points", session::lattice_json(loaded, kLattice, making.options)}}},
      {"installation",
       installation_json(installation_of(loaded.scene, loaded.system))}};
  making.between();
  return report;
}

}  // namespace delos::report
