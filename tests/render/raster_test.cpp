// Triangles and lines in pixels.
#include "render/raster.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace delos::render {
namespace {

const Frame kShown{120, 90, 120};
const Eigen::AlignedBox3d kCube(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1));
const Colour kRed{1, 0, 0}, kBlue{0, 0, 1}, kWhite{1, 1, 1};

Eye eye_at(const char* view) { return {view_of(view), kCube, {240, 180, 240}}; }

std::array<int, 3> pixel(const Raster& raster, int x, int y) {
  const auto bytes = raster.bytes();
  const std::size_t at = 3 * (static_cast<std::size_t>(y) * 120 + x);
  return {bytes[at], bytes[at + 1], bytes[at + 2]};
}

/// A square across x that is seen from the right.
void square(Raster& raster, const Eye& eye, double x, const Colour& colour) {
  const auto corner = [&](double y, double z) {
    return Corner{eye.seen({x, y, z}), Eigen::Vector3d::Zero()};
  };
  const auto paint = [&](const Eigen::Vector3d&, int, int) { return colour; };
  raster.triangle(eye, {corner(-1, -1), corner(1, -1), corner(1, 1)}, paint);
  raster.triangle(eye, {corner(-1, -1), corner(1, 1), corner(-1, 1)}, paint);
}

TEST(Raster, ShowsTheNearestInAnyOrder) {
  const Eye eye = eye_at("right");
  for (const bool nearer_first : {true, false}) {
    Raster raster(kShown, kWhite);
    if (nearer_first) square(raster, eye, 0.5, kRed);
    square(raster, eye, 0, kBlue);
    if (!nearer_first) square(raster, eye, 0.5, kRed);
    EXPECT_EQ(pixel(raster, 60, 45), (std::array<int, 3>{255, 0, 0}));
    EXPECT_EQ(pixel(raster, 1, 1), (std::array<int, 3>{255, 255, 255}));
  }
}

// A triangle that leans away from the eye: what is blended in it is the place itself,
// so that each pixel must get the place that its ray meets. Ray and plane by hand.
TEST(Raster, BlendsStraightInTheRoom) {
  const Eye eye(view_of("0,0,3 m"), kCube, {240, 180, 240});
  const std::array<Eigen::Vector3d, 3> p{
      Eigen::Vector3d(1, -1, -1), Eigen::Vector3d(1, 1, -1), Eigen::Vector3d(-9, 0, 2)};
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = {eye.seen(p[k]), p[k]};
  const Spot origin = eye.spot({0, 0, 1}), unit = eye.spot({1, 0, 1});
  const double scale = unit.x - origin.x;
  const Eigen::Vector3d normal =
      (corners[1].seen - corners[0].seen).cross(corners[2].seen - corners[0].seen);
  int seen = 0;
  Raster raster(kShown, kWhite);
  // The colour tells both pixels of a shown one apart no more: ask for their mean.
  std::vector<std::pair<std::array<int, 2>, Eigen::Vector3d>> found;
  raster.triangle(eye, corners, [&](const Eigen::Vector3d& at, int x, int y) {
    found.push_back({{x, y}, at});
    return kRed;
  });
  for (const auto& [xy, at] : found) {
    // One of four spots within the pixel.
    double nearest = 1e9;
    for (const double dx : {0.5, 1.5})
      for (const double dy : {0.5, 1.5}) {
        const Eigen::Vector3d ray((2 * xy[0] + dx - origin.x) / scale,
                                  (origin.y - 2 * xy[1] - dy) / scale, 1);
        const Eigen::Vector3d met = normal.dot(corners[0].seen) / normal.dot(ray) * ray;
        nearest = std::min(nearest, (met - eye.seen(at)).norm());
      }
    EXPECT_LT(nearest, 1e-9);
    ++seen;
  }
  EXPECT_GT(seen, 500);
}

TEST(Raster, CutsWhatIsBehindTheEye) {
  const Eye eye(view_of("0,0,1 m"), kCube, {240, 180, 240});
  Raster raster(kShown, kWhite);
  // From far ahead to behind the eye, below it.
  const auto corner = [&](double x, double y) {
    return Corner{eye.seen({x, y, -0.3}), Eigen::Vector3d::Zero()};
  };
  raster.triangle(eye, {corner(-40, -40), corner(-40, 40), corner(5, 0)},
                  [&](const Eigen::Vector3d&, int, int) { return kRed; });
  EXPECT_EQ(pixel(raster, 60, 80), (std::array<int, 3>{255, 0, 0})) << "below";
  EXPECT_EQ(pixel(raster, 60, 10), (std::array<int, 3>{255, 255, 255})) << "above";
  raster.line(eye, eye.seen({-5, 0, 0}), eye.seen({5, 0, 0.6}), kBlue);
  EXPECT_LT(pixel(raster, 60, 40)[0], 200) << "the line, as far as it is ahead";
}

TEST(Raster, DrawsLinesBeforeWhatTheyLieOnAndBehindWhatHidesThem) {
  const Eye eye = eye_at("right");
  Raster raster(kShown, kWhite);
  square(raster, eye, 0, kRed);
  raster.line(eye, eye.seen({0, -1, 0}), eye.seen({0, 1, 0}), kBlue, 2);
  EXPECT_GT(pixel(raster, 60, 45)[2], 200);
  Raster hidden(kShown, kWhite);
  square(hidden, eye, 0.5, kRed);
  hidden.line(eye, eye.seen({0, -1, 0}), eye.seen({0, 1, 0}), kBlue, 2);
  EXPECT_EQ(pixel(hidden, 60, 45), (std::array<int, 3>{255, 0, 0}));
}

}  // namespace
}  // namespace delos::render
