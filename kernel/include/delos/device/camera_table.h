// The parameters of a calibrated camera, which several plugins have in their tables.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numbers>

#include "delos/device/parameters.h"

namespace delos {

/// Tables of plugins that have a CameraModel.
struct CameraTable {
  /// What CameraModel reads, and the noise on the image.
  static constexpr ParamSpec kRows[] = {
      vector("resolution", "px", 2, "Width and height of the image.").at_least(1),
      number(
          "f_x", "px",
          "Focal length across, in pixels; 0: field_of_view, or focal and pitch, say "
          "it.")
          .initially(0)
          .at_least(0),
      number("f_y", "px", "Focal length down, in pixels; 0: as across.")
          .initially(0)
          .at_least(0),
      number("c_x", "px",
             "Where the optical axis meets the image, from its left edge; 0: in the "
             "middle.")
          .initially(0),
      number("c_y", "px", "The same from its upper edge; 0: in the middle.")
          .initially(0),
      number("field_of_view", "rad",
             "Angle across the width of an image without distortion, instead of f_x.")
          .initially(0)
          .between(0, 2 * std::numbers::pi),
      number("focal", "m", "Focal length of the lens, with pitch instead of f_x.")
          .initially(0)
          .between(0, 10),
      number("pitch", "m", "Width of a pixel, which is square.")
          .initially(0)
          .between(0, 1e-3),
      choice("distortion", "brown_conrady|rational|fisheye",
             "The lens's model; without coefficients a pinhole or an equidistant "
             "fisheye.")
          .initially("brown_conrady"),
      number("k1", "1", "Radial coefficient.").initially(0),
      number("k2", "1", "Radial coefficient.").initially(0),
      number("k3", "1", "Radial coefficient.").initially(0),
      number("k4", "1", "Radial coefficient of fisheye, or of rational's denominator.")
          .initially(0),
      number("k5", "1", "Radial coefficient of rational's denominator.").initially(0),
      number("k6", "1", "Radial coefficient of rational's denominator.").initially(0),
      number("p1", "1", "Tangential coefficient of brown_conrady and rational.")
          .initially(0),
      number("p2", "1", "Tangential coefficient of brown_conrady and rational.")
          .initially(0),
      number("half_angle", "rad",
             "Greatest angle to the optical axis that is seen: a round view within the "
             "image.")
          .initially(std::numbers::pi)
          .between(1e-6, std::numbers::pi),
      number("near", "m",
             "Least depth along the optical axis that is seen; a fisheye's least "
             "distance.")
          .initially(0.05)
          .at_least(1e-6),
      number("far", "m",
             "Greatest depth along the optical axis that is seen; a fisheye's greatest "
             "distance.")
          .initially(100)
          .at_least(1e-6),
      number("sigma", "px", "Standard deviation of a coordinate on the image.")
          .initially(0.1)
          .at_least(0),
  };

  /// A table of these rows and a plugin's own.
  template <std::size_t own>
  struct Table {
    ParamSpec rows[std::size(kRows) + own];
    [[nodiscard]] constexpr std::size_t size() const { return std::size(rows); }
    // NOLINTNEXTLINE(google-explicit-constructor): what DELOS_DEVICE_PLUGIN takes
    constexpr operator const ParamSpec*() const { return rows; }
  };
  template <std::size_t own>
  [[nodiscard]] static constexpr Table<own> with(const ParamSpec (&rows)[own]) {
    Table<own> all{};
    std::copy_n(kRows, std::size(kRows), all.rows);
    std::copy_n(rows, own, all.rows + std::size(kRows));
    return all;
  }
};

}  // namespace delos
