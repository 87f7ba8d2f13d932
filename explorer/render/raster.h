// Triangles and lines in pixels: of what falls on one spot, the nearest is seen.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "render/eye.h"

namespace delos::render {

/// Red, green and blue, sRGB, each in [0, 1].
using Colour = std::array<double, 3>;

/// A colour under a light, 1: as it is.
[[nodiscard]] inline Colour lit(const Colour& colour, double light) {
  return {light * colour[0], light * colour[1], light * colour[2]};
}

/// A corner of a triangle.
struct Corner {
  Eigen::Vector3d seen;   ///< as Eye::seen()
  Eigen::Vector3d value;  ///< blended between the corners, straight in the room
};

/// A picture of colours and of how near they are. Drawn twice as large as it is shown
/// in both directions, so that edges are smooth.
/// What lies before a spot: its light, and the part of what is behind that it hides.
struct Haze {
  Colour light{0, 0, 0};
  double opacity = 0;
};

class Raster {
 public:
  static constexpr int kFiner = 2;
  static constexpr std::size_t kSpots = kFiner * kFiner;

  /// @param frame of the picture that is shown
  Raster(const Frame& frame, const Colour& background);

  /// @param colour_at of what is blended between the corners, and of the spot, pixels
  ///        of the shown picture; nullopt: there is a hole
  template <class ColourAt>
  void triangle(const Eye& eye, const std::array<Corner, 3>& corners,
                ColourAt&& colour_at);

  /// A line before what it lies on. @param a, b as Eye::seen() @param width pixels
  /// shown
  void line(const Eye& eye, Eigen::Vector3d a, Eigen::Vector3d b, const Colour& colour,
            double width = 1);

  /// A disc that faces the eye, or, hollow, a ring. @param radius pixels shown
  void disc(const Eye& eye, const Eigen::Vector3d& seen, double radius, bool hollow,
            const Colour& colour);

  /// Lay a haze over all that was drawn.
  /// @param haze called for each pixel that is shown with its middle, pixels of the
  ///        eye's frame, how far ahead its spots end, metres, and their hazes
  template <class HazeBefore>
  void compose(const Eye& eye, const HazeBefore& haze);

  /// The picture, rows from the top, three bytes a pixel.
  [[nodiscard]] std::vector<unsigned char> bytes() const;

 private:
  void put(int x, int y, double nearness, const Colour& colour) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    const std::size_t at = static_cast<std::size_t>(y) * width_ + x;
    if (nearness <= nearness_[at]) return;
    nearness_[at] = nearness;
    colour_[at] = {static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                   static_cast<float>(colour[2])};
  }
  template <class ColourAt>
  void flat_triangle(const Eye& eye, const std::array<Corner, 3>& corners,
                     ColourAt&& colour_at);

  Frame shown_;
  int width_, height_;
  std::vector<double> nearness_;
  std::vector<std::array<float, 3>> colour_;
};

template <class ColourAt>
void Raster::triangle(const Eye& eye, const std::array<Corner, 3>& corners,
                      ColourAt&& colour_at) {
  // What is behind the eye is cut off: up to four corners are left.
  std::array<Corner, 4> left;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &a = corners[k], &b = corners[(k + 1) % 3];
    const double da = a.seen.z() - eye.nearest(), db = b.seen.z() - eye.nearest();
    if (da >= 0) left[count++] = a;
    if ((da >= 0) == (db >= 0)) continue;
    const double t = da / (da - db);
    left[count++] = {a.seen + t * (b.seen - a.seen), a.value + t * (b.value - a.value)};
  }
  for (std::size_t k = 2; k < count; ++k)
    flat_triangle(eye, {left[0], left[k - 1], left[k]}, colour_at);
}

template <class ColourAt>
void Raster::flat_triangle(const Eye& eye, const std::array<Corner, 3>& corners,
                           ColourAt&& colour_at) {
  std::array<Spot, 3> s;
  for (std::size_t k = 0; k < 3; ++k) s[k] = eye.spot(corners[k].seen);
  const auto side = [](const Spot& a, const Spot& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  };
  const double area = side(s[0], s[1], s[2].x, s[2].y);
  if (area == 0 || !std::isfinite(area)) return;
  const auto [x0, x1] = std::minmax({s[0].x, s[1].x, s[2].x});
  const auto [y0, y1] = std::minmax({s[0].y, s[1].y, s[2].y});
  const int left = static_cast<int>(std::max(0.0, std::floor(x0 - 0.5)));
  const int top = static_cast<int>(std::max(0.0, std::floor(y0 - 0.5)));
  const int right = static_cast<int>(std::min<double>(width_ - 1, std::ceil(x1)));
  const int bottom = static_cast<int>(std::min<double>(height_ - 1, std::ceil(y1)));
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const std::array<double, 3> part{side(s[1], s[2], px, py) / area,
                                       side(s[2], s[0], px, py) / area,
                                       side(s[0], s[1], px, py) / area};
      if (part[0] < 0 || part[1] < 0 || part[2] < 0) continue;
      double nearness = 0, weights = 0;
      Eigen::Vector3d value = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        nearness += part[k] * s[k].nearness;
        weights += part[k] * s[k].weight;
        value += part[k] * s[k].weight * corners[k].value;
      }
      const std::optional<Colour> colour =
          colour_at(value / weights, x / kFiner, y / kFiner);
      if (colour) put(x, y, nearness, *colour);
    }
}

template <class HazeBefore>
void Raster::compose(const Eye& eye, const HazeBefore& haze) {
  for (int y = 0; y < shown_.height; ++y)
    for (int x = 0; x < shown_.free; ++x) {
      std::array<std::size_t, kSpots> spots;
      std::array<double, kSpots> ends;
      for (std::size_t k = 0; k < kSpots; ++k) {
        const auto i = static_cast<int>(k) % kFiner, j = static_cast<int>(k) / kFiner;
        spots[k] = static_cast<std::size_t>(kFiner * y + j) * width_ + kFiner * x + i;
        ends[k] = eye.ahead(nearness_[spots[k]]);
      }
      std::array<Haze, kSpots> hazes;
      haze(kFiner * (x + 0.5), kFiner * (y + 0.5), ends, hazes);
      for (std::size_t k = 0; k < kSpots; ++k)
        for (std::size_t c = 0; c < 3; ++c) {
          float& seen = colour_[spots[k]][c];
          seen = static_cast<float>(hazes[k].light[c] + (1 - hazes[k].opacity) * seen);
        }
    }
}

}  // namespace delos::render
