// Single points: shares, lost directions, the careful path.
#include "delos/field/point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/rigs.h"

namespace delos {
namespace {

PointReport report_of(const System& system, const Eigen::Vector3d& at,
                      const std::string& metric = "eigmax") {
  return evaluate_point(system, {Eigen::Matrix3d::Identity(), at},
                        testing::metric_of(system, metric));
}

TEST(Point, SharesAreTheRiseWithoutTheDevice) {
  const System system = testing::acoustic_system();
  const Eigen::Vector3d at(0.05, 0.1, 0.5);
  const PointReport whole = report_of(system, at);
  ASSERT_EQ(whole.devices.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    System without = system;
    without.devices.erase(without.devices.begin() + static_cast<std::ptrdiff_t>(i));
    const auto eigmax = [](const PointReport& r) {
      for (const MetricValue& m : r.metrics) {
        if (m.metric.name == "eigmax") return m.value;
      }
      return -1.0;
    };
    EXPECT_NEAR(whole.devices[i].share,
                eigmax(report_of(without, at)) / eigmax(whole) - 1, 1e-9);
    EXPECT_GT(whole.devices[i].share, 0);
  }
  EXPECT_TRUE(whole.careful);
  EXPECT_LT(whole.residual, 1e-12);
}

// The careful path reads rows, the other the layers' total; both know the prior.
TEST(Point, ThePriorIsInTheRowsToo) {
  for (const Fusion fusion : {Fusion::stacked, Fusion::continuous}) {
    System system = testing::acoustic_system();
    system.fusion = fusion;
    system.devices.resize(1);
    system.prior = 3;
    const PointReport report = report_of(system, {0.05, 0.1, 0.5});
    ASSERT_TRUE(report.careful);
    const FusedState expected = testing::state_at(system, report.pose);
    EXPECT_LT((report.state.prior - expected.prior).norm(),
              1e-9 * expected.prior.norm());
  }
}

TEST(Point, ADeviceThatAllDependsOnIsWorthInfinitelyMuch) {
  System system = testing::acoustic_system();
  system.devices.resize(3);
  system.devices.push_back(testing::place(
      "far", std::make_shared<testing::TestRange>(0.005, 0.1), Pose{}, 50));
  const PointReport report = report_of(system, {0.2, 0.1, 0.5});
  EXPECT_TRUE(std::isinf(report.devices[0].share));
  EXPECT_FALSE(report.devices[3].visible);
  EXPECT_EQ(report.devices[3].share, 0);
}

// Two ranges along x with speakers a distance ε apart see the third direction with
// information ~ε²: formed and summed, S has lost it below √machine precision; the rows
// themselves have not. The truth is the P-motion closed form along that direction.
TEST(Point, TheCarefulPathSeesWhatTheFormedInformationHasLost) {
  System system = testing::acoustic_system();
  const double epsilon = 1e-9, r = 0.01;
  Eigen::MatrixXd H = Eigen::Matrix3d::Identity();
  H.row(2) << 1, 0, epsilon;
  system.devices = {testing::place("nearly",
                                   std::make_shared<testing::TestLinear>(
                                       Span::point, H, r * Eigen::Matrix3d::Identity()),
                                   Pose{}, 50)};
  system.motion =
      testing::chain_motion(PoseState::position, 1, Eigen::Matrix3d::Identity());
  const PointReport report = report_of(system, {0, 0, 0}, "sigma_z");
  ASSERT_EQ(report.state.status, RiccatiStatus::converged);
  // S restricted to z, after x is known as well as it ever is: ε²/r · (1 − 1/2).
  const double lambda = epsilon * epsilon / r / 2, rho = 0.02 * lambda;
  const double truth = (rho + std::sqrt(rho * rho + 4 * rho)) / 2 / lambda;
  EXPECT_NEAR(report.state.prior(2, 2), truth, 1e-6 * truth);
}

}  // namespace
}  // namespace delos
