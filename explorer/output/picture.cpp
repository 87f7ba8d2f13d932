#include "output/picture.h"

#include <algorithm>
#include <cmath>

#include "output/picture_axes.h"
#include "output/picture_cells.h"
#include "output/picture_layout.h"
#include "output/picture_markers.h"
#include "output/picture_words.h"

namespace delos {
namespace {

constexpr double kMargin = 22;
const TextStyle kTitle{.size = 16, .bold = true, .colour = {0.1, 0.1, 0.1}};
const TextStyle kSmall{.size = 12, .colour = {0.38, 0.38, 0.38}};

/// Swatches for what isn't a colour of the scale. @returns where the legend ends
double draw_legend(Canvas& canvas, double x, double baseline, const Slice& slice) {
  constexpr Rgb kFrame{0.33, 0.33, 0.33};
  const auto reached = static_cast<std::size_t>(
      std::count(slice.reached.begin(), slice.reached.end(), 1));
  std::size_t solid = 0, blind = 0;
  for (std::size_t i = 0; i < slice.value.size(); ++i) {
    if (slice.solid[i] != 0)
      ++solid;
    else if (slice.reached[i] != 0 && !std::isfinite(slice.value[i]))
      ++blind;
  }
  const std::size_t unreached = slice.value.size() - reached;
  const auto entry = [&](std::size_t cells, const std::string& what, auto paint) {
    if (cells == 0) return;
    const Box swatch{std::round(x), baseline - 11, 22, 13};
    paint(canvas, swatch);
    canvas.outline(
        {swatch.x + 0.5, swatch.y + 0.5, swatch.width - 1, swatch.height - 1}, kFrame);
    const std::string text = what + " " + share_text(cells, slice.value.size());
    canvas.text(swatch.right() + 7, baseline, 0, text, kSmall);
    x = swatch.right() + 7 + canvas.text_width(text, kSmall) + 18;
  };
  entry(blind, "blind", paint_blind);
  entry(solid, "solid", paint_solid);
  entry(unreached, "not evaluated", paint_unreached);
  return x;
}

/// The scene's name gives way where the title is too long: the rest says what is shown.
void draw_title(Canvas& canvas, const Title& title) {
  const double room = canvas.width() - 2 * kMargin;
  std::string text = title.rest;
  if (!title.scene.empty()) {
    text = " — " + title.rest;
    const double left = std::max(0.0, room - canvas.text_width(text, kTitle));
    text = canvas.fitted(title.scene, left, kTitle) + text;
  }
  canvas.text(kMargin, 32, 0, canvas.fitted(text, room, kTitle), kTitle);
}

}  // namespace

void write_picture(const Field& field, const PictureOptions& options,
                   std::ostream& out) {
  const Slice slice = make_slice(field, options);
  const ColourScale scale = make_scale(slice, options);
  const DisplayUnit shown =
      display_unit(std::max(std::abs(scale.low), std::abs(scale.high)), field.unit);

  // The texts say how much room they need, and only then the image has a size.
  Canvas ruler(1, 1);
  const PictureFrame frame = picture_frame(slice, options.devices);
  const Box sketch = lay_out_picture(slice, frame, {0, 0}).plot;
  const ScaleText across = axis_text(ruler, slice, frame, 0, sketch.width);
  const ScaleText up = axis_text(ruler, slice, frame, 1, sketch.height);
  const ScaleText values =
      bar_text(scale, (options.change ? "difference of " : "") + field.metric,
               field.unit, shown, sketch.height);
  const PictureLayout layout = lay_out_picture(
      slice, frame,
      {widest(ruler, up) + 38, slice.best ? widest(ruler, values) + 34 : 0});

  Canvas canvas(layout.width, layout.height);
  const double right = layout.width - kMargin;
  draw_title(canvas, title_of(field, slice, shown.name, options));
  canvas.text(kMargin, 54, 0,
              canvas.fitted(subtitle(field, options), right - kMargin, kSmall), kSmall);

  paint_cells(canvas, layout.cells, slice, scale);
  draw_axes(canvas, layout.plot, frame, across, up);
  if (slice.best) draw_colour_bar(canvas, layout.bar, scale, values);
  draw_devices(canvas, layout.plot, frame);
  draw_markers(canvas, layout.plot, layout.cells, slice, scale.flat(), field.unit);

  const double baseline = layout.height - 18;
  const double legend_end = draw_legend(canvas, kMargin, baseline, slice);
  canvas.text(
      right, baseline, 1,
      canvas.fitted(footnote(field, layout.to_scale), right - legend_end, kSmall),
      kSmall);
  canvas.write_png(out);
}

}  // namespace delos
