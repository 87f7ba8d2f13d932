// Fronts and numbers of devices whose best designs are known in closed form.
#include "delos/optimize/tradeoff.h"

#include <atomic>

#include "optimizers/circle.h"

namespace delos::test {
namespace {

constexpr double kNoises[] = {0.01, 0.02, 0.08};

/// Three readings, one an axis, whose rates f share a budget B. The steady state of a
/// random walk, continuously: P²f/r = q, so that
///
///   trace P = Σ √(q r / f)
///
/// is least where f ∝ r^(1/3): √(q/B) (Σ r^(1/3))^(3/2).
std::string shared_rates() {
  return R"(delos: 1
name: Rates
motion: {type: position, q: [0.4, 0.4, 0.4]}
fusion: continuous
metric: trace
sample: {points: [[0, 0, 0]]}
devices:
  - {name: a, rate: 30, type: linear, params: {H: [[1, 0, 0]], R: [[0.01]]}}
  - {name: b, rate: 30, type: linear, params: {H: [[0, 1, 0]], R: [[0.02]]}}
  - {name: c, rate: 30, type: linear, params: {H: [[0, 0, 1]], R: [[0.08]]}}
variables:
  - {path: "devices.*.rate", lower: 5, upper: 500}
constraints:
  - {name: budget, sum: {devices.a.rate: 1, devices.b.rate: 1, devices.c.rate: 1}, at_most: 100}
objective: {minimize: mean, of: trace, guess: 1000}
)";
}

/// All three at one rate.
double trace_at(double rate) {
  double sum = 0;
  for (const double noise : kNoises) sum += std::sqrt(0.4 * noise / rate);
  return sum;
}

double least_trace(double budget) {
  double sum = 0;
  for (const double noise : kNoises) sum += std::cbrt(noise);
  return std::sqrt(0.4 / budget) * std::pow(sum, 1.5);
}

OptimizeOptions quick() {
  OptimizeOptions options;
  options.threads = 2;
  options.starts = 2;
  options.evaluations = 200;
  return options;
}

TEST(Front, OfRatesAgainstTheirSumIsTheClosedForm) {
  const Scene scene = parse(shared_rates());
  const auto points = search_front(scene, plugins(), "budget", {60, 240, 120}, quick());
  ASSERT_EQ(points.size(), 3u);
  const double budgets[] = {240, 120, 60};  // from the loosest
  for (std::size_t k = 0; k < 3; ++k) {
    const FrontPoint& p = points[k];
    EXPECT_EQ(p.limit, budgets[k]);
    EXPECT_TRUE(p.kept);
    EXPECT_FALSE(p.dominated);
    EXPECT_NEAR(p.used, p.limit, 1e-3 * p.limit);
    EXPECT_NEAR(p.objective, least_trace(p.limit), 1e-3 * p.objective);
    double cubes = 0, rates = 0;
    for (const double noise : kNoises) cubes += std::cbrt(noise);
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = std::cbrt(kNoises[i]) / cubes;
      EXPECT_NEAR(p.scene.devices[i].rate, p.limit * share, 0.02 * p.limit);
      rates += p.scene.devices[i].rate;
    }
    EXPECT_LE(rates, p.limit * (1 + 1e-9));
  }
}

/// A limit that nothing is to be had from: beyond 3 × 500 updates a second the budget
/// says nothing, and both points are the same design: neither is better.
TEST(Front, OfOneDesignDominatesNothing) {
  const Scene scene = parse(shared_rates());
  const auto points = search_front(scene, plugins(), "budget", {1600, 2000}, quick());
  ASSERT_EQ(points.size(), 2u);
  for (const FrontPoint& p : points) {
    EXPECT_NEAR(p.used, 1500, 1);
    EXPECT_TRUE(p.kept);
    EXPECT_FALSE(p.dominated);
  }
  EXPECT_NEAR(points[0].objective, points[1].objective, 1e-6 * points[0].objective);
}

/// Two speakers do best a right angle apart, √2 of the circle's radius: beyond, more
/// spacing costs accuracy, and every point of the front is worth having.
TEST(Front, OfALowerBoundGoesUpAndDominatesNothing) {
  const Scene scene = parse(circle({10, 130}, false) +
                            "constraints: [{name: apart, spacing: 1.5, devices: "
                            "\"d*\"}]\n");
  const auto points = search_front(scene, plugins(), "apart", {1.9, 1.5, 1.7}, quick());
  ASSERT_EQ(points.size(), 3u);
  const double spacings[] = {1.5, 1.7, 1.9};  // from the loosest
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(points[k].limit, spacings[k]);
    EXPECT_TRUE(points[k].kept);
    EXPECT_FALSE(points[k].dominated);
    EXPECT_NEAR(points[k].used, spacings[k], 1e-3);
    if (k > 0) {
      EXPECT_GT(points[k].objective, 1.01 * points[k - 1].objective);
    }
  }
}

/// A search that is cancelled before its first step ends where it began: at the design
/// that its neighbour found.
TEST(Front, GoesOnWhereTheNeighbourStopped) {
  const Scene scene = parse(shared_rates());
  OptimizeOptions options = quick();
  std::atomic<bool> cancel = false;
  options.cancel = &cancel;
  const auto points =
      search_front(scene, plugins(), "budget", {1600, 2000}, options,
                   [&](std::size_t done, std::size_t) { cancel = done == 1; });
  ASSERT_EQ(points.size(), 2u);
  EXPECT_TRUE(points[1].kept);
  EXPECT_NEAR(points[0].objective, trace_at(500), 1e-3 * points[0].objective);
  // Designs pass through the unit cube, which rounds.
  EXPECT_NEAR(points[1].objective, points[0].objective, 1e-12);
}

TEST(Front, RefusesAConstraintThatIsntThere) {
  const Scene scene = parse(shared_rates());
  try {
    (void)search_front(scene, plugins(), "cash", {1}, quick());
    FAIL() << "not refused";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_STREQ(refusal.what(), "there is no constraint 'cash'; there are budget");
  }
}

/// The specification lies between what three and what four speakers can do.
TEST(Counts, OfSpeakersAreTheClosedFormAndTellTheCheapestKit) {
  const double demand = (even_eigmax(3) + even_eigmax(4)) / 2;
  const Scene scene = parse(circle({10, 35, 80}, false) +
                            "constraints: [{name: spec, metric: eigmax, below: " +
                            std::to_string(demand) + "}]\n");
  const Prices prices = {{"acoustic_range", 20}, {"above", 5}};
  const auto points = search_counts(scene, plugins(), 3, 6, prices, quick());
  ASSERT_EQ(points.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    const DeviceCountPoint& p = points[k];
    const int speakers = static_cast<int>(k) + 2;
    EXPECT_EQ(p.devices, k + 3);
    EXPECT_EQ(p.scene.devices.size(), p.devices);
    EXPECT_EQ(p.scene.variables.size(), static_cast<std::size_t>(speakers));
    EXPECT_EQ(p.price, 20 * speakers + 5);
    // Where the demand can't be met, what misses it least is what is most accurate.
    EXPECT_NEAR(p.objective, even_eigmax(speakers), 1e-3 * p.objective) << speakers;
    EXPECT_EQ(p.kept, speakers >= 4);
  }
  const DeviceCountPoint* cheapest = cheapest_kept(points);
  ASSERT_NE(cheapest, nullptr);
  EXPECT_EQ(cheapest->devices, 5u);
}

TEST(Counts, CarryConstraintsOverToCopies) {
  const Scene scene =
      parse(circle({10, 35, 80}, false) +
            "constraints:\n  - {name: apart, spacing: 0.3, devices: \"d*\"}\n"
            "  - {name: cable, sum: {devices.d0.coordinates.0: 2}, at_most: 5}\n");
  const auto points = search_counts(scene, plugins(), 2, 5, {}, quick());
  ASSERT_EQ(points.size(), 4u);
  for (const DeviceCountPoint& p : points) {
    EXPECT_TRUE(p.kept);
    const auto& names = p.scene.devices;
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (std::size_t j = i + 1; j < names.size(); ++j) {
        if (names[i].name == "above" || names[j].name == "above") continue;
        EXPECT_GE((device_pose(p.scene, names[i]).p - device_pose(p.scene, names[j]).p)
                      .norm(),
                  0.3 - 1e-9);
      }
    }
  }
}

TEST(Counts, RefuseDevicesThatMoveTogetherAndKitsThatAreTooSmall) {
  const auto refusal = [](const Scene& scene, std::size_t from, std::size_t to) {
    try {
      (void)search_counts(scene, plugins(), from, to, {}, quick());
    } catch (const std::invalid_argument& refused) {
      return std::string(refused.what());
    }
    return std::string();
  };
  const Scene mirrored = load("10-better-speakers");
  EXPECT_NE(refusal(mirrored, 4, 5).find("move together"), std::string::npos);
  const Scene scene = parse(circle({0, 60}, true));
  EXPECT_NE(refusal(scene, 1, 3).find("no more than this many can be left out"),
            std::string::npos);
}

TEST(Counts, AreTheSameForAnyNumberOfThreads) {
  const Scene scene = parse(circle({10, 35}, false));
  OptimizeOptions one = quick(), two = quick();
  one.threads = 1;
  const auto a = search_counts(scene, plugins(), 3, 4, {}, one),
             b = search_counts(scene, plugins(), 3, 4, {}, two);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].objective, b[k].objective);
    EXPECT_EQ(a[k].scene, b[k].scene);
  }
}

}  // namespace
}  // namespace delos::test
