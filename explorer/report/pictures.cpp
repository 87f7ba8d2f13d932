#include "report/pictures.h"

#include <algorithm>
#include <cmath>

#include "delos/text/format.h"

namespace delos::report {
namespace {

/// A map that has been drawn says what it shows in this sentence.
std::string says(const Field& field, const FieldMap& map) {
  std::string text = "Map of " + field.metric + " of " + field.scene;
  if (!map.place.empty()) text += " at " + map.place;
  if (map.blind > 0)
    text += "; blind at " + std::to_string(map.blind) + " of " +
            std::to_string(map.samples) + " samples";
  return text;
}

Html caption(const std::string& name, const FieldMap& map) {
  std::string text = name;
  if (!map.place.empty()) text += (text.empty() ? "" : ", ") + map.place;
  if (map.blind > 0)
    text += ": blind at " + std::to_string(map.blind) + " of " +
            std::to_string(map.samples) + " samples (hatched)";
  if (map.solid > 0) text += "; solids are grey";
  return text;
}

Html one_map(const Field& field, const PictureOptions& slice,
             const ColourRange& colours, const std::vector<Marker>& markers,
             const std::vector<Marker>& around, const std::string& name) {
  const auto map = field_map(field, slice, colours);
  return map ? map_figure(*map, markers, around, says(field, *map), caption(name, *map))
             : Html();
}

Html figures(const Html& content) {
  return element("div", {{"class", "figures"}}, content);
}

std::vector<const Field*> fields_of(const std::vector<View>& views) {
  std::vector<const Field*> fields;
  for (const View& view : views) fields.push_back(&view.field);
  return fields;
}

/// The absolute change that a part of the finite samples doesn't exceed.
double quantile(const Field& field, double part) {
  std::vector<double> sizes;
  for (const double value : field.value)
    if (std::isfinite(value)) sizes.push_back(std::abs(value));
  if (sizes.empty()) return 0;
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(
                                      part * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

}  // namespace

View view_of(Field field, bool larger_is_better) {
  View view{std::move(field), {}};
  PictureOptions slice;
  slice.larger_is_better = larger_is_better;
  for (const SamplePart& part : view.field.samples.parts) {
    const auto* grid = std::get_if<GridShape>(&part.shape);
    const bool plane = std::holds_alternative<PlaneShape>(part.shape);
    if (!grid && !plane) continue;
    const bool flat =
        !grid || grid->counts[2] == 1 || grid->counts[0] == 1 || grid->counts[1] == 1;
    if (flat) {
      view.slices.push_back(slice);
      break;
    }
    // The middles of three slabs.
    slice.has_slice = true;
    double last = -1;
    for (const double at : {1 / 6.0, 3 / 6.0, 5 / 6.0}) {
      const double layer = std::round(at * static_cast<double>(grid->counts[2] - 1));
      if (layer == last) continue;
      last = layer;
      slice.slice_z = grid->origin.z() + layer * grid->step.z();
      view.slices.push_back(slice);
    }
    break;
  }
  return view;
}

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
  const double end = quantile(change.field, 0.98);
  change.colours = {-end, end, false, larger_is_better, true};
  for (std::size_t i = 0; i < before.value.size(); ++i) {
    const bool was = std::isfinite(before.value[i]), is = std::isfinite(after.value[i]);
    if (was == is) continue;
    ++(is ? change.gained : change.lost);
    change.field.value[i] = is == larger_is_better ? end : -end;
  }
  return change;
}

Html key_figures(const std::vector<const Field*>& fields,
                 const std::vector<std::string>& names, bool larger_is_better) {
  std::vector<FieldStatistics> all;
  for (const Field* field : fields) all.push_back(summarize(*field));
  const bool two = fields.size() == 2;
  std::vector<Html> head = {""};
  for (const std::string& name : names) head.emplace_back(name);
  if (two) head.emplace_back("change");
  std::vector<std::vector<Html>> rows;
  const auto add = [&](const char* name, auto value) {
    std::vector<Html> row = {name};
    for (const FieldStatistics& s : all)
      row.emplace_back(s.finite > 0 ? format_quantity(value(s), fields.front()->unit)
                                    : std::string("none"));
    if (two) {
      const double a = value(all[0]), b = value(all[1]);
      const bool known = all[0].finite > 0 && all[1].finite > 0 && a != 0;
      const double percent = 100 * (b / a - 1);
      const bool good = larger_is_better ? percent > 0 : percent < 0;
      const std::string text =
          (percent < 0 ? "−" : "+") + format_quantity(std::abs(percent), "1") + " %";
      row.push_back(!known ? Html("")
                    : percent == 0
                        ? Html("0 %")
                        : element("span", {{"class", good ? "good" : "bad"}}, text));
    }
    rows.push_back(std::move(row));
  };
  add("least", [](const FieldStatistics& s) { return s.min.value; });
  add("median", [](const FieldStatistics& s) { return s.median; });
  add("mean", [](const FieldStatistics& s) { return s.mean; });
  add(larger_is_better ? "95 % at least" : "95 % at most",
      [](const FieldStatistics& s) { return s.p95; });
  add("greatest", [](const FieldStatistics& s) { return s.max.value; });
  const auto count = [&](const char* name, auto value) {
    std::vector<Html> row = {name};
    for (const FieldStatistics& s : all) row.emplace_back(std::to_string(value(s)));
    if (two) {
      const auto a = static_cast<std::ptrdiff_t>(value(all[0])),
                 b = static_cast<std::ptrdiff_t>(value(all[1]));
      row.emplace_back(a == b ? ""
                              : (b > a ? "+" : "−") + std::to_string(std::abs(b - a)));
    }
    rows.push_back(std::move(row));
  };
  count("samples", [](const FieldStatistics& s) { return s.samples; });
  count("observable samples", [](const FieldStatistics& s) { return s.observable; });
  count("one direction short", [](const FieldStatistics& s) { return s.one_short; });
  return table(fields.front()->metric + ", over the samples at which it is finite",
               head, rows);
}

Html maps(const std::vector<View>& views, const std::vector<Marker>& markers) {
  const bool larger = !views.empty() && !views.front().slices.empty() &&
                      views.front().slices.front().larger_is_better;
  const ColourRange range = common_range(fields_of(views), larger);
  Html all;
  for (const View& view : views)
    for (const PictureOptions& slice : view.slices)
      all += one_map(view.field, slice, range, markers, markers, "");
  if (all.empty()) return {};
  return colour_legend(range, views.front().field.metric, views.front().field.unit) +
         figures(all);
}

Html maps(const std::vector<View>& before, const std::vector<View>& after,
          const std::vector<Marker>& were, const std::vector<Marker>& are,
          bool larger_is_better) {
  std::vector<const Field*> fields = fields_of(before);
  for (const Field* field : fields_of(after)) fields.push_back(field);
  const ColourRange range = common_range(fields, larger_is_better);
  std::vector<Change> changes;
  double end = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    changes.push_back(
        change_between(before[i].field, after[i].field, larger_is_better));
    end = std::max(end, changes.back().colours.high);
  }
  std::vector<Marker> around = were;
  around.insert(around.end(), are.begin(), are.end());
  const ColourRange of_change{-end, end, false, larger_is_better, true};
  Html all;
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (const PictureOptions& slice : before[i].slices) {
      all += one_map(before[i].field, slice, range, were, around, "Before");
      all += one_map(after[i].field, slice, range, are, around, "After");
      all += one_map(changes[i].field, slice, of_change, are, around, "Change");
    }
  }
  if (all.empty()) return {};
  const Field& first = before.front().field;
  return element("p", {{"class", "note"}}, "Before and after, to one scale:") +
         colour_legend(range, first.metric, first.unit) +
         element("p", {{"class", "note"}},
                 "Change, blue for better and red for worse; the ends are also for "
                 "larger changes, and for samples that are seen in one of both only:") +
         colour_legend(of_change, "change of " + first.metric, first.unit) +
         figures(all);
}

}  // namespace delos::report
