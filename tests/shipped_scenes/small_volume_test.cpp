// Speakers, cameras and both over the volume of Allen and Welch (2005): what the scenes
// 01 to 03 claim in their opening comments. Values to their printed digits; the same to
// ten digits stand in oracle.csv.
#include <algorithm>
#include <tuple>

#include "shipped.h"

namespace delos::test {
namespace {

constexpr double kSide = 0.4;  // of the volume's floor, m

/// The four speakers of the hybrid by themselves, on its samples: those of scene 01
/// above the corners.
Field speakers_of_the_hybrid(std::vector<Override> overrides = {}) {
  overrides.push_back({"sample.volume.max.z", "0.8"});
  overrides.push_back({"sample.volume.step", "0.04"});
  for (const auto& [name, x, y] : {std::tuple{"s1", "0", "0"},
                                   {"s2", "0.4", "0"},
                                   {"s3", "0", "0.4"},
                                   {"s4", "0.4", "0.4"}})
    overrides.push_back({std::string("devices.") + name + ".at",
                         std::string("[") + x + ", " + y + ", 1.0485]"});
  return field_of("01-acoustic", overrides);
}

/// Allen (2007), Table 6.2: 0.0817 and 0.0170 m at 50 Hz; Fig. 4.8: best inside of the
/// volume.
TEST(Acoustic, HasThePublishedExtremes) {
  const Field field = field_of("01-acoustic");
  const FieldStatistics s = summarize(field);
  EXPECT_EQ(s.observable, 25578u);  // 21·21·58
  EXPECT_NEAR(s.max.value, 0.0817, 5e-5);
  EXPECT_NEAR(s.min.value, 0.0170, 5e-5);
  const auto worst = where(field, s.max.value);
  EXPECT_EQ(worst.size(), 4u);
  for (const auto& p : worst) EXPECT_TRUE(in_corner(p, kSide) && p.z() == 0);
  const auto best = where(field, s.min.value);
  ASSERT_EQ(best.size(), 1u);
  EXPECT_LT((best[0] - Eigen::Vector3d(0.2, 0.2, 1.0)).norm(), 1e-9);
}

/// The paper, section 3.3: best at the horizontal centre at 0.24 m, first overlap of
/// the frusta at 0.68 m, worst at the bottom corners.
TEST(EightCameras, HaveThePublishedBestWorstAndReach) {
  const Field field = field_of("02-eight-cameras");
  const FieldStatistics s = summarize(field);
  EXPECT_NEAR(s.min.value, 0.01890, 5e-6);
  EXPECT_NEAR(s.max.value, 0.03056, 5e-6);
  const auto best = where(field, s.min.value);
  ASSERT_EQ(best.size(), 1u);
  EXPECT_LT((best[0] - Eigen::Vector3d(0.2, 0.2, 0.24)).norm(), 1e-9);
  const auto worst = where(field, s.max.value);
  EXPECT_EQ(worst.size(), 4u);
  for (const auto& p : worst) EXPECT_TRUE(in_corner(p, kSide) && p.z() == 0);
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    EXPECT_EQ(field.observable[i] != 0, field.samples.points[i].z() < 0.68 + 1e-9)
        << field.samples.points[i].transpose();
  }
  EXPECT_EQ(s.observable, 2178u);
}

/// The paper, section 3.4: the best region moves to the top four corners of the working
/// volume, at 0.68 m; the cameras' blind layers are seen.
TEST(Hybrid, IsBestAtTheTopCorners) {
  const Field field = field_of("03-hybrid");
  const FieldStatistics s = summarize(field);
  EXPECT_EQ(s.observable, 2541u);
  EXPECT_NEAR(s.min.value, 0.01509, 5e-6);
  const auto best = where(field, s.min.value);
  EXPECT_EQ(best.size(), 4u);
  for (const auto& p : best) {
    EXPECT_TRUE(in_corner(p, kSide)) << p.transpose();
    EXPECT_NEAR(p.z(), 0.68, 1e-9);
  }
}

/// More information is never worse. Where the cameras see nothing the speakers are all
/// there is, alone and together: two sums of the same terms, in which only rounding
/// differs. Hence the slack.
TEST(Hybrid, IsNowhereWorseThanEitherPart) {
  const Field hybrid = field_of("03-hybrid");
  const std::vector<Override> continuous = {{"fusion", "continuous"}};
  const Field speakers = speakers_of_the_hybrid(continuous);
  const Field cameras = field_of("02-eight-cameras", continuous);
  ASSERT_EQ(hybrid.samples.points, speakers.samples.points);
  ASSERT_EQ(hybrid.samples.points, cameras.samples.points);
  int equal = 0;
  for (std::size_t i = 0; i < hybrid.value.size(); ++i) {
    const double part = std::min(speakers.value[i], cameras.value[i]);
    EXPECT_LE(hybrid.value[i], part * (1 + 1e-9))
        << hybrid.samples.points[i].transpose();
    equal += hybrid.value[i] > part * (1 - 1e-9);
  }
  // Above 0.68 m many points are seen by no camera at all, but not most of the volume.
  EXPECT_LT(equal, 11 * 11 * 3 + 1);
}

/// The scene's own factor: at most 0.931 of the better part where the parts are
/// stacked.
TEST(Hybrid, IsWellBelowTheStackedParts) {
  const Field hybrid = field_of("03-hybrid"), speakers = speakers_of_the_hybrid(),
              cameras = field_of("02-eight-cameras");
  double greatest = 0;
  for (std::size_t i = 0; i < hybrid.value.size(); ++i) {
    greatest = std::max(
        greatest, hybrid.value[i] / std::min(speakers.value[i], cameras.value[i]));
  }
  EXPECT_NEAR(greatest, 0.931, 5e-4);
}

}  // namespace
}  // namespace delos::test
