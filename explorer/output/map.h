// Slices of fields as bare colours, for pages that draw axes and words themselves.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "delos/field/field.h"
#include "output/write.h"

namespace delos {

/// What colours stand for, the same in all maps that are compared.
struct ColourRange {
  double low = 0, high = 0;       ///< SI; values beyond take the nearer end's colour
  bool log10 = false;             ///< colours follow log10 of the value; low > 0
  bool larger_is_better = false;  ///< bright, or blue, is always good
  bool change = false;  ///< values are changes, low = −high: blue better, red worse
};

/// One side of a map: samples from low to high, metres.
struct MapSide {
  std::string name;  ///< "x", "y", "z" in the world, or "u", "v" along a plane's edge
  double low = 0, high = 0;
};

/// A slice of a field.
struct FieldMap {
  std::string place;   ///< "z = 0.24 m"; may be empty
  MapSide across, up;  ///< to the right, upwards
  /// The colours alone as a PNG in a data URI, hatched where the slice is blind, grey
  /// where it is solid.
  std::string image;
  std::size_t samples = 0, blind = 0, solid = 0;
};

/// @param slice its slice_z, has_slice and larger_is_better choose the slice
/// @returns nullopt where neither a volume nor a plane is among the samples
/// @cost a PNG of 400 pixels along its longer side
[[nodiscard]] std::optional<FieldMap> field_map(const Field& field,
                                                const PictureOptions& slice,
                                                const ColourRange& colours);

/// The colours from low to high, left to right, as a PNG in a data URI.
[[nodiscard]] std::string colour_strip(const ColourRange& colours);

/// Where a value stands between low and high, 0 to 1.
[[nodiscard]] double colour_position(const ColourRange& colours, double value);

/// The colour of a value: red, green and blue, sRGB, each in [0, 1].
/// @pre finite
[[nodiscard]] DELOS_API std::array<double, 3> colour_of(const ColourRange& colours,
                                                        double value);

}  // namespace delos
