#include "output/picture_cells.h"

#include <algorithm>
#include <cmath>

namespace delos {
namespace {

constexpr Rgb kUnreached{0.95, 0.95, 0.95};
constexpr Rgb kSolid{0.5, 0.5, 0.5};
constexpr Rgb kEdge{0.33, 0.33, 0.33};

/// Diagonal lines, two pixels wide with soft sides, every nine pixels.
Rgb hatching(int x, int y) {
  const int phase = (x + y) % 9;
  const double ink = phase == 0 ? 1 : phase == 1 || phase == 8 ? 0.45 : 0;
  const double grey = 0.89 - 0.19 * ink;
  return {grey, grey, grey};
}

Rgb ink(const Shade& shade, const ColourScale& scale, int x, int y) {
  switch (shade.fill) {
    case Fill::colour:
      return scale.colour(shade.position);
    case Fill::blind:
      return hatching(x, y);
    case Fill::unreached:
      return kUnreached;
    case Fill::solid:
      return kSolid;
  }
  return kUnreached;
}

/// A line wherever finite and other cells meet.
void outline_regions(Canvas& canvas, const Box& plot, const Slice& slice) {
  const int columns = slice.axis[0].count, rows = slice.axis[1].count;
  // Cells of a few pixels would drown in their own outlines.
  if (plot.width < 4.0 * columns || plot.height < 4.0 * rows) return;
  const auto finite = [&](int column, int row) {
    return std::isfinite(slice.value[slice.cell(column, row)]);
  };
  // The pixel at which a cell begins; cells at the border are cut by the plot.
  const auto x = [&](int column) {
    const double at = slice.axis[0].fraction_of(column - 0.5);
    return std::round(plot.x + plot.width * std::clamp(at, 0.0, 1.0));
  };
  const auto y = [&](int row) {
    const double at = slice.axis[1].fraction_of(row - 0.5);
    return std::round(plot.bottom() - plot.height * std::clamp(at, 0.0, 1.0));
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const bool own = finite(column, row);
      if (column + 1 < columns && finite(column + 1, row) != own) {
        const double at = x(column + 1) + 0.5;
        canvas.line(at, y(row) + 0.5, at, y(row + 1) + 0.5, kEdge);
      }
      if (row + 1 < rows && finite(column, row + 1) != own) {
        const double at = y(row + 1) + 0.5;
        canvas.line(x(column) + 0.5, at, x(column + 1) + 0.5, at, kEdge);
      }
    }
  }
}

}  // namespace

void paint_cells(Canvas& canvas, const Box& plot, const Slice& slice,
                 const ColourScale& scale) {
  const ShadedSlice shaded(slice, scale);
  for (int py = 0; py < plot.height; ++py) {
    const double row = slice.axis[1].sample_at(1 - (py + 0.5) / plot.height);
    for (int px = 0; px < plot.width; ++px) {
      const double column = slice.axis[0].sample_at((px + 0.5) / plot.width);
      const Shade shade = shaded.at(column, row);
      const int x = static_cast<int>(plot.x) + px, y = static_cast<int>(plot.y) + py;
      canvas.set(x, y, ink(shade, scale, x, y));
    }
  }
  outline_regions(canvas, plot, slice);
}

void paint_blind(Canvas& canvas, const Box& box) {
  for (int y = static_cast<int>(box.y); y < box.bottom(); ++y)
    for (int x = static_cast<int>(box.x); x < box.right(); ++x)
      canvas.set(x, y, hatching(x, y));
}

void paint_unreached(Canvas& canvas, const Box& box) { canvas.fill(box, kUnreached); }

void paint_solid(Canvas& canvas, const Box& box) { canvas.fill(box, kSolid); }

}  // namespace delos
