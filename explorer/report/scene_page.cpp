#include <cmath>

#include "delos/scene/io.h"
#include "delos/text/format.h"
#include "delos/text/words.h"
#include "report/pages.h"
#include "report/words.h"

namespace delos::report {
namespace {

Html headline(const SceneReport& r) {
  const FieldStatistics s = summarize(r.field);
  const auto value = [&](double v) { return format_quantity(v, r.field.unit); };
  std::string text = r.field.metric;
  if (s.finite == 0) {
    text += " is finite nowhere: no sample is seen well enough.";
  } else {
    text += " is " + value(s.mean) + " in the mean, from " + value(s.min.value) +
            " to " + value(s.max.value) + "; ";
    text += s.observable == s.samples
                ? "all " + std::to_string(s.samples) + " samples are observable."
                : std::to_string(s.observable) + " of " + std::to_string(s.samples) +
                      " samples are observable.";
  }
  const ErrorPart part = r.field.definition.error.value_or(ErrorPart::scatter);
  if (part == ErrorPart::scatter && (r.field.unit == "m" || r.field.unit == "rad"))
    text += " This is scatter: a bias that the scene doesn't model comes on top.";
  return element("p", {{"class", "answer"}}, text);
}

Html devices(const SceneReport& r) {
  std::vector<std::vector<Html>> rows;
  for (const DeviceRow& d : r.devices)
    rows.push_back(
        {d.name, d.type,
         (d.on_target ? "on the target, " : "") + coordinates(d.at, 3) + " m",
         percent(d.seen), std::to_string(d.lost),
         std::isnan(d.mean_rise) ? std::string("undefined")
         : std::isfinite(d.mean_rise)
             ? (d.mean_rise < 0 ? "−" : "+") + percent(std::abs(d.mean_rise))
             : std::string("all is lost")});
  return table(
      "What each device sees, and what its failure alone would cost: samples that are "
      "no longer observable, and the rise of the mean over those that remain",
      {"device", "type", "at", "sees", "samples lost", "mean"}, rows);
}

std::string why(const BlindRegion& region) {
  const std::size_t all = region.samples.size();
  std::string text;
  if (region.unseen == all)
    text = "No device sees it.";
  else if (region.unseen > 0)
    text = "No device sees " + std::to_string(region.unseen) + " of them.";
  const std::string lost = region.least_lost == region.most_lost
                               ? std::to_string(region.most_lost)
                               : std::to_string(region.least_lost) + " to " +
                                     std::to_string(region.most_lost);
  text += (text.empty() ? "" : " ") + lost +
          (region.most_lost == 1 ? " direction isn't" : " directions aren't") +
          " observed.";
  const auto those = [&](std::size_t RegionView::*count, const char* what) {
    std::vector<std::string> names;
    for (const RegionView& view : region.views) {
      if (view.*count == 0) continue;
      names.push_back(view.device + (view.*count == all
                                         ? std::string()
                                         : " (" + std::to_string(view.*count) + ")"));
    }
    if (!names.empty()) text += std::string(" ") + what + " " + listed(names) + ".";
  };
  those(&RegionView::sees, "Seen by");
  those(&RegionView::hidden, "Hidden from");
  those(&RegionView::beyond, "Outside the view of");
  return text;
}

Html blind(const SceneReport& r) {
  if (r.blind.empty())
    return element("p", "None: every sample outside solids is observable.");
  constexpr std::size_t kShown = 8;
  std::vector<std::vector<Html>> rows;
  std::size_t rest = 0;
  for (std::size_t i = 0; i < r.blind.size(); ++i) {
    const BlindRegion& region = r.blind[i];
    if (i >= kShown) {
      rest += region.samples.size();
      continue;
    }
    rows.push_back({std::to_string(region.samples.size()),
                    coordinates(region.box.min(), 3) + " to " +
                        coordinates(region.box.max(), 3) + " m",
                    why(region)});
  }
  Html all = table(
      "Neighbouring samples that aren't observable, the largest region first. Numbers "
      "in "
      "brackets: samples of the region, where it isn't all of it",
      {"samples", "from, to", "why"}, rows);
  if (rest > 0)
    all += element("p", {{"class", "note"}},
                   "And " + std::to_string(r.blind.size() - kShown) +
                       " smaller regions with " + std::to_string(rest) + " samples.");
  return all;
}

}  // namespace

Html versions(const std::string& program, const std::string& begun_with,
              const std::vector<PluginVersion>& plugins) {
  std::vector<std::vector<Html>> rows = {{"delos", program}};
  if (!begun_with.empty() && begun_with != program)
    rows.push_back({"delos, when the study began", begun_with});
  for (const PluginVersion& plugin : plugins)
    rows.push_back({"device " + plugin.type, plugin.version});
  return table("Versions", {"part", "version"}, rows);
}

std::string scene_page(const SceneReport& r) {
  const Html pictures = maps(r.views, r.markers);
  Html body = element("h1", r.scene.name) + headline(r);
  body += section(
      "The field",
      (pictures.empty()
           ? element("p", {{"class", "note"}},
                     "The samples are neither a volume nor a plane: there is no map.")
           : pictures) +
          key_figures({&r.field}, {r.field.metric}, r.larger_is_better));
  body += section("Devices", devices(r));
  body += section("To install it", r.installation);
  body += section("Blind regions, and why", blind(r));
  body += section("To compute it again",
                  element("pre", "delos field " + r.file + "\ndelos report " + r.file +
                                     " -o report.html") +
                      versions(r.version, "", r.plugins) +
                      element("h3", "The scene, in SI units") +
                      element("pre", write_scene(r.scene)));
  return page(r.scene.name + " — delos", body);
}

}  // namespace delos::report
