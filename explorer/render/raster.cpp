#include "render/raster.h"

#include <utility>

namespace delos::render {

Raster::Raster(const Frame& frame, const Colour& background)
    : shown_(frame), width_(kFiner * frame.width), height_(kFiner * frame.height) {
  const std::size_t pixels = static_cast<std::size_t>(width_) * height_;
  nearness_.assign(pixels, -std::numeric_limits<double>::infinity());
  colour_.assign(pixels,
                 {static_cast<float>(background[0]), static_cast<float>(background[1]),
                  static_cast<float>(background[2])});
}

void Raster::line(const Eye& eye, Eigen::Vector3d a, Eigen::Vector3d b,
                  const Colour& colour, double width) {
  if (a.z() < b.z()) std::swap(a, b);
  if (a.z() < eye.nearest()) return;
  if (b.z() < eye.nearest())
    b = a + (a.z() - eye.nearest()) / (a.z() - b.z()) * (b - a);
  const Spot from = eye.spot(a), to = eye.spot(b);
  const double dx = to.x - from.x, dy = to.y - from.y;
  const bool along_x = std::abs(dx) >= std::abs(dy);
  const double length = along_x ? dx : dy;
  if (length == 0) return;
  const double first = along_x ? from.x : from.y;
  const double most = along_x ? width_ : height_;
  // As wide across the line as it is asked to be.
  const double half = 0.5 * kFiner * width * std::hypot(dx, dy) / std::abs(length);
  const auto inside = [&](double at) { return std::clamp(at, 0.0, most); };
  const int begin = static_cast<int>(inside(std::min(first, first + length)));
  const int end = static_cast<int>(inside(std::max(first, first + length)));
  for (int k = begin; k <= end; ++k) {
    const double t = std::clamp((k + 0.5 - first) / length, 0.0, 1.0);
    const double across = along_x ? from.y + t * dy : from.x + t * dx;
    const double nearness =
        eye.before(from.nearness + t * (to.nearness - from.nearness));
    if (across + half < 0 || across - half > (along_x ? height_ : width_)) continue;
    const int low = static_cast<int>(std::floor(across - half + 0.5));
    const int high = std::max(low, static_cast<int>(std::floor(across + half - 0.5)));
    for (int c = low; c <= high; ++c)
      along_x ? put(k, c, nearness, colour) : put(c, k, nearness, colour);
  }
}

void Raster::disc(const Eye& eye, const Eigen::Vector3d& seen, double radius,
                  bool hollow, const Colour& colour) {
  if (seen.z() < eye.nearest()) return;
  const Spot at = eye.spot(seen);
  const double r = kFiner * radius;
  if (at.x < -r || at.y < -r || at.x > width_ + r || at.y > height_ + r) return;
  for (int y = static_cast<int>(at.y - r); y <= at.y + r; ++y)
    for (int x = static_cast<int>(at.x - r); x <= at.x + r; ++x) {
      const double from = std::hypot(x + 0.5 - at.x, y + 0.5 - at.y);
      if (from <= r && (!hollow || from >= 0.56 * r))
        put(x, y, eye.before(at.nearness), colour);
    }
}

std::vector<unsigned char> Raster::bytes() const {
  std::vector<unsigned char> out;
  out.reserve(static_cast<std::size_t>(3) * shown_.width * shown_.height);
  for (int y = 0; y < shown_.height; ++y)
    for (int x = 0; x < shown_.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0;
        for (int j = 0; j < kFiner; ++j)
          for (int i = 0; i < kFiner; ++i)
            sum += colour_[static_cast<std::size_t>(kFiner * y + j) * width_ +
                           kFiner * x + i][c];
        const double mean = std::clamp(sum / (kFiner * kFiner), 0.0, 1.0);
        out.push_back(static_cast<unsigned char>(std::lround(255 * mean)));
      }
  return out;
}

}  // namespace delos::render
