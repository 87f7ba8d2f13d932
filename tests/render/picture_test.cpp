// Pictures of the shipped scenes: what is seen at a pixel is what stands there.
#include "render/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "delos/geometry/occluders.h"
#include "delos/scene/clutter.h"
#include "output/colour_range.h"
#include "session/refusal.h"

namespace delos::render {
namespace {

PluginRegistry& device_plugins() {
  static PluginRegistry registry({DELOS_PLUGINS});
  return registry;
}

session::LoadedScene scene_of(const std::string& name) {
  return session::load({std::string(DELOS_SCENES) + "/" + name + ".yaml"},
                       device_plugins());
}

session::DrawnField drawn_of(const session::LoadedScene& loaded, int threads = 1) {
  FieldOptions options;
  options.threads = threads;
  return session::draw_field(loaded, 0, options);
}

/// Nothing but the field.
PictureOptions bare(const char* view) {
  PictureOptions options;
  options.view = view_of(view);
  options.devices = options.floor = options.box = options.bodies = options.beacons =
      false;
  return options;
}

using Pixel = std::array<int, 3>;

Pixel pixel(const Picture& picture, double x, double y) {
  const auto at =
      3 * (static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x));
  return {picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]};
}

int apart(const Pixel& a, const Pixel& b) {
  int most = 0;
  for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a[c] - b[c]));
  return most;
}

Pixel bytes_of(const std::array<double, 3>& colour) {
  return {static_cast<int>(std::lround(255 * colour[0])),
          static_cast<int>(std::lround(255 * colour[1])),
          static_cast<int>(std::lround(255 * colour[2]))};
}

/// The colours of a field that run over all of it.
ColourRange range_of(const Field& field) {
  const FieldStatistics s = summarize(field);
  ColourRange range;
  range.low = s.min.value;
  range.high = s.max.value;
  range.larger_is_better = field.larger_is_better;
  return range;
}

/// The height of the samples' layer nearest to one.
double layer_near(const Field& field, double z) {
  double nearest = 1e9;
  for (const Eigen::Vector3d& p : field.samples.points)
    if (std::abs(p.z() - z) < std::abs(nearest - z)) nearest = p.z();
  return nearest;
}

bool looks_good(const Pixel& p) { return p[0] > 180 && p[1] > 190 && p[2] < 70; }

// Scene 01, whose field delos field says runs from 17.0 to 81.7 mm.
TEST(Picture, ShowsAtEachSampleItsValue) {
  const session::LoadedScene loaded = scene_of("01-acoustic");
  const session::DrawnField drawn = drawn_of(loaded);
  for (const bool orthographic : {true, false})
    for (const char* view : {"top", "50,40"}) {
      PictureOptions options = bare(view);
      options.view.orthographic = orthographic;
      options.slices = {{2, 0.6}};
      const Picture picture = render_picture(loaded, drawn, options);
      const ColourRange range = range_of(drawn.field);
      ASSERT_TRUE(picture.range);
      EXPECT_EQ(picture.range->first, range.low);
      EXPECT_EQ(picture.range->second, range.high);
      const Eye eye = eye_of(loaded, options);
      int compared = 0;
      for (std::size_t i = 0; i < drawn.field.value.size(); ++i) {
        const Eigen::Vector3d& p = drawn.field.samples.points[i];
        // Not those on its edge, which is a line.
        if (std::abs(p.z() - 0.6) > 1e-9 || p.head<2>().minCoeff() < 0.01 ||
            p.head<2>().maxCoeff() > 0.39)
          continue;
        const Spot s = eye.spot(eye.seen(p));
        const Pixel wanted = bytes_of(colour_of(range, drawn.field.value[i]));
        EXPECT_LE(apart(pixel(picture, s.x, s.y), wanted), 4) << p.transpose();
        ++compared;
      }
      EXPECT_EQ(compared, 19 * 19);
    }
}

// What hides is asked of the geometry that hides beacons and markers from devices, by
// rays from the eye.
TEST(Picture, BodiesHideWhatIsBehindThem) {
  const session::LoadedScene loaded = scene_of("06-furnished-lab");
  const session::DrawnField drawn = drawn_of(loaded, 2);
  std::vector<TriangleMesh> bodies;
  for (const OccluderEntry& entry : all_occluders(loaded.scene))
    if (entry.mount != Mount::target && !entry.room)
      bodies.push_back(transformed(body_mesh(entry.body), pose_of(entry.placement)));
  const Occluders occluders(bodies);
  PictureOptions options = bare("corner");
  const double height = layer_near(drawn.field, 1.0);
  options.slices = {{2, height}};
  const Picture without = render_picture(loaded, drawn, options);
  options.bodies = true;
  const Picture with = render_picture(loaded, drawn, options);
  const Eye eye = eye_of(loaded, options);
  const ColourRange range = range_of(drawn.field);
  int hidden = 0, wrong = 0, all = 0;
  for (std::size_t i = 0; i < drawn.field.value.size(); ++i) {
    const Eigen::Vector3d& p = drawn.field.samples.points[i];
    if (std::abs(p.z() - height) > 1e-9 || drawn.mask[i] != session::Drawn::value)
      continue;
    const Spot s = eye.spot(eye.seen(p));
    const Pixel there = pixel(without, s.x, s.y);
    if (apart(there, bytes_of(colour_of(range, drawn.field.value[i]))) > 8) continue;
    const bool blocked = occluders.blocks(eye.position(), p, 0.02);
    hidden += blocked;
    wrong += blocked != (apart(pixel(with, s.x, s.y), there) > 8);
    ++all;
  }
  EXPECT_GT(all, 3000);
  EXPECT_GT(hidden, 100);
  // Lines are drawn along their edges, over what is beside them.
  EXPECT_LT(wrong, 0.02 * all) << hidden << " of " << all;
}

TEST(Picture, HatchesWhatIsBlind) {
  const session::LoadedScene loaded = scene_of("05-optitrack-lab");
  const session::DrawnField drawn = drawn_of(loaded);
  PictureOptions options = bare("top");
  // The highest layer, next to the cameras, is the blindest.
  const double height = layer_near(drawn.field, 2.0);
  options.slices = {{2, height}};
  const Picture picture = render_picture(loaded, drawn, options);
  const Eye eye = eye_of(loaded, options);
  std::map<Pixel, int> colours;
  int blind = 0;
  for (std::size_t i = 0; i < drawn.field.value.size(); ++i) {
    const Eigen::Vector3d& p = drawn.field.samples.points[i];
    if (std::abs(p.z() - height) > 1e-9 || drawn.mask[i] != session::Drawn::blind)
      continue;
    const Spot s = eye.spot(eye.seen(p));
    const Pixel at = pixel(picture, s.x, s.y);
    // No colour of viridis is so grey: 60 at the least.
    EXPECT_LT(std::max({at[0], at[1], at[2]}) - std::min({at[0], at[1], at[2]}), 30);
    ++colours[at];
    ++blind;
  }
  EXPECT_GT(blind, 20);
  EXPECT_GE(colours.size(), 2u) << "stripes";
}

// Scene 13 is blind everywhere.
TEST(Picture, NeverShowsBlindAsGood) {
  const session::LoadedScene loaded = scene_of("13-camera-spots");
  PictureOptions options;
  options.view = view_of("corner");
  options.slices = {{0, {}}, {1, {}}, {2, {}}};
  const Picture picture = render_picture(loaded, drawn_of(loaded), options);
  EXPECT_FALSE(picture.range);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const Pixel p = pixel(picture, x, y);
      ASSERT_FALSE(looks_good(p)) << x << ' ' << y;
    }
}

TEST(Picture, IsTheSameForAnyNumberOfThreads) {
  const session::LoadedScene loaded = scene_of("05-optitrack-lab");
  PictureOptions options;
  options.view = view_of("corner");
  options.slices = {{2, {}}};
  options.levels = {0.0006};
  const std::string one = png_of(render_picture(loaded, drawn_of(loaded, 1), options));
  const std::string three =
      png_of(render_picture(loaded, drawn_of(loaded, 3), options));
  EXPECT_EQ(one.substr(1, 3), "PNG");
  EXPECT_EQ(one, three);
}

TEST(Picture, DrawsSurfacesAtTheirLevels) {
  const session::LoadedScene loaded = scene_of("01-acoustic");
  const session::DrawnField drawn = drawn_of(loaded);
  PictureOptions options = bare("top");
  options.view.orthographic = true;
  options.levels = {0.04};
  const Picture picture = render_picture(loaded, drawn, options);
  ASSERT_EQ(picture.shapes.size(), 1u);
  // It runs through the whole column, a little bent: its area is above that of the
  // column, 0.4 m by 0.4 m, and the picture shows its colour in the middle.
  EXPECT_GT(picture.shapes[0].area, 0.16);
  EXPECT_LT(picture.shapes[0].area, 0.17);
  const Spot s =
      eye_of(loaded, options).spot(eye_of(loaded, options).seen({0.2, 0.2, 0.4}));
  EXPECT_LE(
      apart(pixel(picture, s.x, s.y), bytes_of(colour_of(range_of(drawn.field), 0.04))),
      6);

  options.levels = {0.2};
  EXPECT_THROW(static_cast<void>(render_picture(loaded, drawn, options)),
               session::Refusal);
}

// The faces of the column through which the body between two surfaces is cut show its
// values as a slice does.
TEST(Picture, DrawsBodiesBetweenTwoValues) {
  const session::LoadedScene loaded = scene_of("01-acoustic");
  const session::DrawnField drawn = drawn_of(loaded);
  PictureOptions options = bare("front");
  options.view.orthographic = true;
  options.between = {{0.02, 0.04}};
  const Picture picture = render_picture(loaded, drawn, options);
  ASSERT_EQ(picture.shapes.size(), 1u);
  EXPECT_GT(picture.shapes[0].volume, 0);
  const ColourRange range = range_of(drawn.field);
  const Eye eye = eye_of(loaded, options);
  int inside = 0, outside = 0;
  for (std::size_t i = 0; i < drawn.field.value.size(); ++i) {
    const Eigen::Vector3d& p = drawn.field.samples.points[i];
    // Of those at its edges a pixel shows what is beside them, too.
    if (p.y() > 1e-9 || std::abs(p.x() - 0.2) > 0.15 || p.z() > 1.13) continue;
    const double value = drawn.field.value[i];
    const Spot s = eye.spot(eye.seen(p));
    const Pixel there = pixel(picture, s.x, s.y);
    if (value > 0.0205 && value < 0.0395) {
      ++inside;
      EXPECT_LE(apart(there, bytes_of(colour_of(range, value))), 6) << p.transpose();
    } else if (value > 0.045) {
      ++outside;
      EXPECT_EQ(there, (Pixel{255, 255, 255})) << p.transpose();
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 50);
  options.between = {{0.2, 0.3}};
  EXPECT_EQ(render_picture(loaded, drawn, options).shapes[0].volume, 0);
}

// Each sample of the layer is seen at its height, unless something nearer hides it;
// blind ones leave the hatched base.
TEST(Picture, RaisesSlicesByTheirValues) {
  const session::LoadedScene loaded = scene_of("04-motion-capture");
  const session::DrawnField drawn = drawn_of(loaded);
  PictureOptions options = bare("30,50");
  options.view.orthographic = true;
  options.slices = {{2, 5.6 * 0.3048}};
  options.reliefs = true;
  options.relief_height = 0.5;
  const Picture picture = render_picture(loaded, drawn, options);
  const ColourRange range = range_of(drawn.field);
  const Eye eye = eye_of(loaded, options);
  const double z = layer_near(drawn.field, 5.6 * 0.3048);
  int valued = 0, compared = 0, without = 0;
  for (std::size_t i = 0; i < drawn.field.value.size(); ++i) {
    Eigen::Vector3d p = drawn.field.samples.points[i];
    if (std::abs(p.z() - z) > 1e-9) continue;
    const double value = drawn.field.value[i];
    const bool there = std::isfinite(value);
    if (there) p.z() += 0.5 * (value - range.low) / (range.high - range.low);
    const Spot s = eye.spot(eye.seen(p));
    const Pixel seen = pixel(picture, s.x, s.y);
    if (!there) {
      EXPECT_FALSE(looks_good(seen)) << p.transpose();
      ++without;
      continue;
    }
    ++valued;
    // As bright as it is lit: the hue is compared.
    const auto wanted = colour_of(range, value);
    const double light = seen[1] / (255 * wanted[1]);
    bool alike = light > 0.49 && light < 1.02;
    for (std::size_t c = 0; c < 3; ++c)
      alike = alike && std::abs(seen[c] - 255 * light * wanted[c]) < 8;
    compared += alike;
  }
  EXPECT_GT(without, 20);
  EXPECT_GT(compared, 0.6 * valued) << "of " << valued;
}

TEST(Picture, DrawsCellsOfAnOctreeAlone) {
  PictureOptions options = bare("top");
  options.cells = true;
  options.slices = {{2, {}}};
  const session::LoadedScene grid = scene_of("01-acoustic");
  EXPECT_THROW(static_cast<void>(render_picture(grid, drawn_of(grid), options)),
               session::Refusal);
  const session::LoadedScene loaded = scene_of("06-furnished-lab");
  const session::DrawnField drawn = drawn_of(loaded);
  const Picture with = render_picture(loaded, drawn, options);
  options.cells = false;
  EXPECT_NE(with.pixels, render_picture(loaded, drawn, options).pixels);
}

}  // namespace
}  // namespace delos::render
