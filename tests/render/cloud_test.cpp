// A cloud of one density against the closed form of what it lets through.
#include "render/cloud.h"

#include <gtest/gtest.h>

#include <cmath>

namespace delos::render {
namespace {

using session::Drawn;

const Frame kCloudFrame{80, 60, 80};
/// 2 m × 2 m × 1 m, so that its diagonal is 3 m.
const Eigen::AlignedBox3d kHazed(Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(1, 1, 1));
const Colour kClear{1, 1, 1};

session::DrawnField filled(Drawn what, double value) {
  session::DrawnField drawn;
  const GridShape grid{kHazed.min(), {0.5, 0.5, 0.25}, {5, 5, 5}};
  drawn.field.samples.parts = {{"", 0, 125, grid}};
  drawn.field.value.assign(125, value);
  drawn.mask.assign(125, what);
  return drawn;
}

/// The middle of the picture from above.
Colour middle_of(const session::DrawnField& drawn, bool orthographic,
                 double opaque_at) {
  View view = view_of("top");
  view.orthographic = orthographic;
  const Eye eye(view, kHazed, {160, 120, 160});
  Raster raster(kCloudFrame, kClear);
  const auto corner = [&](double x, double y) {
    return Corner{eye.seen({x, y, opaque_at}), Eigen::Vector3d::Zero()};
  };
  raster.triangle(eye, {corner(-9, -9), corner(9, -9), corner(0, 9)},
                  [](const Eigen::Vector3d&, int, int) {
                    return Colour{0, 0, 0};
                  });
  const ColourRange range{0, 1, false, false, false};
  draw_cloud({raster, eye, kLight}, drawn, range);
  const auto bytes = raster.bytes();
  const std::size_t at = 3 * (30 * 80 + 40);
  return {bytes[at] / 255.0, bytes[at + 1] / 255.0, bytes[at + 2] / 255.0};
}

// Through a way s of density ρ comes exp(−ρ s/D) of the light behind, here none: what
// is seen is the colour times the rest. Half way to the best ρ = 0.6 + 9/8.
TEST(Cloud, LetsThroughWhatItsDensitySays) {
  const ColourRange range{0, 1, false, false, false};
  const struct {
    Drawn what;
    double density;
    Colour colour;
  } cases[] = {{Drawn::value, 0.6 + 9 / 8.0, colour_of(range, 0.5)},
               {Drawn::blind, 1.6, kLight.blind},
               {Drawn::inside, 0, {0, 0, 0}}};
  for (const auto& [what, density, colour] : cases)
    for (const bool orthographic : {true, false}) {
      // In steps, of which there are 40: an end within one is up to 1/80 off.
      for (const auto& [opaque, way, error] :
           {std::tuple(-0.5, 1.0, 0.004), {0.4, 0.6, 0.02}, {1.5, 0.0, 0.004}}) {
        const Colour there = middle_of(filled(what, 0.5), orthographic, opaque);
        const double hidden = 1 - std::exp(-density * way / 3);
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_NEAR(there[c], hidden * colour[c], error)
              << int(what) << orthographic << opaque;
      }
    }
}

// What is worst is thin, what is best is dense, also where more is better.
TEST(Cloud, IsDensestWhereItIsGood) {
  const double best = middle_of(filled(Drawn::value, 0), true, -0.5)[1],
               worst = middle_of(filled(Drawn::value, 1), true, -0.5)[1];
  EXPECT_GT(best, 3 * worst);
}

}  // namespace
}  // namespace delos::render
