#include "session/blind_json.h"

#include <algorithm>

namespace delos::session {
namespace {

std::string directions(int n) {
  return std::to_string(n) + (n == 1 ? " direction" : " directions");
}

/// The reason in a sentence: what there is too little of, and whether something hides.
std::string why(const BlindRegion& region) {
  const std::size_t count = region.samples.size();
  std::string text;
  if (region.unseen == count)
    text = "no device sees it";
  else if (region.least_lost == region.most_lost)
    text = directions(region.least_lost) + " of the pose aren't observed";
  else
    text = std::to_string(region.least_lost) + " to " + directions(region.most_lost) +
           " of the pose aren't observed";
  std::size_t hidden = 0;
  std::string by;
  for (const RegionView& view : region.views)
    if (view.hidden > hidden) {
      hidden = view.hidden;
      by = view.device;
    }
  return hidden == 0 ? text + "; it is out of the view or the reach of the others"
                     : text + "; " + by + " would see " + std::to_string(hidden) +
                           " of its samples if nothing stood in between";
}

}  // namespace

Json blind_json(const LoadedScene& loaded, const Field& field, std::size_t most) {
  const auto regions = blind_regions(loaded.system, loaded.scene.orientations, field);
  Json json{{"samples", 0}, {"count", regions.size()}, {"regions", Json::array()}};
  std::size_t all = 0;
  for (const BlindRegion& region : regions) {
    all += region.samples.size();
    if (json["regions"].size() == most) continue;
    Json views = Json::array();
    for (const RegionView& view : region.views)
      views.push_back({{"device", view.device},
                       {"sees", view.sees},
                       {"hidden", view.hidden},
                       {"beyond", view.beyond}});
    json["regions"].push_back(
        {{"samples", region.samples.size()},
         {"unseen", region.unseen},
         {"least_lost", region.least_lost},
         {"most_lost", region.most_lost},
         {"box",
          {{"min", numbers(region.box.min())}, {"max", numbers(region.box.max())}}},
         {"why", why(region)},
         {"views", std::move(views)}});
  }
  json["samples"] = all;
  return json;
}

}  // namespace delos::session
