#include "output/canvas.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <ostream>

namespace delos {
namespace {

void set_source(cairo_t* c, const Rgb& colour, double opacity = 1) {
  cairo_set_source_rgba(c, colour.r, colour.g, colour.b, opacity);
}

std::uint32_t channel(double value) {
  return static_cast<std::uint32_t>(std::lround(255 * value));
}

}  // namespace

void use_plain_fonts(cairo_t* context) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_SLIGHT);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
}

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      context_(cairo_create(surface_.get())) {
  use_plain_fonts(context_.get());
  fill({0, 0, double(width), double(height)}, {1, 1, 1});
}

void Canvas::fill(const Box& box, const Rgb& colour, double opacity) {
  set_source(context_.get(), colour, opacity);
  cairo_rectangle(context_.get(), box.x, box.y, box.width, box.height);
  cairo_fill(context_.get());
}

void Canvas::outline(const Box& box, const Rgb& colour, double line_width) {
  set_source(context_.get(), colour);
  cairo_set_line_width(context_.get(), line_width);
  cairo_rectangle(context_.get(), box.x, box.y, box.width, box.height);
  cairo_stroke(context_.get());
}

void Canvas::line(double x0, double y0, double x1, double y1, const Rgb& colour,
                  double line_width) {
  set_source(context_.get(), colour);
  cairo_set_line_width(context_.get(), line_width);
  cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_SQUARE);
  cairo_move_to(context_.get(), x0, y0);
  cairo_line_to(context_.get(), x1, y1);
  cairo_stroke(context_.get());
}

void Canvas::disc(double x, double y, double radius, const Rgb& colour) {
  set_source(context_.get(), colour);
  cairo_arc(context_.get(), x, y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(context_.get());
}

void Canvas::set(int x, int y, const Rgb& colour) {
  cairo_surface_flush(surface_.get());
  unsigned char* row =
      cairo_image_surface_get_data(surface_.get()) +
      static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_.get());
  reinterpret_cast<std::uint32_t*>(row)[x] =
      channel(colour.r) << 16 | channel(colour.g) << 8 | channel(colour.b);
  cairo_surface_mark_dirty_rectangle(surface_.get(), x, y, 1, 1);
}

double Canvas::text_width(const std::string& text, const TextStyle& style) {
  use(style);
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), text.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(double x, double y, double align, const std::string& text,
                  const TextStyle& style) {
  const double start = x - align * text_width(text, style);
  set_source(context_.get(), style.colour);
  cairo_move_to(context_.get(), start, y);
  cairo_show_text(context_.get(), text.c_str());
}

void Canvas::text_upwards(double x, double y, const std::string& text,
                          const TextStyle& style) {
  cairo_save(context_.get());
  cairo_translate(context_.get(), x, y);
  cairo_rotate(context_.get(), -std::numbers::pi / 2);
  this->text(0, 0, 0.5, text, style);
  cairo_restore(context_.get());
}

std::string Canvas::fitted(std::string text, double width, const TextStyle& style) {
  if (text_width(text, style) <= width) return text;
  while (!text.empty() && text_width(text + "…", style) > width) {
    // A whole character of UTF-8: its last byte and the ones that it continues.
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80)
      text.pop_back();
    text.pop_back();
  }
  return text + "…";
}

void Canvas::write_png(std::ostream& out) const {
  cairo_surface_flush(surface_.get());
  const auto write = [](void* stream, const unsigned char* bytes, unsigned length) {
    auto& to = *static_cast<std::ostream*>(stream);
    to.write(reinterpret_cast<const char*>(bytes), length);
    return to ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
  };
  if (cairo_surface_write_to_png_stream(surface_.get(), write, &out) !=
      CAIRO_STATUS_SUCCESS)
    out.setstate(std::ios::failbit);
}

void Canvas::use(const TextStyle& style) {
  cairo_select_font_face(
      context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
      style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), style.size);
}

}  // namespace delos
