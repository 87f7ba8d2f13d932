// Rooms with cameras on the walls: what the scenes 04 and 05 claim.
#include <algorithm>

#include "shipped.h"

namespace delos::test {
namespace {

constexpr double kFoot = 0.3048;

/// Allen and Welch (2005), section 3.5: best height 5.6 ft, best near the pairs and not
/// in the centre. 2.5 ft in front of a pair: the scene's geometry, which is inferred.
TEST(MotionCapture, IsBestBesideThePairs) {
  const Field field = field_of("04-motion-capture");
  const FieldStatistics s = summarize(field);
  EXPECT_NEAR(s.min.value, 0.001578, 5e-7);
  const auto best = where(field, s.min.value);
  ASSERT_EQ(best.size(), 4u);  // one before each of the four walls
  for (const Eigen::Vector3d& p : best) {
    EXPECT_NEAR(p.z(), 5.6 * kFoot, 1e-9);
    const Eigen::Vector3d from_centre = p - Eigen::Vector3d(10, 10, 5.6) * kFoot;
    EXPECT_NEAR(from_centre.cwiseAbs().maxCoeff(), 7.5 * kFoot, 1e-9);
    EXPECT_NEAR(from_centre.norm(), 7.5 * kFoot, 1e-9);
  }
}

/// 0.0030315 m in the middle: oracle.csv.
TEST(MotionCapture, IsTwiceAsGoodThereAsInTheCentre) {
  const Field field = field_of("04-motion-capture");
  const double centre = value_at(field, Eigen::Vector3d(10, 10, 5.6) * kFoot);
  EXPECT_NEAR(centre, 0.0030315, 5e-8);
  EXPECT_LT(1.9 * summarize(field).min.value, centre);
}

/// The height of the best layer: the least value of each layer, compared.
TEST(MotionCapture, HasItsBestLayerAtTheHeightBetweenTheCameras) {
  const Field field = field_of("04-motion-capture");
  const auto& grid = std::get<GridShape>(field.samples.parts.at(0).shape);
  const auto layer = static_cast<std::size_t>(grid.counts[0] * grid.counts[1]);
  std::vector<double> least;
  for (std::size_t i = 0; i < field.value.size(); i += layer) {
    const auto first = field.value.begin() + static_cast<std::ptrdiff_t>(i);
    least.push_back(
        *std::min_element(first, first + static_cast<std::ptrdiff_t>(layer)));
  }
  ASSERT_EQ(least.size(), 41u);  // 0 to 8 ft, each 0.2 ft
  EXPECT_EQ(std::min_element(least.begin(), least.end()) - least.begin(), 28);
}

/// The paper: dead corners. The scene: 2 ft and less from both walls, at every height.
TEST(MotionCapture, IsBlindInTheCorners) {
  const Field field = field_of("04-motion-capture");
  int corners = 0, seen = 0;
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    const Eigen::Vector3d p = field.samples.points[i] / kFoot;
    seen += field.observable[i];
    if (std::min(p.x(), 20 - p.x()) > 2 + 1e-9) continue;
    if (std::min(p.y(), 20 - p.y()) > 2 + 1e-9) continue;
    ++corners;
    EXPECT_EQ(field.observable[i], 0) << p.transpose();
  }
  EXPECT_EQ(corners, 4 * 5 * 5 * 41);
  EXPECT_GT(seen, 41 * 41 * 41 / 2);
}

/// Counts and values of the scene's own comment; two cameras see all directions of a
/// point, one doesn't.
TEST(Laboratory, SeesWhatTwoCamerasSee) {
  const Field field = field_of("05-optitrack-lab");
  const Field coverage = field_of("05-optitrack-lab", {{"metric", "coverage"}});
  const FieldStatistics s = summarize(field);
  EXPECT_EQ(s.samples, 10296u);
  EXPECT_EQ(s.observable, 10181u);
  EXPECT_NEAR(s.min.value, 0.000423, 5e-7);
  EXPECT_NEAR(s.max.value, 0.001892, 5e-7);
  EXPECT_NEAR(s.mean, 0.000567, 5e-7);
  EXPECT_EQ(std::count(coverage.value.begin(), coverage.value.end(), 8.0), 2190);
  EXPECT_EQ(summarize(coverage).max.value, 8);
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    EXPECT_EQ(field.observable[i] != 0, coverage.value[i] >= 2);
  }
}

}  // namespace
}  // namespace delos::test
