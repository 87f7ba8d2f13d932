// Metrics by formulas: the built-in metrics themselves where a formula says so, bit for
// bit; undefined where a part is; the same for any number of threads.
#include "delos/model/metric_expression.h"

#include <gtest/gtest.h>

#include <cmath>

#include "delos/field/point.h"
#include "delos/field/soft_field.h"
#include "delos/field/spec.h"
#include "support/rigs.h"

namespace delos {
namespace {

/// @param unit where the formula leaves it open
Metric own_metric(const KnownMetrics& known, const std::string& formula,
                  bool larger = false, const std::string& unit = "1") {
  auto metric = make_metric("own", formula, larger, "", known);
  if (std::holds_alternative<ExpressionProblem>(metric))
    metric = make_metric("own", formula, larger, unit, known);
  if (const auto* problem = std::get_if<ExpressionProblem>(&metric)) {
    ADD_FAILURE() << formula << ": " << problem->sentence;
    return {};
  }
  return std::get<Metric>(std::move(metric));
}

/// Speakers of which each hears a part of the volume: some samples are blind.
System short_sighted(Fusion fusion = Fusion::stacked) {
  System system = testing::acoustic_system();
  system.fusion = fusion;
  for (PlacedDevice& device : system.devices)
    device.device = std::make_shared<testing::TestFullRange>(0.005, 0.75);
  return system;
}

const Samples kOwnSamples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.1);

Field own_field(const System& system, const Metric& metric, int threads = 2) {
  return evaluate_field(system, kOwnSamples, {}, metric, {.threads = threads});
}

TEST(MetricExpression, IsTheBuiltInMetricItNames) {
  int blind = 0, seen = 0;
  for (const Fusion fusion : {Fusion::stacked, Fusion::sequential}) {  // lanes, general
    const System system = short_sighted(fusion);
    for (const std::string& name : metric_names(system.motion.layout)) {
      const Metric built_in = testing::metric_of(system, name),
                   own = own_metric(system.motion.layout, name,
                                    built_in.larger_is_better);
      EXPECT_EQ(own.unit, built_in.unit) << name;
      const Field expected = own_field(system, built_in),
                  found = own_field(system, own);
      EXPECT_EQ(found.value, expected.value) << name;
      EXPECT_EQ(found.observable, expected.observable) << name;
      EXPECT_EQ(found.lost, expected.lost) << name;
      for (const double value : expected.value) ++(std::isinf(value) ? blind : seen);
    }
  }
  EXPECT_GT(blind, 1000);
  EXPECT_GT(seen, 1000);
}

// √P_xx is how σ_x is defined; trace and σ_horizontal are sums of the same entries.
TEST(MetricExpression, ReadsEntriesOfP) {
  const System system = short_sighted();
  const KnownMetrics known{system.motion.layout};
  const auto same = [&](const std::string& formula, const std::string& name) {
    const Field expected = own_field(system, testing::metric_of(system, name)),
                found = own_field(system, own_metric(known, formula));
    for (std::size_t i = 0; i < expected.value.size(); ++i) {
      if (std::isinf(expected.value[i]))
        EXPECT_TRUE(std::isinf(found.value[i])) << formula;
      else
        EXPECT_NEAR(found.value[i], expected.value[i], 2e-15 * expected.value[i]);
    }
  };
  same("sqrt(P[x, x])", "sigma_x");
  same("sqrt(P[vz,vz])", "sigma_vz");
  same("P[x,x] + P[y,y] + P[z,z]", "trace");
  same("sqrt(sigma_x^2 + sigma_y^2)", "sigma_horizontal");
}

TEST(MetricExpression, IsWhatItSaysOfTheSteadyState) {
  const System system = testing::acoustic_system();
  const KnownMetrics known{system.motion.layout};
  const Eigen::Vector3d p(0.1, 0.3, 0.4);
  const FusedState state = testing::state_at(system, {Eigen::Matrix3d::Identity(), p});
  const StateMatrix& P = state.prior;
  const Samples one = testing::points({p});
  const auto value = [&](const Metric& metric) {
    return evaluate_field(system, one, {}, metric).value.front();
  };
  const double flat = std::sqrt(P(2, 2) / P(0, 0));
  EXPECT_NEAR(value(own_metric(known, "sigma_z / sigma_x")), flat, 1e-13 * flat);
  const double rho = P(0, 3) / std::sqrt(P(0, 0) * P(3, 3));
  EXPECT_NEAR(value(own_metric(known, "P[x, vx]/sqrt(P[x,x]*P[vx,vx])")), rho, 1e-12);
  EXPECT_NEAR(value(own_metric(known, "P[vx, x]/(sigma_x*sigma_vx)")), rho, 1e-12);
  EXPECT_NEAR(value(own_metric(known, "coverage*z - x/y")), 4 * 0.4 - 0.1 / 0.3, 1e-15);
  EXPECT_NEAR(value(own_metric(known, "latency*sigma_vx")),
              state.time_constant * std::sqrt(P(3, 3)), 1e-12);
  // A scene's own metrics read those before them.
  KnownMetrics more = known;
  more.own.push_back(own_metric(known, "sigma_z / sigma_x"));
  EXPECT_NEAR(value(own_metric(more, "own^2 + 1")), flat * flat + 1, 1e-12);

  System with_own = system;
  with_own.own_metrics = more.own;
  const PointReport report = evaluate_point(with_own, {Eigen::Matrix3d::Identity(), p},
                                            testing::metric_of(system, "eigmax"));
  EXPECT_EQ(report.metrics.back().metric.name, "own");
  EXPECT_NEAR(report.metrics.back().value, flat, 1e-12);
}

// 1/∞ isn't 0, and ∞/∞ isn't 1: what isn't known of a part isn't known of the whole,
// whichever way is better.
TEST(MetricExpression, IsUndefinedWhereAPartIs) {
  const System system = short_sighted();
  const KnownMetrics known{system.motion.layout};
  const Field sigma = own_field(system, testing::metric_of(system, "eigmax"));
  for (const bool larger : {false, true})
    for (const char* formula : {"1/eigmax", "eigmax/eigmax", "exp(-eigmax/0.1)",
                                "min(eigmax, 1)", "0*eigmax", "eigmax + coverage"}) {
      const Metric own = own_metric(known, formula, larger);
      const Field found = own_field(system, own);
      const Spec spec{"", own, larger ? Relation::at_least : Relation::at_most,
                      larger ? -1e9 : 1e9};
      std::size_t finite = 0;
      for (std::size_t i = 0; i < sigma.value.size(); ++i) {
        EXPECT_EQ(std::isinf(found.value[i]), std::isinf(sigma.value[i])) << formula;
        finite += std::isfinite(sigma.value[i]);
      }
      EXPECT_EQ(share_meeting(found, spec).met, finite) << formula;
      EXPECT_LT(finite, sigma.value.size());
    }
  // What has no value there is undefined too.
  for (const char* formula :
       {"1/(z - z)", "sqrt(-1 - coverage)", "log(coverage - coverage)"})
    for (const double value : own_field(system, own_metric(known, formula)).value)
      EXPECT_EQ(value, std::numeric_limits<double>::infinity()) << formula;
}

// Entries and metrics of what is seen stay finite where another direction is lost.
TEST(MetricExpression, ReadsWhatIsKnownWhereTheRestIsLost) {
  System system = testing::acoustic_system();
  // Two speakers above (0.1, y): x of the target is lost to first order.
  system.devices.resize(2);
  for (PlacedDevice& device : system.devices) device.X_WS().p.x() = 0.1;
  const KnownMetrics known{system.motion.layout};
  const Samples one = testing::points({{0.1, 0.2, 0.3}});
  const auto value = [&](const char* formula) {
    return evaluate_field(system, one, {}, own_metric(known, formula)).value.front();
  };
  EXPECT_TRUE(std::isinf(value("sigma_x")));
  EXPECT_TRUE(std::isinf(value("sigma_y/sigma_x")));
  EXPECT_TRUE(std::isinf(value("P[x,y]/P[y,y]")));
  const double y =
      evaluate_field(system, one, {}, testing::metric_of(system, "sigma_y"))
          .value.front();
  EXPECT_TRUE(std::isfinite(y));
  EXPECT_EQ(value("sigma_y"), y);
  EXPECT_NEAR(value("P[y,y]"), y * y, 1e-14 * y * y);
}

TEST(MetricExpression, IsTheSameForAnyNumberOfThreads) {
  const System system = short_sighted();
  const Metric own =
      own_metric(system.motion.layout,
                 "sigma_z/sigma_x + coverage*P[x,y]/P[x,x] + log(1 + x*x/z)", false);
  const Field one = own_field(system, own, 1);
  for (const int threads : {2, 3, 5})
    EXPECT_EQ(own_field(system, own, threads).value, one.value);
}

TEST(MetricExpression, HasAUnit) {
  const StateLayout layout{.pose = PoseState::pose, .order = 3, .extra = {"bias"}};
  const auto unit = [&](const char* formula) {
    return own_metric(layout, formula).unit;
  };
  EXPECT_EQ(unit("sigma_z/sigma_x"), "1");
  EXPECT_EQ(unit("2*sigma_x + 0.001"), "m");
  EXPECT_EQ(unit("sigma_vx"), "m/s");
  EXPECT_EQ(unit("sigma_aroll/sigma_roll"), "s^-2");
  EXPECT_EQ(unit("P[x, vroll]"), "m rad/s");
  EXPECT_EQ(unit("sqrt(P[x,x]) + min(sigma_y, x)"), "m");
  EXPECT_EQ(unit("(sigma_x^2 + sigma_y^2)^(1/2)"), "m");
  EXPECT_EQ(unit("trace^2"), "m^4");
  EXPECT_EQ(unit("1/sigma_x"), "m^-1");
  EXPECT_EQ(unit("latency*sigma_vx"), "m");
  EXPECT_EQ(unit("sin(sigma_roll) + coverage"), "1");
  EXPECT_EQ(unit("exp(-coverage)"), "1");
  EXPECT_EQ(unit("mle"), std::get<Metric>(parse_metric("mle", layout)).unit);
  EXPECT_EQ(own_metric(layout, "sigma_x + 0.1*sigma_roll", false, "m").unit, "m");
  for (const char* formula :
       {"sigma_x + 0.1*sigma_roll", "sqrt(sigma_x)", "log(sigma_x)",
        "sigma_x^sigma_bias", "max(sigma_x, trace)"}) {
    const auto open = make_metric("own", formula, false, "", layout);
    ASSERT_TRUE(std::holds_alternative<ExpressionProblem>(open)) << formula;
    EXPECT_NE(std::get<ExpressionProblem>(open).sentence.find("has no unit"),
              std::string::npos);
  }
  const auto other = make_metric("own", "sigma_x", false, "rad", layout);
  ASSERT_TRUE(std::holds_alternative<ExpressionProblem>(other));
  EXPECT_EQ(std::get<ExpressionProblem>(other).sentence, "is in m, not in rad");
  EXPECT_TRUE(std::holds_alternative<ExpressionProblem>(
      make_metric("own", "pi", false, "", layout)));
}

// By the rules of monotone functions, by hand.
TEST(MetricExpression, KnowsWhatGetsWorseWhereLessIsKnown) {
  const StateLayout layout{.pose = PoseState::position, .order = 1, .extra = {}};
  for (const char* formula :
       {"eigmax", "sqrt(sigma_x^2 + 2*sigma_z^2)", "trace/3 + 0.1", "log(eigmax/0.1)",
        "max(sigma_x, sigma_y, 2*sigma_z)", "sigma_x*sigma_y", "-1/sigma_x",
        "exp(sigma_x/2)/mle", "P[x,x]^0.5", "abs(-sigma_x)", "sigma_x/coverage",
        "1 - (-sigma_x - sigma_y)", "x + sigma_x"}) {
    const Metric metric = own_metric(layout, formula);
    EXPECT_TRUE(metric.monotone) << formula;
  }
  EXPECT_TRUE(own_metric(layout, "1/sigma_x", true).monotone);
  for (const char* formula :
       {"sigma_z/sigma_x", "sigma_x - sigma_y", "P[x,y]", "1/eigmax", "x*sigma_x",
        "sin(sigma_x/1)", "footprint", "coverage", "abs(P[x,y])", "P[x,y]^2"}) {
    const Metric metric = own_metric(layout, formula);
    EXPECT_FALSE(metric.monotone) << formula;
  }
}

/// Where no two states are alike: at a tie a maximum has no slope.
const Samples kAsymmetric = testing::volume({0.013, 0.029, 0}, {0.4, 0.4, 0.8}, 0.1);

/// Σ over samples of a metric, softly, and its slopes.
std::pair<double, std::vector<PoseSlope>> soft_sum(const System& system,
                                                   const Metric& metric) {
  SoftField field(kAsymmetric, {}, {metric});
  double sum = 0;
  for (const double value : field.evaluate(system, 0.1)[0]) sum += value;
  field.adjoin({std::vector<double>(kAsymmetric.points.size(), 1.0)});
  return {sum, field.pose_slopes()};
}

TEST(MetricExpression, HasTheSlopesOfTheMetricItNames) {
  System system = short_sighted();
  system.prior = 1;
  for (const char* name : {"sigma_x", "eigmax", "sigma_position", "trace", "det", "mle",
                           "coverage", "sigma_vz"}) {
    const Metric built_in = testing::metric_of(system, name);
    const auto expected = soft_sum(system, built_in),
               found = soft_sum(system, own_metric(system.motion.layout, name));
    EXPECT_EQ(found.first, expected.first) << name;
    for (std::size_t i = 0; i < system.devices.size(); ++i)
      EXPECT_EQ(found.second[i], expected.second[i]) << name;
  }
}

// Central differences with a step of 1e-6 m: rounding of the sum, 1e-16/1e-6 of it, and
// (h/0.1 m)² of the slope.
TEST(MetricExpression, HasTheSlopesOfCentralDifferences) {
  System system = short_sighted();
  system.prior = 1;
  for (const char* formula :
       {"sigma_z/sigma_x", "P[x,y]/P[x,x]", "P[x, vx]*coverage + z*sigma_y",
        "exp(-eigmax)*coverage^2", "max(sigma_x, sigma_y)/sqrt(trace)"}) {
    const Metric own = own_metric(system.motion.layout, formula);
    const auto [sum, slopes] = soft_sum(system, own);
    for (std::size_t i = 0; i < 2; ++i)
      for (int k = 0; k < 3; ++k) {
        constexpr double kStep = 1e-6;
        System up = system, down = system;
        up.devices[i].X_WS().p(k) += kStep;
        down.devices[i].X_WS().p(k) -= kStep;
        const double difference =
            (soft_sum(up, own).first - soft_sum(down, own).first) / (2 * kStep);
        EXPECT_NEAR(slopes[i](k), difference,
                    1e-6 * slopes[i].norm() + 1e-8 * std::abs(sum))
            << formula;
      }
  }
}

}  // namespace
}  // namespace delos
