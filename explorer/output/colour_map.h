// Colours for numbers.
#pragma once

namespace delos {

/// Red, green and blue, sRGB, each in [0, 1].
struct Rgb {
  double r, g, b;
};

/// viridis: perceptually uniform, readable to the colour-blind and in grey. Dark violet
/// at 0 over green to bright yellow at 1; t is clamped.
[[nodiscard]] Rgb viridis(double t);

/// Red at 0 over nearly white at ½ to blue at 1, for what may fall or rise; readable to
/// the colour-blind. t is clamped.
[[nodiscard]] Rgb red_to_blue(double t);

}  // namespace delos
