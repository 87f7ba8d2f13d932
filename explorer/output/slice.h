// The flat piece of a field that a picture shows.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "delos/field/field.h"
#include "output/write.h"

namespace delos {

/// One side of a slice: samples at first, first + step, …
struct SliceAxis {
  std::string name;  ///< "x", "y", "z" in the world, or "u", "v" along a plane's edge
  int count = 1;     ///< samples
  double first = 0;  ///< metres
  double step = 1;   ///< metres between samples, > 0

  /// What is shown, metres: from the first sample to the last one. A single sample
  /// stands for a cell of a step's width.
  [[nodiscard]] double low() const { return count > 1 ? first : first - step / 2; }
  [[nodiscard]] double span() const { return count > 1 ? step * (count - 1) : step; }

  /// From the shown range, 0 at its low end and 1 at its high one, to samples, and
  /// back.
  [[nodiscard]] double sample_at(double fraction) const {
    return count > 1 ? fraction * (count - 1) : fraction - 0.5;
  }
  [[nodiscard]] double fraction_of(double sample) const {
    return count > 1 ? sample / (count - 1) : sample + 0.5;
  }
};

/// Samples of a volume's layer or of a plane, as rows and columns.
struct Slice {
  std::string place;               ///< "z = 0.24 m", a part's name; may be empty
  std::array<SliceAxis, 2> axis;   ///< to the right, upwards
  std::vector<std::size_t> index;  ///< points of the field; to the right varies fastest
  std::vector<double> value;       ///< SI; not finite where blind
  std::vector<unsigned char> reached;  ///< 0: a cancelled evaluation didn't get there
  std::vector<unsigned char> solid;    ///< 1: inside a solid, where no target can be
  std::optional<std::size_t> best, worst;  ///< cells; empty where nothing is finite
  std::size_t finite = 0;                  ///< cells

  [[nodiscard]] std::size_t cell(int column, int row) const {
    return static_cast<std::size_t>(row) * axis[0].count + column;
  }
};

/// Whether a volume or plane is among the samples.
[[nodiscard]] bool has_slice(const Samples& samples);

/// The first volume or plane of the field, cut as the options say: a volume's
/// horizontal layer nearest slice_z, else the layer through its best sample. A volume
/// that is one sample wide along x or y shows its face instead, unless a height is
/// given.
/// @pre has_slice(field.samples)
[[nodiscard]] Slice make_slice(const Field& field, const PictureOptions& options);

}  // namespace delos
