// Linear systems: what filters reach on simulated readings is P∞, to within the scatter
// of the runs, which theory gives. P∞ comes from the Riccati solvers, which know no
// run, no reading and no filter.
#include <algorithm>

#include "simulation/simulated.h"

namespace delos::test {
namespace {

const LinearCase& case_named(const std::string& name) {
  static const std::vector<LinearCase> all = linear_cases();
  return *std::find_if(all.begin(), all.end(),
                       [&](const LinearCase& c) { return c.name == name; });
}

Simulation simulated(const LinearCase& of, int runs) {
  return simulate(of.system, kOrigin, {.runs = runs, .seed = 7, .seconds = of.seconds});
}

class Linear : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const LinearCase& c : linear_cases()) all.push_back(c.name);
  return all;
}

/// `bench_linear_runs` does the same with 10⁵ runs; its table is in docs/simulation.md.
TEST_P(Linear, CovariancesAreReachedWithinTheScatterOfTheRuns) {
  const LinearCase& of = case_named(GetParam());
  const Simulation s = simulated(of, of.runs);
  EXPECT_EQ(s.lost, 0u);
  expect_predicted(s);
  expect_settled(s, of.limit ? 0.01 : 1e-3);
  for (const SimulatedCovariance& c : s.covariances) {
    if (c.name == "average" || GetParam() == "sequential")
      continue;  // of many instants
    const CovarianceFit fit = covariance_fit(c, s.runs);
    EXPECT_LT(fit.chi_squared, fit.degrees + 4.5 * std::sqrt(2 * fit.degrees))
        << c.name;
    EXPECT_GT(fit.chi_squared, fit.degrees - 4.5 * std::sqrt(2 * fit.degrees))
        << c.name;
  }
  // Two-sided 95 % bands, which one of twenty leaves: all are within twice as much.
  for (const Consistency& of_last : {s.instants.back().nees, s.instants.back().nis}) {
    const double half = (of_last.upper - of_last.lower) / 2;
    EXPECT_NEAR(of_last.mean, of_last.expected, 2 * half);
  }
}

INSTANTIATE_TEST_SUITE_P(Systems, Linear, ::testing::ValuesIn(names()),
                         [](const auto& of) { return of.param; });

/// What covariances there are, of which one is worse than another.
TEST(Linear, SaysWhichCovariances) {
  const auto names_of = [](const char* name) {
    std::vector<std::string> all;
    for (const SimulatedCovariance& c : simulated(case_named(name), 2).covariances)
      all.push_back(c.name);
    return all;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of("stacked_PP"), (Names{"prior", "posterior"}));
  EXPECT_EQ(names_of("periodic"), (Names{"average", "worst prior", "best posterior"}));
  EXPECT_EQ(names_of("sequential"),
            (Names{"prior", "posterior", "worst prior", "best posterior"}));
  EXPECT_EQ(names_of("continuous"),
            (Names{"average", "worst prior", "best posterior"}));
  const Simulation s = simulated(case_named("periodic"), 1500);
  EXPECT_LT(s.covariances[2].measured(0, 0), s.covariances[0].measured(0, 0));
  EXPECT_LT(s.covariances[0].measured(0, 0), s.covariances[1].measured(0, 0));
  EXPECT_EQ(simulated(case_named("biases"), 2).covariances[0].predicted.rows(), 12);
}

TEST(Linear, ErrorsSettleAsTheTimeConstantSays) {
  const Simulation s = simulated(case_named("stacked_PP"), 2000);
  EXPECT_EQ(s.instants.back().nees.expected, 6);
  EXPECT_EQ(s.instants.back().nis.expected, 4);
  // 95 % of instants in a two-sided 95 % band; they are correlated, hence no count.
  EXPECT_GT(s.nees_inside, 0.7);
  // It begins with twice the deviations, and forgets them by its time constant: the
  // variance's excess, 3 e^(−2t/T), is below 10 % after 1.7 T; runs scatter.
  ASSERT_TRUE(s.settled_after);
  EXPECT_GT(*s.settled_after, 0.5 * s.time_constant);
  EXPECT_LT(*s.settled_after, 3 * s.time_constant);
}

TEST(Linear, ErrorsHaveTheStandardErrorOfNormalOnes) {
  const Simulation s = simulated(case_named("stacked_P"), 2000);
  const SimulatedCovariance& c = s.covariances[0];
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(c.error(i, i), c.predicted(i, i) * std::sqrt(2.0 / 2000),
                0.12 * c.error(i, i));
}

TEST(Linear, ThreadsGiveTheSameBytes) {
  const System system = acoustic_system();
  const TargetPose pose{Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.4}};
  const auto run = [&](int threads) {
    return simulate(system, pose,
                    {.runs = 70, .seed = 3, .seconds = 0.2, .threads = threads});
  };
  const Simulation one = run(1), three = run(3);
  EXPECT_EQ(one.covariances[0].measured, three.covariances[0].measured);
  EXPECT_EQ(one.covariances[0].bound, three.covariances[0].bound);
  EXPECT_EQ(one.instants.back().nis.mean, three.instants.back().nis.mean);
  const Simulation other =
      simulate(system, pose, {.runs = 70, .seed = 4, .seconds = 0.2});
  EXPECT_NE(one.covariances[0].measured, other.covariances[0].measured);
}

}  // namespace
}  // namespace delos::test
