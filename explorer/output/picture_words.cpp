#include "output/picture_words.h"

#include <algorithm>
#include <cmath>

#include "delos/text/format.h"
#include "delos/text/number_text.h"
#include "delos/text/numbers.h"

namespace delos {

std::string share_text(std::size_t part, std::size_t whole) {
  if (part == whole) return "100 %";
  const double share = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  if (part > 0 && share < 1) return "< 1 %";
  if (share > 99) return "> 99 %";
  return with_decimals(share, 0) + " %";
}

Title title_of(const Field& field, const Slice& slice, const std::string& unit,
               const PictureOptions& options) {
  Title title{one_line(field.scene),
              (options.change ? "difference of " : "") + one_line(field.metric)};
  if (!unit.empty()) title.rest += " [" + unit + "]";
  if (!slice.place.empty()) title.rest += ", " + slice.place;
  return title;
}

std::string subtitle(const Field& field, const PictureOptions& options) {
  const FieldStatistics s = options.whole.value_or(summarize(field));
  std::string text;
  if (options.change && s.finite > 0)
    return "Whole field: " + format_quantity(s.min.value, field.unit) + " to " +
           format_quantity(s.max.value, field.unit) + ", median " +
           format_quantity(s.median, field.unit) + "; both have a value at " +
           share_text(s.finite, s.samples) + " of " + grouped(s.samples) + " samples";
  if (s.finite > 0) {
    text = "Whole field: median " + format_quantity(s.median, field.unit) +
           (s.larger_is_better ? ", 95 % at least " : ", 95 % up to ") +
           format_quantity(s.p95, field.unit) + "; ";
  } else {
    text = "Whole field: ";
  }
  if (s.volume)
    text +=
        with_decimals(100 * s.volume->observable, 1) + " % of the volume observable";
  else
    text += share_text(s.observable, s.samples) + " of " + grouped(s.samples) +
            (s.samples == 1 ? " sample observable" : " samples observable");
  if (field.cancelled)
    text += "; cancelled after " + grouped(field.evaluated) + " samples";
  return text;
}

std::string footnote(const Field& field, bool to_scale) {
  std::string text;
  const auto starts = [&](const char* prefix) {
    return field.metric.rfind(prefix, 0) == 0;
  };
  if (starts("sigma") || starts("eig"))
    text = "Scatter only: a bias that isn't modelled comes on top.";
  if (!to_scale)
    text += (text.empty() ? "" : " ") + std::string{"The axes differ in scale."};
  return text;
}

std::string why_empty(const Slice& slice) {
  const auto reached = static_cast<std::size_t>(
      std::count(slice.reached.begin(), slice.reached.end(), 1));
  if (reached == 0) return "Cancelled before this slice was evaluated";
  if (reached == 1 && slice.value.size() == 1)
    return "Blind: the only sample has no finite value";
  return "Blind everywhere: none of " + grouped(reached) +
         " samples has a finite value";
}

ExtremeWords extreme_words(const Slice& slice, const std::string& unit) {
  const double best = slice.value[*slice.best], worst = slice.value[*slice.worst];
  ExtremeWords words;
  for (int digits = 3; digits <= 17; ++digits) {
    words = {format_quantity(best, unit, digits), format_quantity(worst, unit, digits)};
    if (best == worst || words.best != words.worst) break;
  }
  return words;
}

}  // namespace delos
