#include "output/picture_layout.h"

#include <algorithm>
#include <cmath>

namespace delos {

PictureLayout lay_out_picture(const Slice& slice) {
  constexpr int kLeft = 84, kTop = 78, kRight = 142, kBottom = 92;
  constexpr double kWidest = 680, kHighest = 530, kLeast = 170;
  constexpr int kTitleRoom = 680;  // narrower images would cut most titles

  const double across = slice.axis[0].span(), up = slice.axis[1].span();
  const double scale = std::min(kWidest / across, kHighest / up);
  const double width = std::round(std::max(across * scale, kLeast));
  const double height = std::round(std::max(up * scale, kLeast));

  PictureLayout layout;
  const int needed = kLeft + static_cast<int>(width) + kRight;
  layout.width = std::max(needed, kTitleRoom);
  layout.height = kTop + static_cast<int>(height) + kBottom;
  const double x = kLeft + (layout.width - needed) / 2;
  layout.plot = {x, kTop, width, height};
  layout.bar = {layout.plot.right() + 26, kTop, 16, height};
  layout.to_scale = across * scale >= kLeast && up * scale >= kLeast;
  return layout;
}

}  // namespace delos
