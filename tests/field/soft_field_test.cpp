// Soft fields: the hard field where edges are hard, and slopes against central
// differences, with and without the device's own.
#include "delos/field/soft_field.h"

#include <gtest/gtest.h>

#include "support/rigs.h"

namespace delos {
namespace {

/// The acoustic law with its slopes, but doesn't say where balls are.
class SilentRange final : public testing::TestFullRange {
 public:
  using TestFullRange::TestFullRange;
  View view_of_ball(const Eigen::Vector3d&, double) const override {
    return View::unknown;
  }
};

template <class Range>
System rig(double reach = 1e9) {
  System system = testing::acoustic_system();
  for (PlacedDevice& device : system.devices)
    device.device = std::make_shared<Range>(0.005, reach);
  return system;
}

const Samples kSamples = testing::volume({0.01, 0, 0}, {0.4, 0.3, 0.8}, 0.1);

// What is far out of view is left out unasked, and nobody can tell.
TEST(SoftField, IsTheSameWhereDevicesSayWhereBallsAre) {
  System plain = rig<SilentRange>(1.0), culled = rig<testing::TestFullRange>(1.0);
  plain.prior = culled.prior = 1e-3;
  const Metric metric = testing::metric_of(plain, "sigma_position");
  for (const double width : {0.1, 0.01}) {
    SoftField one(kSamples, {}, {metric}), other(kSamples, {}, {metric});
    const auto &expected = one.evaluate(plain, width)[0],
               &values = other.evaluate(culled, width)[0];
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(values[i], expected[i], 1e-6 * expected[i]) << i;
  }
}

TEST(SoftField, IsTheFieldWhereEdgesAreHard) {
  System system = rig<testing::TestFullRange>(1.1);
  system.devices[1].noise = 2.5;
  const Metric metric = testing::metric_of(system, "sigma_position");
  SoftField soft(kSamples, {}, {metric});
  const auto& values = soft.evaluate(system, 0);
  const Field field = evaluate_field(system, kSamples, {}, metric);
  int blind = 0;
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    blind += std::isinf(field.value[i]);
    if (std::isinf(field.value[i]))
      EXPECT_TRUE(std::isinf(values[0][i]));
    else
      EXPECT_NEAR(values[0][i], field.value[i], 1e-9 * field.value[i]);
  }
  EXPECT_GT(blind, 0);
  EXPECT_LT(blind, static_cast<int>(field.value.size()));
}

template <class Range>
void expect_slopes(double reach, double width) {
  System system = rig<Range>(reach);
  system.prior = 1;
  system.devices[0].noise = 1.7;
  const Metric metric = testing::metric_of(system, "sigma_z");
  const std::vector<std::vector<double>> ones(
      1, std::vector<double>(kSamples.points.size(), 1.0));
  SoftField soft(kSamples, {}, {metric});
  soft.evaluate(system, width);
  soft.adjoin(ones);
  const std::vector<PoseSlope> slopes = soft.pose_slopes();
  ASSERT_EQ(slopes.size(), system.devices.size());
  const auto sum = [&](const System& at) {
    SoftField other(kSamples, {}, {metric});
    double total = 0;
    for (const double value : other.evaluate(at, width)[0]) total += value;
    return total;
  };
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      constexpr double kStep = 1e-5;
      System up = system, down = system;
      up.devices[i].X_WS().p(k) += kStep;
      down.devices[i].X_WS().p(k) -= kStep;
      EXPECT_NEAR(slopes[i](k), (sum(up) - sum(down)) / (2 * kStep),
                  1e-6 * slopes[i].norm());
    }
    // A range doesn't turn.
    EXPECT_LT(slopes[i].tail<3>().norm(), 1e-9 * slopes[i].head<3>().norm());
  }
}

TEST(SoftField, SlopesOfTheDevice) { expect_slopes<testing::TestFullRange>(1.1, 0.2); }

TEST(SoftField, SlopesByDifferences) { expect_slopes<testing::TestRange>(1e9, 0.2); }

// A failure is the field of the other devices, and what it costs pulls at those alone.
TEST(SoftField, FailuresAreFieldsOfTheOtherDevices) {
  System system = rig<testing::TestFullRange>(1.1);
  system.prior = 1;
  const std::vector<Metric> metrics = {testing::metric_of(system, "sigma_position"),
                                       testing::metric_of(system, "sigma_z")};
  const std::vector<std::size_t> failing = {2, 0};
  SoftField soft(kSamples, {}, metrics);
  const FieldValues all = soft.evaluate(system, 0.2, failing);
  SoftField other(kSamples, {}, metrics);
  const FieldValues sum = other.evaluate(system, 0.2);
  ASSERT_EQ(soft.failure_values().size(), 2u);
  const FieldValues ones(2, std::vector<double>(kSamples.points.size(), 1.0)),
      none(2, std::vector<double>(kSamples.points.size(), 0.0));
  for (std::size_t k = 0; k < 2; ++k) {
    System rest = system;
    rest.devices.erase(rest.devices.begin() + static_cast<std::ptrdiff_t>(failing[k]));
    const FieldValues of_rest_alone = other.evaluate(rest, 0.2);
    for (std::size_t m = 0; m < 2; ++m) {
      for (std::size_t p = 0; p < kSamples.points.size(); ++p) {
        EXPECT_NEAR(all[m][p], sum[m][p], 1e-12 * sum[m][p]);
        EXPECT_NEAR(soft.failure_values()[k][m][p], of_rest_alone[m][p],
                    1e-12 * of_rest_alone[m][p]);
      }
    }
    other.adjoin(ones);
    const std::vector<PoseSlope> expected = other.pose_slopes();
    std::vector<FieldValues> slopes = {none, none};
    slopes[k] = ones;
    soft.adjoin(none, slopes);
    const std::vector<PoseSlope> found = soft.pose_slopes();
    const double size = expected[0].norm();
    EXPECT_GT(size, 0);
    for (std::size_t i = 0, of_rest = 0; i < system.devices.size(); ++i) {
      const PoseSlope wanted =
          i == failing[k] ? PoseSlope(PoseSlope::Zero()) : expected[of_rest++];
      EXPECT_LT((found[i] - wanted).norm(), 1e-12 * size) << i;
    }
  }
}

// A wall that ends short of the sight line: the nearer, the less is seen, down to
// nothing where the line is hidden, and the edge hardens with the width.
TEST(SoftField, ShadowsHaveSoftEdges) {
  System system = rig<testing::TestFullRange>();
  system.prior = 1e-4;
  system.devices.resize(1);
  system.devices[0].X_WS().p = {0, 0, 2};
  const auto variance_at = [&](double edge, double width) {
    OccluderEntry wall;
    wall.body = BoxShape{{-1, -1, 0.9}, {edge, 1, 1}};
    system.occluders = {wall};
    system.in_world = Occluders({body_mesh(wall.body)});
    const Samples below = testing::points({{0, 0, 0}});
    const Metric metric = testing::metric_of(system, "sigma_z");
    SoftField soft(below, {}, {metric});
    return soft.evaluate(system, width)[0][0];
  };
  const double free = variance_at(-0.5, 0.3), hidden = variance_at(0.1, 0.3);
  EXPECT_GT(hidden, 3 * free);
  double last = free;
  for (const double edge : {-0.15, -0.1, -0.05, -0.02, -0.001, 0.1}) {
    const double here = variance_at(edge, 0.3);
    EXPECT_GT(here, last);
    last = here;
  }
  EXPECT_EQ(variance_at(-0.05, 0), free);
  EXPECT_EQ(variance_at(-0.05, 0.01), free);
}

}  // namespace
}  // namespace delos
