#include "output/colour_map.h"

#include <algorithm>
#include <cmath>

namespace delos {

// Polynomial of degree 6 in t a channel, within 0.01 of the table.
//
// Source: van der Walt & Smith, viridis, matplotlib 1.5 (2015), CC0; fitted by
//         Zucker (2019), https://www.shadertoy.com/view/WlfXRN, CC0.
Rgb viridis(double t) {
  static constexpr Rgb kCoefficients[] = {
      {0.2777273272234177, 0.005407344544966578, 0.3340998053353061},
      {0.1050930431085774, 1.404613529898575, 1.384590162594685},
      {-0.3308618287255563, 0.214847559468213, 0.09509516302823659},
      {-4.634230498983486, -5.799100973351585, -19.33244095627987},
      {6.228269936347081, 14.17993336680509, 56.69055260068105},
      {4.776384997670288, -13.74514537774601, -65.35303263337234},
      {-5.435455855934631, 4.645852612178535, 26.3124352495832},
  };
  t = std::clamp(t, 0.0, 1.0);
  Rgb colour = kCoefficients[6];
  for (int i = 5; i >= 0; --i) {
    colour.r = colour.r * t + kCoefficients[i].r;
    colour.g = colour.g * t + kCoefficients[i].g;
    colour.b = colour.b * t + kCoefficients[i].b;
  }
  return {std::clamp(colour.r, 0.0, 1.0), std::clamp(colour.g, 0.0, 1.0),
          std::clamp(colour.b, 0.0, 1.0)};
}

// Linear between the five colours of the scheme RdBu.
//
// Source: Brewer (2002), https://colorbrewer2.org, Apache-2.0.
Rgb red_to_blue(double t) {
  static constexpr Rgb kColours[] = {{178 / 255., 24 / 255., 43 / 255.},
                                     {244 / 255., 165 / 255., 130 / 255.},
                                     {247 / 255., 247 / 255., 247 / 255.},
                                     {146 / 255., 197 / 255., 222 / 255.},
                                     {33 / 255., 102 / 255., 172 / 255.}};
  const double at = 4 * std::clamp(t, 0.0, 1.0);
  const int left = std::min(static_cast<int>(at), 3);
  const Rgb &a = kColours[left], &b = kColours[left + 1];
  const double part = at - left;
  return {std::lerp(a.r, b.r, part), std::lerp(a.g, b.g, part),
          std::lerp(a.b, b.b, part)};
}

}  // namespace delos
