// A field over a sheet as a surface that is as high as its values.
#pragma once

#include "shapes/shape_mesh.h"
#include "shapes/sheet.h"

namespace delos::shapes {

/// How high a value stands above its sheet.
struct Heights {
  double low = 0, high = 1;  ///< values at no height, and at `size`; SI
  bool log10 = false;        ///< heights are in proportion to log10; then low > 0
  double size = 1;           ///< metres; negative: small values are peaks

  /// Metres; below `low` negative. 0 where low and high are one.
  [[nodiscard]] double of(double value) const;
};

/// Samples raised by their values, with triangles between four neighbours that all have
/// one: the surface is absent elsewhere.
/// @param value of a sample of the field; not finite where it has none
[[nodiscard]] ShapeMesh relief(const Sheet& sheet,
                               const std::function<double(std::size_t)>& value,
                               const Heights& heights);

}  // namespace delos::shapes
