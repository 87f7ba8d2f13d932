#include "report/stills.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "output/picture.h"
#include "output/slice.h"
#include "render/picture.h"

namespace delos::report {
namespace {

PictureOptions options_of(const ColourRange& range,
                          const session::LoadedScene& loaded) {
  PictureOptions options;
  options.larger_is_better = range.larger_is_better;
  options.log10 = range.log10;
  if (range.high > range.low) options.range = {range.low, range.high};
  options.devices = markers_of(loaded.scene, loaded.system);
  return options;
}

Still map_of(const Field& field, const PictureOptions& options,
             const std::string& name) {
  const Slice slice = make_slice(field, options);
  std::size_t blind = 0;
  for (std::size_t i = 0; i < slice.value.size(); ++i)
    blind += slice.solid[i] == 0 && !std::isfinite(slice.value[i]);
  const std::string of =
      std::to_string(blind) + " of " + std::to_string(slice.value.size()) + " samples";
  Still still;
  still.says = "Map of " + field.metric + " of " + field.scene;
  still.caption = name;
  if (!slice.place.empty()) {
    still.says += " at " + slice.place;
    still.caption += (name.empty() ? "" : ", ") + slice.place;
  }
  if (blind > 0) {
    still.says += "; blind at " + of;
    still.caption += ": blind at " + of + " (hatched)";
  }
  std::ostringstream png;
  write_picture(field, options, png);
  still.png = png.str();
  return still;
}

/// The heights of three levels of a volume, in the middles of three slabs; one of none
/// where the samples are flat; none where they are neither.
std::vector<std::optional<double>> levels_of(const Field& field) {
  if (!has_slice(field.samples)) return {};
  for (const SamplePart& part : field.samples.parts) {
    const auto* grid = std::get_if<GridShape>(&part.shape);
    if (!grid || grid->counts.minCoeff() == 1) continue;
    std::vector<std::optional<double>> levels;
    for (const double at : {1 / 6.0, 3 / 6.0, 5 / 6.0}) {
      const double layer = std::round(at * static_cast<double>(grid->counts[2] - 1));
      const double z = grid->origin.z() + layer * grid->step.z();
      if (levels.empty() || *levels.back() != z) levels.emplace_back(z);
    }
    return levels;
  }
  return {std::nullopt};
}

PictureOptions at_level(PictureOptions options, const std::optional<double>& level) {
  options.has_slice = level.has_value();
  options.slice_z = level.value_or(0);
  return options;
}

Still room_of(const Shown& shown, const ColourRange& range) {
  constexpr int kWidth = 1120, kHeight = 630;  // pixels
  render::PictureOptions options;
  options.view = render::view_of("corner");
  options.width = kWidth;
  options.height = kHeight;
  options.log10 = range.log10;
  options.slices.emplace_back();  // the middle layer
  const std::string& name = shown.loaded.scene.name;
  return {"The room, with the middle layer of the samples",
          "The devices of " + name + " in their room, and the field of " +
              shown.field.metric,
          png_of(render_picture(shown.loaded, shown.drawn, options))};
}

/// The absolute change that a part of the finite samples doesn't exceed.
double quantile(const Field& field, double part) {
  std::vector<double> sizes;
  for (const double value : field.value)
    if (std::isfinite(value)) sizes.push_back(std::abs(value));
  if (sizes.empty()) return 0;
  const double last = part * static_cast<double>(sizes.size() - 1);
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(std::ceil(last));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

}  // namespace

ColourRange common_range(const std::vector<const Field*>& fields,
                         bool larger_is_better) {
  ColourRange range;
  range.larger_is_better = larger_is_better;
  bool any = false;
  for (const Field* field : fields) {
    const FieldStatistics s = summarize(*field);
    if (s.finite == 0) continue;
    range.low = any ? std::min(range.low, s.min.value) : s.min.value;
    range.high = any ? std::max(range.high, s.max.value) : s.max.value;
    any = true;
  }
  range.log10 = range.low > 0 && range.high > 20 * range.low;
  return range;
}

Change change_between(const Field& before, const Field& after, bool larger_is_better) {
  Change change;
  change.field = compare_fields(before, after).difference;
  change.end = quantile(change.field, 0.98);
  for (std::size_t i = 0; i < before.value.size(); ++i) {
    const bool was = std::isfinite(before.value[i]), is = std::isfinite(after.value[i]);
    if (was == is) continue;
    ++(is ? change.gained : change.lost);
    change.field.value[i] = is == larger_is_better ? change.end : -change.end;
  }
  return change;
}

std::vector<Still> stills_of(const Shown& shown) {
  const Field& field = shown.drawn.field;
  const ColourRange range =
      common_range({&field, &shown.field}, field.larger_is_better);
  const PictureOptions options = options_of(range, shown.loaded);
  std::vector<Still> all{room_of(shown, range)};
  for (const auto& level : levels_of(field))
    all.push_back(map_of(field, at_level(options, level), ""));
  return all;
}

std::vector<Still> stills_of(const Shown& before, const Shown& after) {
  const Field &was = before.drawn.field, &is = after.drawn.field;
  const bool larger = is.larger_is_better;
  const ColourRange range = common_range({&was, &is, &after.field}, larger);
  const Change change = change_between(was, is, larger);
  PictureOptions of_change = options_of({}, after.loaded);
  of_change.larger_is_better = larger;
  of_change.change = true;
  if (change.end > 0) of_change.range = {-change.end, change.end};
  std::vector<Still> all{room_of(after, range)};
  for (const auto& level : levels_of(is)) {
    const auto add = [&](const Field& field, const PictureOptions& options,
                         const char* name) {
      all.push_back(map_of(field, at_level(options, level), name));
    };
    add(was, options_of(range, before.loaded), "Before");
    add(is, options_of(range, after.loaded), "After");
    add(change.field, of_change, "Change, better in blue");
  }
  return all;
}

}  // namespace delos::report
