#include "output/shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace delos {

double ColourScale::position(double value) const {
  if (flat()) return 0.5;
  if (value <= low) return 0;
  if (value >= high) return 1;
  if (log10) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

ColourScale make_scale(const Slice& slice, const PictureOptions& options) {
  ColourScale scale;
  scale.bright_high = options.larger_is_better;
  const auto widen = [&](bool positive_only) {
    bool any = false;
    for (const double value : slice.value) {
      if (!std::isfinite(value) || (positive_only && value <= 0)) continue;
      scale.low = any ? std::min(scale.low, value) : value;
      scale.high = any ? std::max(scale.high, value) : value;
      any = true;
    }
    return any;
  };
  scale.change = options.change;
  scale.log10 = options.log10 && !options.change && widen(true);
  if (!scale.log10) widen(false);
  if (options.range) std::tie(scale.low, scale.high) = *options.range;

  // Differences in the last digits are rounding, and colours would make them a
  // landscape.
  const double size = std::max(std::abs(scale.low), std::abs(scale.high));
  if (scale.high - scale.low <= 1e-12 * size) scale.high = scale.low;
  // No change is in the middle.
  if (scale.change && size > 0) {
    scale.low = -size;
    scale.high = size;
  }
  scale.counts = std::all_of(slice.value.begin(), slice.value.end(), [](double value) {
    return !std::isfinite(value) || value == std::round(value);
  });
  return scale;
}

ShadedSlice::ShadedSlice(const Slice& slice, const ColourScale& scale)
    : slice_(slice), counts_(scale.counts) {
  position_.reserve(slice.value.size());
  for (const double value : slice.value) {
    position_.push_back(std::isfinite(value)
                            ? scale.position(value)
                            : std::numeric_limits<double>::quiet_NaN());
  }
}

Shade ShadedSlice::at(double column, double row) const {
  const int columns = slice_.axis[0].count, rows = slice_.axis[1].count;
  const auto nearest = [](double x, int count) {
    return std::clamp(static_cast<int>(std::floor(x + 0.5)), 0, count - 1);
  };
  const std::size_t own = slice_.cell(nearest(column, columns), nearest(row, rows));
  if (slice_.solid[own] != 0) return {Fill::solid, 0};
  if (std::isnan(position_[own]))
    return {slice_.reached[own] != 0 ? Fill::blind : Fill::unreached, 0};
  if (counts_) return {Fill::colour, position_[own]};

  const int left = std::clamp(static_cast<int>(std::floor(column)), 0, columns - 1);
  const int below = std::clamp(static_cast<int>(std::floor(row)), 0, rows - 1);
  const double right_weight = std::clamp(column - left, 0.0, 1.0);
  const double above_weight = std::clamp(row - below, 0.0, 1.0);
  double sum = 0, weights = 0;
  for (const int dx : {0, 1}) {
    for (const int dy : {0, 1}) {
      const double weight = (dx == 1 ? right_weight : 1 - right_weight) *
                            (dy == 1 ? above_weight : 1 - above_weight);
      if (weight == 0) continue;
      const double position = position_[slice_.cell(std::min(left + dx, columns - 1),
                                                    std::min(below + dy, rows - 1))];
      if (std::isnan(position)) continue;
      sum += weight * position;
      weights += weight;
    }
  }
  return {Fill::colour, sum / weights};
}

}  // namespace delos
