#include "render/legend.h"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "delos/text/format.h"
#include "output/canvas.h"
#include "output/ticks.h"

namespace delos::render {
namespace {

struct Destroy {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

/// Cairo's pixels of a picture, which are given back at the end.
class Writing {
 public:
  explicit Writing(Picture& picture)
      : picture_(picture),
        surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width,
                                            picture.height)),
        context_(cairo_create(surface_.get())) {
    each([](unsigned char* pixel, const unsigned char* rgb) {
      for (int c = 0; c < 3; ++c) pixel[c] = rgb[2 - c];  // blue first
    });
    use_plain_fonts(context_.get());
  }
  ~Writing() {
    each([](const unsigned char* pixel, unsigned char* rgb) {
      for (int c = 0; c < 3; ++c) rgb[c] = pixel[2 - c];
    });
  }
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;

  void fill(double x, double y, double width, double height, const Colour& colour) {
    use(colour);
    cairo_rectangle(context_.get(), x, y, width, height);
    cairo_fill(context_.get());
  }

  /// @param y of its baseline @param halo what it is written on, or null
  void text(double x, double y, const std::string& words, const Colour& colour,
            double size = 13, bool bold = false, bool centred = false,
            const Colour* halo = nullptr) {
    cairo_t* c = context_.get();
    cairo_select_font_face(c, "sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(c, size);
    cairo_text_extents_t extents;
    cairo_text_extents(c, words.c_str(), &extents);
    cairo_move_to(c, centred ? x - extents.x_advance / 2 : x, y);
    if (halo) {
      use(*halo);
      cairo_text_path(c, words.c_str());
      cairo_set_line_width(c, 3);
      cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
      cairo_stroke_preserve(c);
      use(colour);
      cairo_fill(c);
    } else {
      use(colour);
      cairo_show_text(c, words.c_str());
    }
  }

 private:
  void use(const Colour& c) { cairo_set_source_rgb(context_.get(), c[0], c[1], c[2]); }

  template <class Copy>
  void each(Copy copy) {
    cairo_surface_flush(surface_.get());
    unsigned char* data = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    for (int y = 0; y < picture_.height; ++y)
      for (int x = 0; x < picture_.width; ++x)
        copy(data + static_cast<std::ptrdiff_t>(y) * stride + 4 * x,
             picture_.pixels.data() +
                 3 * (static_cast<std::size_t>(y) * picture_.width + x));
    cairo_surface_mark_dirty(surface_.get());
  }

  Picture& picture_;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

struct Bar {
  double x, top, height;
  static constexpr double kWidth = 16;
};

/// Round values that aren't too near to the ends, which are labelled themselves.
void write_ticks(Writing& writing, const Bar& bar, const Ground& ground,
                 const ColourRange& colours, const std::string& unit) {
  const DisplayUnit shown =
      display_unit(std::max(std::abs(colours.low), std::abs(colours.high)), unit);
  const auto place = [&](double value) {
    return bar.top + bar.height * (1 - colour_position(colours, value));
  };
  const auto label = [&](double value, const std::string& words, bool bold) {
    writing.fill(bar.x + Bar::kWidth, std::round(place(value)) - 0.5, 5, 1,
                 ground.text);
    writing.text(bar.x + Bar::kWidth + 8, place(value) + 4.5, words, ground.text, 12,
                 bold);
  };
  for (const double end : {colours.low, colours.high})
    label(end, format_quantity(end, unit), true);
  const bool log = colours.log10;
  for (const Tick& tick :
       log ? log_ticks(colours.low, colours.high, 5, unit)
           : linear_ticks(colours.low * shown.factor, colours.high * shown.factor, 5)) {
    const double value = log ? tick.value : tick.value / shown.factor;
    const double y = place(value);
    if (y > bar.top + 15 && y < bar.top + bar.height - 15)
      label(value, tick.label, false);
  }
}

}  // namespace

void draw_legend(Picture& picture, const Ground& ground, const LegendText& text,
                 const std::optional<ColourRange>& colours,
                 const std::vector<double>& marks, const std::vector<Label>& labels) {
  Writing writing(picture);
  for (const Label& label : labels)
    writing.text(label.spot.x, label.spot.y - 24, label.text, ground.text, 11, false,
                 true, &ground.background);
  writing.text(16, 26, text.title, ground.text, 16, true, false, &ground.background);

  const Bar bar{picture.width - double(kLegend) + 10, 64,
                std::min(240.0, picture.height - 150.0)};
  writing.text(bar.x, 26, text.metric, ground.text, 13, true);
  if (colours) {
    for (int y = 0; y < static_cast<int>(bar.height); ++y) {
      const double part = 1 - (y + 0.5) / bar.height;
      const double value =
          colours->log10 ? colours->low * std::pow(colours->high / colours->low, part)
                         : colours->low + part * (colours->high - colours->low);
      writing.fill(bar.x, bar.top + y, Bar::kWidth, 1, colour_of(*colours, value));
    }
    const DisplayUnit shown = display_unit(
        std::max(std::abs(colours->low), std::abs(colours->high)), text.unit);
    writing.text(bar.x, 43,
                 (shown.name.empty() ? "" : "in " + shown.name) +
                     std::string(colours->log10 ? " (log)" : ""),
                 ground.text, 12);
    write_ticks(writing, bar, ground, *colours, text.unit);
    for (const double mark : marks)
      writing.fill(bar.x - 5,
                   bar.top + bar.height * (1 - colour_position(*colours, mark)) - 1,
                   Bar::kWidth + 5, 2, ground.text);
  }
  const double y = bar.top + bar.height + 24;
  for (int j = 0; j < 16; ++j)
    for (int i = 0; i < 16; ++i)
      writing.fill(bar.x + i, y + j, 1, 1,
                   hatch(ground, static_cast<int>(bar.x) + i, static_cast<int>(y) + j));
  writing.text(bar.x + 22, y + 6, "blind: " + std::to_string(text.blind), ground.text,
               11);
  writing.text(bar.x + 22, y + 19, "of " + std::to_string(text.samples), ground.text,
               11);
}

std::string png_of(const Picture& picture) {
  const std::unique_ptr<cairo_surface_t, Destroy> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height));
  unsigned char* data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < 3; ++c)
        data[static_cast<std::ptrdiff_t>(y) * stride + 4 * x + c] =
            picture
                .pixels[3 * (static_cast<std::size_t>(y) * picture.width + x) + 2 - c];
  cairo_surface_mark_dirty(surface.get());
  std::string png;
  const auto write = [](void* to, const unsigned char* bytes, unsigned length) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), length);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_write_to_png_stream(surface.get(), write, &png);
  return png;
}

}  // namespace delos::render
