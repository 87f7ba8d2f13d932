// What a picture's plot shows: the slice, and the devices around it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "output/canvas.h"
#include "output/marker.h"
#include "output/slice.h"

namespace delos {

/// Along one side of the plot, metres.
struct FrameSide {
  double low, span;
  /// 0 at the low end, 1 at the high one.
  [[nodiscard]] double fraction_of(double metres) const {
    return (metres - low) / span;
  }
};

struct PictureFrame {
  std::array<FrameSide, 2> side;  ///< to the right, upwards
  std::array<int, 2> axis{};      ///< of the world, where there are devices
  std::vector<Marker> devices;    ///< within the frame

  /// The part of a plot that the slice fills, in whole pixels.
  [[nodiscard]] Box slice_box(const Box& plot, const Slice& slice) const;
};

/// The slice, and the devices that are no farther from it than it is large; none where
/// the slice is tilted in the world.
[[nodiscard]] PictureFrame picture_frame(const Slice& slice,
                                         const std::vector<Marker>& devices);

/// Each device, a line towards where it looks, and its name where there are few.
void draw_devices(Canvas& canvas, const Box& plot, const PictureFrame& frame);

}  // namespace delos
