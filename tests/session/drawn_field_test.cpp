// Fields as a page draws them: nothing blind looks good, and coarse ones cover the
// room.
#include "session/drawn_field.h"

#include <cmath>
#include <cstring>

#include "designs.h"

namespace delos::session {
namespace {

struct Unpacked {
  Json head;
  std::vector<float> values;
  std::string mask;
};

template <class T>
std::vector<T> array_at(const std::string& bytes, std::size_t at, std::size_t count) {
  std::vector<T> all(count);
  EXPECT_LE(at + count * sizeof(T), bytes.size());
  EXPECT_EQ(at % 4, 0u) << "typed arrays begin at whole words";
  std::memcpy(all.data(), bytes.data() + at, count * sizeof(T));
  return all;
}

Unpacked unpack(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 4), "DLF1");
  const std::uint32_t length = array_at<std::uint32_t>(bytes, 4, 1)[0];
  Unpacked all{Json::parse(bytes.substr(8, length)), {}, {}};
  const std::size_t base = 8 + length;
  const std::size_t count = all.head["values"]["count"];
  all.values =
      array_at<float>(bytes, base + all.head["values"]["at"].get<std::size_t>(), count);
  const auto mask =
      array_at<char>(bytes, base + all.head["mask"]["at"].get<std::size_t>(), count);
  all.mask.assign(mask.begin(), mask.end());
  return all;
}

/// 2178 of 2541 samples are observable, says scenes/README.md.
TEST(DrawnField, NeverDrawsBlindAsGood) {
  const Design design = design_of("02-eight-cameras");
  const DrawnField drawn = draw_field(design.loaded(), 0, {});
  const Unpacked all = unpack(packed(drawn, 7));
  EXPECT_EQ(all.head["revision"], 7);
  EXPECT_EQ(all.head["level"], "full");
  ASSERT_EQ(all.values.size(), 2541u);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < all.values.size(); ++i) {
    const bool finite = std::isfinite(drawn.field.value[i]);
    EXPECT_EQ(all.mask[i], finite ? 1 : 0);
    EXPECT_EQ(std::isnan(all.values[i]), !finite);
    if (finite) {
      EXPECT_EQ(all.values[i], static_cast<float>(drawn.field.value[i]));
    }
    seen += finite;
  }
  EXPECT_EQ(seen, 2178u);
  EXPECT_EQ(all.head["summary"]["min"]["value"], summarize(drawn.field).min.value);
}

/// Inside solids stands no target, however well the place is seen.
TEST(DrawnField, MarksTheInsideOfSolids) {
  const Design design = design_of("09-camera-room");
  const DrawnField drawn = draw_field(design.loaded(), 0, {});
  const Unpacked all = unpack(packed(drawn, 0));
  std::size_t inside = 0;
  for (std::size_t i = 0; i < all.values.size(); ++i) {
    if (all.mask[i] != 2) continue;
    ++inside;
    EXPECT_TRUE(std::isnan(all.values[i]));
    EXPECT_NE(drawn.field.inside[i], 0);
  }
  EXPECT_EQ(inside, summarize(drawn.field).inside);
  EXPECT_GT(inside, 0u);
}

TEST(DrawnField, IsCoarseWhereItIsLarge) {
  const Design design = design_of("04-motion-capture");
  for (const std::size_t most : {500u, 4000u, 20'000u}) {
    const DrawnField drawn = draw_field(design.loaded(), most, {});
    EXPECT_TRUE(drawn.coarse);
    EXPECT_LE(drawn.field.value.size(), most);
    EXPECT_GT(drawn.field.value.size(), most / 3);
    // From corner to corner of the room: 20 ft, 20 ft, 8 ft.
    EXPECT_LT(drawn.field.samples.points.front().norm(), 1e-9);
    const Eigen::Vector3d far(20 * 0.3048, 20 * 0.3048, 8 * 0.3048);
    EXPECT_LT((drawn.field.samples.points.back() - far).norm(), 1e-6);
  }
  EXPECT_FALSE(draw_field(design.loaded(), 68'921, {}).coarse);
}

TEST(DrawnField, IsOverAGridWhereTheSceneIsAdaptive) {
  Design design = design_of("06-furnished-lab");
  change(design, {{"sample.volume.adaptive.depth", "3"}});
  const DrawnField coarse = draw_field(design.loaded(), 5000, {});
  EXPECT_TRUE(coarse.coarse);
  EXPECT_TRUE(
      std::holds_alternative<GridShape>(coarse.field.samples.parts.at(0).shape));
  const DrawnField full = draw_field(design.loaded(), 0, {});
  EXPECT_FALSE(full.coarse);
  EXPECT_TRUE(std::holds_alternative<GridShape>(full.field.samples.parts.at(0).shape));
  EXPECT_EQ(full.summary["volume"].is_object(), true) << "statistics are the octree's";
}

TEST(DrawnField, CarriesSurfacesAndPaths) {
  const Unpacked torso =
      unpack(packed(draw_field(design_of("07-torso").loaded(), 0, {}), 0));
  EXPECT_EQ(torso.head["parts"][0]["kind"], "surface");
  EXPECT_EQ(torso.head["parts"][0]["corners"].get<std::size_t>() % 3, 0u);
  const Unpacked path =
      unpack(packed(draw_field(design_of("17-crowded-room").loaded(), 0, {}), 0));
  EXPECT_EQ(path.head["parts"][0]["kind"], "points");
}

}  // namespace
}  // namespace delos::session
