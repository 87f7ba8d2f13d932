// Places beside P∞: scatter of the right size, and the surface through it.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "measured/windows.h"
#include "support/rigs.h"

namespace delos::measured {
namespace {

/// Along a line through the acoustic scene, P∞'s own deviations times `factor` off,
/// with a bend of the tracker of `bias` in the middle.
std::vector<MeasuredPath> drawn_paths(const System& system, double factor, double bias,
                                      bool with_truth) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  std::vector<MeasuredPath> paths;
  for (const double y : {0.05, 0.15, 0.25, 0.35}) {
    MeasuredPath path{"y", {}, {}, {}};
    for (int i = 0; i < 150; ++i) {
      const double s = i / 149.;
      const Eigen::Vector3d at(0.4 * s, y, 0.4);
      const FusedState state =
          testing::state_at(system, {Eigen::Matrix3d::Identity(), at});
      Eigen::Vector3d off = state.prior.diagonal().head<3>().cwiseSqrt() * factor;
      for (double& x : off) x *= normal(random);
      off.z() += bias * (1 - 4 * (s - 0.5) * (s - 0.5));
      path.t.push_back(0.02 * i);
      path.p.push_back(at + off);
      if (with_truth) path.truth.push_back(at);
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

TEST(Poses, ScatterOfPInfinityHasARatioOfOne) {
  const System system = testing::acoustic_system();
  for (const double factor : {1., 1.8}) {
    const auto answer =
        compare_poses(system, drawn_paths(system, factor, 0.1, true), 4);
    const auto& of = std::get<PosesComparison>(answer);
    ASSERT_EQ(of.paths.size(), 4u);
    for (int k = 0; k < 3; ++k)  // χ² of 4 × 145
      EXPECT_NEAR(of.scatter(k) / of.predicted(k), factor,
                  factor * 4.5 / std::sqrt(1160.));
    // √(mean over s of (0.1 (1 − 4 (s − ½)²))²) = 0.1 √(8/15), with what five
    // parameters take of the noise.
    ASSERT_TRUE(of.paths[0].bias);
    EXPECT_NEAR(of.paths[0].bias->z(), 0.1 * std::sqrt(8 / 15.), 0.004);
    EXPECT_LT(of.paths[0].bias->x(), 0.02 * factor);
  }
}

/// Without a truth the curve stands for it.
TEST(Poses, WithoutTruthScatterAboutACurve) {
  const System system = testing::acoustic_system();
  const auto answer = compare_poses(system, drawn_paths(system, 1.8, 0, false), 4);
  const auto& of = std::get<PosesComparison>(answer);
  EXPECT_FALSE(of.paths[0].bias);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(of.scatter(k) / of.predicted(k), 1.8, 1.8 * 5 / std::sqrt(1160.));
}

TEST(Poses, LeaveBlindPlacesOut) {
  System system = testing::acoustic_system();
  for (PlacedDevice& placed : system.devices)
    placed.device = std::make_shared<testing::TestRange>(0.005, 0.75);
  const auto answer =
      compare_poses(system, drawn_paths(testing::acoustic_system(), 1, 0, true), 4);
  const auto& of = std::get<PosesComparison>(answer);
  std::size_t blind = 0;
  for (const PathComparison& path : of.paths) blind += path.blind;
  EXPECT_GT(blind, 0u);
  EXPECT_LT(blind, 600u);
  EXPECT_TRUE(of.predicted.allFinite());
  const auto few =
      compare_poses(system, {{"short", {0, 1}, {{0, 0, 0}, {1, 0, 0}}, {}}}, 4);
  EXPECT_NE(std::get<std::string>(few).find("too few"), std::string::npos);
}

/// Windows are mean squares, and the surface goes through them.
TEST(Poses, WindowsMakeASurface) {
  const System system = testing::acoustic_system();
  const auto answer = compare_poses(system, drawn_paths(system, 1, 0, true), 4);
  const auto& of = std::get<PosesComparison>(answer);
  const auto windows = windows_of(of, 25);
  ASSERT_EQ(windows.size(), 24u);
  double squares = 0, single = 0;
  for (const Window& w : windows) squares += 25 * w.measured * w.measured;
  for (const ScatteredPlace& p : of.places) single += p.measured * p.measured;
  EXPECT_NEAR(squares, single, 1e-9 * single);
  EXPECT_EQ(windows_of(of, 100).size(), 4u);  // what is left joins the last
  const Field field = measured_surface(windows, WindowValue::measured, {}, "test");
  EXPECT_EQ(field.value.size(), field.samples.points.size());
  double least = 1e9, most = 0;
  for (const Window& w : windows) {
    least = std::min(least, w.measured);
    most = std::max(most, w.measured);
  }
  std::size_t inside = 0;
  for (const double value : field.value) {
    if (!std::isfinite(value)) continue;
    ++inside;
    EXPECT_GE(value, least - 1e-12);
    EXPECT_LE(value, most + 1e-12);
  }
  EXPECT_GT(inside, field.value.size() / 2);
  std::vector<Window> line(windows.begin(), windows.begin() + 6);
  for (Window& w : line) w.p.y() = 0;
  EXPECT_THROW(static_cast<void>(measured_surface(line, WindowValue::measured, {}, "")),
               std::invalid_argument);
}

}  // namespace
}  // namespace delos::measured
