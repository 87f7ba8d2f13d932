#include "output/picture_layout.h"

#include <algorithm>
#include <cmath>

namespace delos {

PictureLayout lay_out_picture(const Slice& slice, const PictureFrame& frame,
                              const SideText& text) {
  constexpr int kTop = 78, kBottom = 92, kSide = 22, kBarGap = 26, kBarWidth = 16;
  constexpr double kWidest = 680, kHighest = 530, kLeast = 170;
  constexpr int kTitleRoom = 680;  // narrower images would cut most titles

  const double across = frame.side[0].span, up = frame.side[1].span;
  const double scale = std::min(kWidest / across, kHighest / up);
  const double width = std::round(std::max(across * scale, kLeast));
  const double height = std::round(std::max(up * scale, kLeast));

  const int left = kSide + static_cast<int>(std::ceil(text.left));
  int right = kSide;
  if (text.right > 0) right += kBarGap + kBarWidth + static_cast<int>(text.right);
  const int needed = left + static_cast<int>(width) + right;

  PictureLayout layout;
  layout.width = std::max(needed, kTitleRoom);
  layout.height = kTop + static_cast<int>(height) + kBottom;
  const int margin = (layout.width - needed) / 2;
  layout.plot = {static_cast<double>(left + margin), kTop, width, height};
  layout.bar = {layout.plot.right() + kBarGap, kTop, kBarWidth, height};
  layout.cells = frame.slice_box(layout.plot, slice);
  layout.to_scale = slice.axis[0].count == 1 || slice.axis[1].count == 1 ||
                    std::min(across, up) * scale >= kLeast;
  return layout;
}

}  // namespace delos
