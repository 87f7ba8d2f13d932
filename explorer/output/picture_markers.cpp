#include "output/picture_markers.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "output/picture_words.h"

namespace delos {
namespace {

constexpr Rgb kInk{0.1, 0.1, 0.1};
constexpr Rgb kPaper{1, 1, 1};
constexpr double kRadius = 6;
const TextStyle kLabel{.size = 12, .bold = true, .colour = kInk};

struct Spot {
  double x, y;
};

Spot spot_of(const Box& plot, const Slice& slice, std::size_t cell) {
  const std::size_t column = cell % slice.axis[0].count;
  const std::size_t row = cell / slice.axis[0].count;
  const auto along = slice.axis[0].fraction_of(static_cast<double>(column));
  const auto up = slice.axis[1].fraction_of(static_cast<double>(row));
  return {plot.x + plot.width * along, plot.bottom() - plot.height * up};
}

Box around(const Spot& spot) {
  return {spot.x - kRadius, spot.y - kRadius, 2 * kRadius, 2 * kRadius};
}

void draw_ring(Canvas& canvas, const Spot& at) {
  canvas.disc(at.x, at.y, kRadius, kInk);
  canvas.disc(at.x, at.y, kRadius - 1.6, kPaper);
  canvas.disc(at.x, at.y, 1.8, kInk);
}

void draw_cross(Canvas& canvas, const Spot& at) {
  const double arm = kRadius - 1.5;
  for (const auto& [colour, width] : {std::pair{kInk, 5.0}, std::pair{kPaper, 2.2}}) {
    canvas.line(at.x - arm, at.y - arm, at.x + arm, at.y + arm, colour, width);
    canvas.line(at.x - arm, at.y + arm, at.x + arm, at.y - arm, colour, width);
  }
}

void draw_label(Canvas& canvas, const Box& box, const std::string& text) {
  canvas.fill(box, kPaper, 0.88);
  canvas.text(box.x + box.width / 2, box.bottom() - 6, 0.5, text, kLabel);
}

/// The box beside a spot for a label: the first of four corners that lies in the plot
/// and meets nothing of what is taken; where none does, the first one, pushed into the
/// plot.
Box label_box(const Box& plot, const Spot& at, double width,
              const std::vector<Box>& taken) {
  constexpr double kHeight = 20, kGap = kRadius + 4;
  Box inside{plot.x + 3, plot.y + 3, plot.width - 6, plot.height - 6};
  for (const double y : {at.y - kGap - kHeight, at.y + kGap}) {
    for (const double x : {at.x + kGap, at.x - kGap - width, at.x - width / 2}) {
      const Box box{std::round(x), std::round(y), width, kHeight};
      const bool free = std::none_of(taken.begin(), taken.end(), [&](const Box& other) {
        return box.meets(other);
      });
      if (free && inside.contains(box)) return box;
    }
  }
  const double most_right = std::max(inside.x, inside.right() - width);
  const double most_down = std::max(inside.y, inside.bottom() - kHeight);
  return {std::round(std::clamp(at.x + kGap, inside.x, most_right)),
          std::round(std::clamp(at.y - kGap - kHeight, inside.y, most_down)), width,
          kHeight};
}

void draw_sentence(Canvas& canvas, const Box& plot, const std::string& text) {
  const double width = std::ceil(canvas.text_width(text, kLabel)) + 24;
  const double middle = plot.x + plot.width / 2;
  draw_label(canvas,
             {std::round(middle - width / 2), std::round(plot.y + plot.height / 2 - 10),
              width, 20},
             text);
}

}  // namespace

void draw_markers(Canvas& canvas, const Box& plot, const Box& cells, const Slice& slice,
                  bool all_equal, const std::string& unit) {
  if (!slice.best) {
    draw_sentence(canvas, cells, why_empty(slice));
    return;
  }
  const ExtremeWords words = extreme_words(slice, unit);
  if (all_equal) {
    const bool everywhere = slice.finite == slice.value.size();
    draw_sentence(canvas, cells,
                  words.best + (everywhere ? " everywhere" : " wherever it is finite"));
    return;
  }
  const Spot best = spot_of(cells, slice, *slice.best);
  const Spot worst = spot_of(cells, slice, *slice.worst);
  draw_cross(canvas, worst);
  draw_ring(canvas, best);
  std::vector<Box> taken = {around(best), around(worst)};
  for (const auto& [spot, text] : {std::pair{best, "best " + words.best},
                                   std::pair{worst, "worst " + words.worst}}) {
    const double width = std::ceil(canvas.text_width(text, kLabel)) + 12;
    taken.push_back(label_box(plot, spot, width, taken));
    draw_label(canvas, taken.back(), text);
  }
}

}  // namespace delos
