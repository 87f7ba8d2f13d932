// From values to colours, and from samples to what lies between them.
#pragma once

#include <string>
#include <vector>

#include "output/colour_map.h"
#include "output/slice.h"

namespace delos {

/// The values that a picture's colours stand for.
struct ColourScale {
  double low = 0, high = 0;  ///< SI; equal where all values are
  bool log10 = false;        ///< positions follow log10 of the value
  bool bright_high = false;  ///< the bright end is `high`, else `low`
  bool counts = false;       ///< whole numbers alone: nothing is between them
  bool change = false;       ///< from blue over white to red; blue where bright

  [[nodiscard]] bool flat() const { return !(high > low); }

  /// 0 at low, 1 at high; ½ on a flat scale. Values outside go to the nearer end.
  [[nodiscard]] double position(double value) const;

  [[nodiscard]] Rgb colour(double position) const {
    const double bright = bright_high ? position : 1 - position;
    return change ? red_to_blue(bright) : viridis(bright);
  }
};

/// The scale that just holds the slice's finite values, or the range asked for. log10
/// asks for positive ones: the others go to the low end, and where there are none the
/// scale is linear.
[[nodiscard]] ColourScale make_scale(const Slice& slice, const PictureOptions& options);

/// What fills a spot of a picture.
enum class Fill { colour, blind, unreached, solid };

struct Shade {
  Fill fill = Fill::blind;
  double position = 0;  ///< on the scale, where fill is colour
};

/// A slice's samples on a scale, readable between them.
class ShadedSlice {
 public:
  ShadedSlice(const Slice& slice, const ColourScale& scale);

  /// The cell that a spot lies in decides whether it is blind, since visibility has
  /// hard edges. Inside the finite region positions are bilinear between the samples;
  /// samples that are blind hand their weight to the others. Counts are those of the
  /// cell.
  /// @param column,row in samples: 0 is the first one's centre
  [[nodiscard]] Shade at(double column, double row) const;

 private:
  const Slice& slice_;
  bool counts_;
  std::vector<double> position_;  ///< NaN where not finite
};

}  // namespace delos
