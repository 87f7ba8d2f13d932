// Pictures decoded again and probed where samples must be. The plot is found by its
// colours alone, so that the tests know nothing of margins.
#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <tuple>
#include <utility>

#include "output/fields.h"
#include "output/write.h"

namespace delos {
namespace {

struct Pixel {
  int r, g, b;
  [[nodiscard]] bool coloured() const {
    return std::max({r, g, b}) - std::min({r, g, b}) > 20;
  }
  [[nodiscard]] bool grey() const { return r == g && g == b && r > 150 && r < 250; }
};

// matplotlib's viridis at 0, ¼, ½, ¾ and 1: #440154 #3b528b #21918c #5ec962 #fde725.
constexpr Pixel kViridis[] = {
    {68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};

void expect_colour(const Pixel& pixel, const Pixel& wanted) {
  // The polynomial is within 0.01 of the table, and a pixel's centre isn't the sample.
  EXPECT_NEAR(pixel.r, wanted.r, 7);
  EXPECT_NEAR(pixel.g, wanted.g, 7);
  EXPECT_NEAR(pixel.b, wanted.b, 7);
}

class Picture {
 public:
  explicit Picture(const Field& field, const PictureOptions& options = {}) {
    const Folder folder;
    EXPECT_EQ(write_field(field, folder / "f.png", options), "");
    surface_.reset(cairo_image_surface_create_from_png((folder / "f.png").c_str()));
    EXPECT_EQ(cairo_surface_status(surface_.get()), CAIRO_STATUS_SUCCESS);
    width = cairo_image_surface_get_width(surface_.get());
    height = cairo_image_surface_get_height(surface_.get());
  }

  [[nodiscard]] Pixel at(int x, int y) const {
    const unsigned char* row = cairo_image_surface_get_data(surface_.get()) +
                               y * cairo_image_surface_get_stride(surface_.get());
    const std::uint32_t bits = reinterpret_cast<const std::uint32_t*>(row)[x];
    return {int(bits >> 16 & 255), int(bits >> 8 & 255), int(bits & 255)};
  }

  /// Find the plot: the first columns that are filled over more than 100 pixels, and
  /// the rows of it that are filled to more than a half. Lines and labels are stepped
  /// over; the gap before the colour bar is wider.
  void find_plot() {
    const auto filled = [&](int x, int y) {
      const Pixel p = at(x, y);
      return p.coloured() || p.grey();
    };
    const auto column_filled = [&](int x) {
      int run = 0;
      for (int y = 60; y < height - 60; ++y) run += filled(x, y);
      return run > 100;
    };
    const auto row_filled = [&](int y) {
      int run = 0;
      for (int x = left; x <= right; ++x) run += filled(x, y);
      return 2 * run > right - left;
    };
    std::tie(left, right) = first_run(0, width, 12, column_filled);
    std::tie(top, bottom) = first_run(60, height, 24, row_filled);
  }

  /// The pixel of a sample of a volume or plane with these counts.
  [[nodiscard]] Pixel sample(int column, int columns, int row, int rows) const {
    return at(left + (right - left) * column / (columns - 1),
              bottom - (bottom - top) * row / (rows - 1));
  }

  [[nodiscard]] int count(bool (Pixel::*what)() const) const {
    int n = 0;
    for (int y = top; y <= bottom; ++y)
      for (int x = left; x <= right; ++x) n += (at(x, y).*what)();
    return n;
  }

  int width = 0, height = 0;
  int left = 0, right = 0, top = 0, bottom = 0;

 private:
  /// First and last of the first run for which `filled` holds, gaps below `gap`
  /// included.
  template <typename Filled>
  static std::pair<int, int> first_run(int from, int end, int gap,
                                       const Filled& filled) {
    while (from < end && !filled(from)) ++from;
    int last = from;
    for (int i = from; i < end && i - last < gap; ++i)
      if (filled(i)) last = i;
    return {from, last};
  }

  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
};

/// 9×5 samples on z = 1 with values 1 + x, x from 0 to 1.
Field ramp() {
  return volume({{0, 0, 1}, {0.125, 0.125, 1}, {9, 5, 1}},
                [](const Eigen::Vector3d& p) { return 1 + p.x(); });
}

TEST(PictureFile, HasASaneSizeAndProportions) {
  Picture picture(ramp());
  EXPECT_GE(picture.width, 600);
  EXPECT_LE(picture.width, 1000);
  EXPECT_GE(picture.height, 300);
  EXPECT_LE(picture.height, 720);
  picture.find_plot();
  const double shape =
      double(picture.right - picture.left + 1) / (picture.bottom - picture.top + 1);
  EXPECT_NEAR(shape, 2, 0.02);  // 1 m by 0.5 m
}

TEST(PictureFile, ColoursSamplesByTheMapBrightIsGood) {
  Picture picture(ramp());
  picture.find_plot();
  // Row 2 of 5 keeps clear of the markers, which sit in row 0.
  for (const int quarter : {1, 2, 3})
    expect_colour(picture.sample(2 * quarter, 9, 2, 5), kViridis[4 - quarter]);
  expect_colour(picture.sample(0, 9, 3, 5), kViridis[4]);
  expect_colour(picture.sample(8, 9, 3, 5), kViridis[0]);
}

TEST(PictureFile, TurnsColoursWhereLargerIsBetter) {
  PictureOptions options;
  options.larger_is_better = true;
  Picture picture(ramp(), options);
  picture.find_plot();
  for (const int quarter : {1, 2, 3})
    expect_colour(picture.sample(2 * quarter, 9, 2, 5), kViridis[quarter]);
}

TEST(PictureFile, SharesTheColoursOfARange) {
  PictureOptions options;
  options.range = {1, 3};  // of which the values 1 to 2 are the brighter half
  Picture picture(ramp(), options);
  picture.find_plot();
  expect_colour(picture.sample(4, 9, 2, 5), kViridis[3]);
  expect_colour(picture.sample(8, 9, 3, 5), kViridis[2]);
}

TEST(PictureFile, FollowsTheLogarithm) {
  PictureOptions options;
  options.log10 = true;
  Field field = ramp();
  for (std::size_t i = 0; i < field.value.size(); ++i)
    field.value[i] = std::pow(10, -4 * field.samples.points[i].x());
  Picture picture(field, options);
  picture.find_plot();
  for (const int quarter : {1, 2, 3})
    expect_colour(picture.sample(2 * quarter, 9, 2, 5), kViridis[quarter]);
}

// Between 1 device and 3 there aren't 2: the edge is hard, halfway between samples 4
// and 5 of 0 … 8.
TEST(PictureFile, BlendsNoCounts) {
  Field field = ramp();
  for (std::size_t i = 0; i < field.value.size(); ++i)
    field.value[i] = field.samples.points[i].x() < 0.6 ? 1 : 3;
  Picture picture(field);
  picture.find_plot();
  const int edge = picture.left + (picture.right - picture.left) * 9 / 16;
  expect_colour(picture.at(edge - 3, picture.top + 20), kViridis[4]);
  expect_colour(picture.at(edge + 4, picture.top + 20), kViridis[0]);
}

TEST(PictureFile, HatchesBlindCellsInGrey) {
  Field field = ramp();
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    if (field.samples.points[i].x() < 0.6) continue;
    field.value[i] = kBlind;
    field.observable[i] = 0;
  }
  Picture picture(field);
  picture.find_plot();
  for (const int column : {5, 6, 7, 8})
    EXPECT_TRUE(picture.sample(column, 9, 3, 5).grey()) << column;
  for (const int column : {0, 1, 2, 3, 4})
    EXPECT_TRUE(picture.sample(column, 9, 3, 5).coloured()) << column;
  // The edge is hard, halfway between samples 4 and 5 of 0 … 8.
  const int edge = picture.left + (picture.right - picture.left) * 9 / 16;
  EXPECT_TRUE(picture.at(edge - 3, picture.top + 20).coloured());
  EXPECT_TRUE(picture.at(edge + 4, picture.top + 20).grey());
}

TEST(PictureFile, ShowsNoColourWhereNothingIsFinite) {
  const Field field = volume({{0, 0, 0}, {0.1, 0.1, 0.1}, {6, 4, 2}},
                             [](const Eigen::Vector3d&) { return kBlind; });
  Picture picture(field);
  picture.find_plot();
  EXPECT_EQ(picture.count(&Pixel::coloured), 0);
  // Neither is it an empty plot: the sentence across it is in black on white.
  int ink = 0;
  for (int x = picture.left; x <= picture.right; ++x)
    for (int y = picture.top; y <= picture.bottom; ++y) ink += picture.at(x, y).r < 60;
  EXPECT_GT(ink, 100);
}

TEST(PictureFile, ShowsOneColourWhereAllIsEqual) {
  const Field field = volume({{0, 0, 0}, {0.1, 0.1, 0.1}, {6, 4, 2}},
                             [](const Eigen::Vector3d&) { return 0.1; });
  Picture picture(field);
  picture.find_plot();
  for (int column = 0; column < 6; ++column)
    expect_colour(picture.sample(column, 6, 0, 4), kViridis[2]);
}

TEST(PictureFile, TakesAxesOfOneSample) {
  for (const Eigen::Vector3i& counts :
       {Eigen::Vector3i(1, 1, 1), Eigen::Vector3i(50, 1, 1), Eigen::Vector3i(1, 50, 1),
        Eigen::Vector3i(1, 5, 5), Eigen::Vector3i(1, 1, 40)}) {
    const Field field =
        volume({{0, 0, 0}, {0.1, 0.1, 0.1}, counts.cast<std::int64_t>()},
               [](const Eigen::Vector3d& p) { return 1 + p.sum(); });
    Picture picture(field);
    picture.find_plot();
    EXPECT_GE(picture.right - picture.left, 150) << counts.transpose();
    EXPECT_GE(picture.bottom - picture.top, 150) << counts.transpose();
    EXPECT_LE(picture.width, 1000);
    EXPECT_LE(picture.height, 720);
  }
}

/// Three layers, z = 0, 1, 2: the ramp to the right, to the left, and equal.
Field layers() {
  return volume({{0, 0, 0}, {0.125, 0.125, 1}, {9, 5, 3}},
                [](const Eigen::Vector3d& p) {
                  if (p.z() == 0) return 2 + p.x();
                  return p.z() == 1 ? 2 - p.x() : 9.0;
                });
}

TEST(PictureFile, CutsThroughTheBestSample) {
  Picture smallest(layers());  // 1 at x = 1 of z = 1
  smallest.find_plot();
  expect_colour(smallest.sample(6, 9, 2, 5), kViridis[3]);

  PictureOptions larger;
  larger.larger_is_better = true;  // 9 all over z = 2
  Picture largest(layers(), larger);
  largest.find_plot();
  expect_colour(largest.sample(6, 9, 0, 5), kViridis[2]);
}

TEST(PictureFile, CutsAtTheNearestLayer) {
  PictureOptions options;
  options.has_slice = true;
  for (const double z : {-5.0, 0.0, 0.4}) {
    options.slice_z = z;
    Picture picture(layers(), options);
    picture.find_plot();
    expect_colour(picture.sample(6, 9, 2, 5), kViridis[1]);
  }
  options.slice_z = 0.6;
  Picture picture(layers(), options);
  picture.find_plot();
  expect_colour(picture.sample(6, 9, 2, 5), kViridis[3]);
}

TEST(PictureFile, DrawsPlanesWithWorldAxesToTheRight) {
  // The edge u runs against x, so that its first sample is the picture's last column.
  const Field field = plane({{1, 0, 0.5}, {-1, 0, 0}, {0, 0, 1}, {9, 9}},
                            [](const Eigen::Vector3d& p) { return 1 + p.x(); });
  Picture picture(field);
  picture.find_plot();
  expect_colour(picture.sample(2, 9, 4, 9), kViridis[3]);
  expect_colour(picture.sample(6, 9, 4, 9), kViridis[1]);
}

TEST(PictureFile, DrawsWhatACancelledEvaluationReached) {
  Field field = ramp();
  field.cancelled = true;
  field.evaluated = 27;  // three rows of nine
  for (std::size_t i = field.evaluated; i < field.value.size(); ++i)
    field.value[i] = kBlind;
  Picture picture(field);
  picture.find_plot();
  EXPECT_TRUE(picture.sample(4, 9, 2, 5).coloured());
  EXPECT_TRUE(picture.sample(4, 9, 4, 5).grey());
}

/// The red of a device, #b3172b.
bool device_red(const Pixel& p) { return p.r > 150 && p.g < 60 && p.b < 80; }

int count_red(const Picture& picture) {
  int n = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) n += device_red(picture.at(x, y));
  return n;
}

/// A device half a metre to the right of the ramp, that looks to the left, and one too
/// far away. The first is a disc of 64 pixels and a line of 2.5 × 22, of which the disc
/// covers a fifth.
TEST(PictureFile, ShowsTheDevicesThatAreNear) {
  EXPECT_EQ(count_red(Picture(ramp())), 0);
  PictureOptions options;
  options.devices = {{"cam", {1.5, 0.25, 2}, Eigen::Vector3d(-1, 0, 0)},
                     {"far", {20, 0.25, 2}, std::nullopt}};
  const Picture one(ramp(), options);
  EXPECT_NEAR(count_red(one), 64 + 44, 25);
  options.devices.pop_back();
  EXPECT_EQ(count_red(one), count_red(Picture(ramp(), options)));
  options.devices.push_back({"near", {-0.5, 0.25, 2}, std::nullopt});
  EXPECT_NEAR(count_red(Picture(ramp(), options)), 2 * 64 + 44, 40);
}

/// Changes from −1 to 2: blue at −2, which none reaches, white at 0, red at 2.
TEST(PictureFile, ShowsChangesAboutZero) {
  Field field = ramp();
  for (std::size_t i = 0; i < field.value.size(); ++i)
    field.value[i] = 3 * field.samples.points[i].x() - 1;
  PictureOptions options;
  options.change = true;
  // White isn't told from paper: the plot is where it is without changes.
  Picture plain(field);
  plain.find_plot();
  const auto placed = [&](Picture&& picture) {
    std::tie(picture.left, picture.right, picture.top, picture.bottom) =
        std::tie(plain.left, plain.right, plain.top, plain.bottom);
    return std::move(picture);
  };
  const Picture picture = placed(Picture(field, options));
  const auto reddish = [](const Pixel& p) { return p.r - p.b; };
  // x = 1/4: −0.25; x = 3/8: 0.125, nearly white; x = 3/4: 1.25.
  EXPECT_LT(reddish(picture.sample(1, 9, 2, 5)), -20);
  EXPECT_LT(std::abs(reddish(picture.sample(3, 9, 2, 5))), 30);
  EXPECT_GT(reddish(picture.sample(6, 9, 2, 5)), 60);
  options.larger_is_better = true;
  const Picture turned = placed(Picture(field, options));
  EXPECT_LT(reddish(turned.sample(6, 9, 2, 5)), -60);
}

TEST(PictureFile, SurvivesAnyName) {
  Field field = ramp();
  field.scene = std::string(500, 'W') + "\xff\x01<é";
  field.metric = std::string("m\xc3");
  field.samples.parts.front().name = "\xe2\x82";
  Picture picture(field);
  EXPECT_LE(picture.width, 1000);
}

TEST(PictureFile, TakesNegativeAndZeroValuesOnALogScale) {
  PictureOptions options;
  options.log10 = true;
  Field field = ramp();
  field.value[20] = -1;
  field.value[21] = 0;
  Picture mixed(field, options);
  for (double& value : field.value) value = -1 - std::abs(value);
  Picture negative(field, options);
  EXPECT_GT(negative.width, 0);
}

}  // namespace
}  // namespace delos
