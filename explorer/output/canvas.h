// Drawing in pixels: what the pictures need of Cairo.
#pragma once

#include <cairo.h>

#include <iosfwd>
#include <memory>
#include <string>

#include "output/colour_map.h"

namespace delos {

/// A rectangle in pixels, y downwards.
struct Box {
  double x = 0, y = 0, width = 0, height = 0;

  [[nodiscard]] double right() const { return x + width; }
  [[nodiscard]] double bottom() const { return y + height; }
  [[nodiscard]] bool contains(const Box& other) const {
    return other.x >= x && other.y >= y && other.right() <= right() &&
           other.bottom() <= bottom();
  }
  [[nodiscard]] bool meets(const Box& other) const {
    return other.x < right() && x < other.right() && other.y < bottom() &&
           y < other.bottom();
  }
};

/// How a line of text looks.
struct TextStyle {
  double size = 12;  ///< pixels
  bool bold = false;
  Rgb colour{0.13, 0.13, 0.13};
};

/// Have a context write in grey levels and unhinted widths: the same picture on every
/// screen and desktop.
void use_plain_fonts(cairo_t* context);

/// A white opaque image.
class Canvas {
 public:
  Canvas(int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  void fill(const Box& box, const Rgb& colour, double opacity = 1);
  void outline(const Box& box, const Rgb& colour, double line_width = 1);
  void line(double x0, double y0, double x1, double y1, const Rgb& colour,
            double line_width = 1);
  void disc(double x, double y, double radius, const Rgb& colour);

  /// One pixel, without blending. @pre inside the image
  void set(int x, int y, const Rgb& colour);

  [[nodiscard]] double text_width(const std::string& text, const TextStyle& style);

  /// Text with its baseline at y. @param align 0: starts at x, ½: centred, 1: ends at x
  void text(double x, double y, double align, const std::string& text,
            const TextStyle& style);

  /// Text that reads upwards, centred at y, its baseline at x.
  void text_upwards(double x, double y, const std::string& text,
                    const TextStyle& style);

  /// `text`, or as much of it as fits the width with an ellipsis.
  [[nodiscard]] std::string fitted(std::string text, double width,
                                   const TextStyle& style);

  /// The image as PNG. A stream that fails is left in its failed state.
  void write_png(std::ostream& out) const;

 private:
  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };

  void use(const TextStyle& style);

  int width_, height_;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace delos
