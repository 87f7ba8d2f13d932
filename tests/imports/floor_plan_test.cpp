// Floor plans as rooms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "imports/imported.h"

namespace delos::test {
namespace {

const PrismShape* prism_of(const Imported& got, std::size_t i) {
  return got.scene && i < got.scene->occluders.size()
             ? std::get_if<PrismShape>(&got.scene->occluders[i].body)
             : nullptr;
}

// An L of 6 m by 5 m with a column, in metres; a ring repeats its first point.
TEST(FloorPlan, OfGeoJsonIsARoomWithWhatStandsInIt) {
  const Imported got = imported({{"floor.geojson", R"({"type": "FeatureCollection",
    "features": [
      {"type": "Feature", "properties": {"name": "column", "height": 2},
       "geometry": {"type": "Polygon", "coordinates":
        [[[1, 1], [1.4, 1], [1.4, 1.4], [1, 1.4], [1, 1]]]}},
      {"type": "Feature", "properties": null, "geometry": {"type": "MultiPolygon",
       "coordinates": [[[[0, 0], [6, 0], [6, 3], [3, 3], [3, 5], [0, 5], [0, 0]]]]}},
      {"type": "Feature", "properties": {}, "geometry": {"type": "Point",
       "coordinates": [1, 1]}}]})"}});
  ASSERT_TRUE(got.system) << got.findings << got.text;
  ASSERT_EQ(got.scene->occluders.size(), 2u);
  EXPECT_TRUE(got.scene->occluders[0].room);
  EXPECT_FALSE(got.scene->occluders[1].room);
  ASSERT_TRUE(prism_of(got, 0) && prism_of(got, 1));
  EXPECT_EQ(prism_of(got, 0)->polygon.size(), 6u);
  EXPECT_EQ(prism_of(got, 0)->height, 2.5);
  EXPECT_EQ(prism_of(got, 1)->height, 2);
  EXPECT_EQ(got.system->devices.size(), 4u);
}

// A thousandth of a degree of latitude is 111.3 m on the equatorial radius, and of
// longitude, 60 degrees north, half of that.
TEST(FloorPlan, OnTheGlobeBecomesMetres) {
  const Imported got = imported({{"hall.geojson", R"({"type": "Polygon", "coordinates":
    [[[10, 60], [10.001, 60], [10.001, 60.001], [10, 60.001], [10, 60]]]})"}});
  ASSERT_TRUE(prism_of(got, 0)) << got.findings;
  const auto& corners = prism_of(got, 0)->polygon;
  EXPECT_NEAR(corners[2].x(), 55.66, 0.01);
  EXPECT_NEAR(corners[2].y(), 111.32, 0.01);
}

TEST(FloorPlan, OfSvgIsDrawnUpsideDown) {
  imports::ImportOptions options;
  options.unit = 0.01;
  options.height = 3;
  const Imported got = imported({{"floor.svg",
                                  "<svg><g><path d='M 0 0 h 600 v 400 H 0 Z'/>"
                                  "<rect x='100' y='100' width='50' height='20'/>"
                                  "<path d='M0 0 C 1 1 2 2 3 3'/></g></svg>"}},
                                options);
  ASSERT_TRUE(prism_of(got, 1)) << got.findings << got.text;
  EXPECT_NE(got.findings.find("has curves is left out"), std::string::npos);
  EXPECT_LT((prism_of(got, 0)->polygon[2] - Eigen::Vector2d(6, -4)).norm(), 1e-12);
  EXPECT_LT((prism_of(got, 1)->polygon[0] - Eigen::Vector2d(1, -1)).norm(), 1e-12);
  EXPECT_EQ(prism_of(got, 0)->height, 3);
}

TEST(FloorPlan, SaysWhatIsWrong) {
  const auto says = [](const std::string& name, const std::string& text,
                       const std::string& part) {
    const Imported got = imported({{name, text}});
    EXPECT_FALSE(got.rig) << text;
    EXPECT_NE(got.findings.find(part), std::string::npos) << got.findings;
  };
  says("a.json", R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 1]]]})",
       "three different points or more");
  says("a.json", R"({"type": "Polygon", "coordinates": [[[0, 0], [1, "a"]]]})",
       "a point must be [x, y]");
  says("a.json", R"({"type": "FeatureCollection", "features": []})",
       "has no closed outline");
  says("a.json",
       R"({"type": "Polygon", "coordinates": [[[0, 0], [6000, 0], [0, 5000]]]})",
       "is 6000 m wide; which unit is it in?");
  says("a.svg", "<svg><rect width='3' height='4'/></svg>", "say which by --unit mm");
}

// 200 damaged files of each kind: a scene in order, or what is wrong with the file or
// the scene.
TEST(FloorPlan, ThatIsDamagedIsReadOrRefused) {
  const std::vector<std::pair<std::string, std::string>> plans = {
      {"floor.geojson",
       R"({"type": "FeatureCollection", "features": [{"type": "Feature",
        "properties": {"name": "column", "height": 2}, "geometry": {"type": "Polygon",
        "coordinates": [[[1, 1], [1.4, 1], [1.4, 1.4], [1, 1.4], [1, 1]]]}}, {"type":
        "Feature", "properties": null, "geometry": {"type": "MultiPolygon",
        "coordinates": [[[[0, 0], [6, 0], [6, 3], [3, 3], [3, 5], [0, 5]]]]}}]})"},
      {"floor.svg",
       "<svg><g><path d='M 0 0 h 6 v 4 H 0 Z'/><rect x='1' y='1' width='0.5' "
       "height='0.2'/><polygon points='2,2 3,2 3,3'/></g></svg>"}};
  const std::vector<std::string> words = {"-1", "1e999", "]",  "[",    "nan",
                                          "'",  "<",     "{}", "null", "Z"};
  std::uint64_t state = 5;
  const auto below = [&](std::size_t n) {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<std::size_t>(state >> 33) % std::max<std::size_t>(n, 1);
  };
  imports::ImportOptions metres;
  metres.unit = 1;
  for (const auto& [name, whole] : plans) {
    ASSERT_TRUE(imported({{name, whole}}, metres).scene) << name;
    int refused = 0;
    for (int i = 0; i < 200; ++i) {
      std::string text = whole;
      for (std::size_t hits = 1 + below(3); hits > 0; --hits) {
        const std::size_t at = below(text.size());
        if (below(2) == 0)
          text.erase(at, 1 + below(20));
        else
          text.insert(at, words[below(words.size())]);
      }
      const Imported got = imported({{name, text}}, metres);
      ASSERT_TRUE(got.scene || !got.findings.empty()) << text;
      refused += !got.scene;
    }
    EXPECT_GT(refused, 20) << name;
    EXPECT_LT(refused, 200) << name;
  }
}

}  // namespace
}  // namespace delos::test
