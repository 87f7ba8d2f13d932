// Objectives that ask which part of the samples keeps a limit, and those of which more
// is better.
#include <numeric>

#include "optimizers/scenes.h"

namespace delos::test {
namespace {

/// Four cameras in the corners of a room, whose lenses may change.
std::string lenses(const std::string& objective) {
  return R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
metric: coverage
sample: {volume: {min: [1, 1, 0.5], max: [4, 4, 1.5], step: 0.5}}
devices:
  - {name: a, type: pinhole_camera, rate: 100 Hz, at: [0, 0, 2.5], aim: [2.5, 2.5, 1], params: &c {focal: 10 mm, pitch: 5 um, resolution: [1280, 1024]}}
  - {name: b, type: pinhole_camera, rate: 100 Hz, at: [5, 0, 2.5], aim: [2.5, 2.5, 1], params: *c}
  - {name: c, type: pinhole_camera, rate: 100 Hz, at: [5, 5, 2.5], aim: [2.5, 2.5, 1], params: *c}
  - {name: d, type: pinhole_camera, rate: 100 Hz, at: [0, 5, 2.5], aim: [2.5, 2.5, 1], params: *c}
variables: [{path: "devices.*.params.focal", lower: 4 mm, upper: 12 mm}]
objective: )" +
         objective + "\n";
}

/// Two cameras with narrow views of a room.
std::string narrow(const std::string& limit) {
  return R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {volume: {min: [-2, -2, 0], max: [2, 2, 2], step: 0.5}}
devices:
  - {name: a, type: pinhole_camera, rate: 100 Hz, at: [4, 0, 1], aim: [0, 0, 1], params: &c {focal: 12 mm, pitch: 5 um, resolution: [1280, 1024], sigma: 0.1}}
  - {name: b, type: pinhole_camera, rate: 100 Hz, at: [0, 4, 1], aim: [0, 0, 1], params: *c}
variables: [{path: "devices.*.aim", lower: [-1, -1, 0], upper: [1, 1, 2]}]
objective: {minimize: fraction, of: eigmax, limit: )" +
         limit + "}\n";
}

double score_at(Problem& problem, double x) {
  return problem.score(std::vector<double>(problem.design().size(), x)).objective;
}

double score_as_given(const std::string& text) {
  Problem problem(parse(text), plugins(), {0, 2});
  return problem.score(problem.design().start()).objective;
}

/// Counted in the CSV of the coverage field: fewer than three cameras see 0.517 of the
/// samples with 10 mm lenses and 0.707 with 12 mm; with 4 mm all four see everything.
TEST(Fraction, OfCoverageCountsTooFew) {
  Problem problem(parse(lenses("{minimize: fraction, of: coverage, limit: 3}")),
                  plugins(), {0, 2});
  EXPECT_NEAR(problem.score(problem.design().start()).objective, 0.517, 5e-4);
  EXPECT_NEAR(score_at(problem, 1), 104.0 / 147, 1e-12);
  EXPECT_EQ(score_at(problem, 0), 0);
}

/// What is as good as the limit keeps it: with 4 mm lenses coverage is 4 everywhere.
TEST(Fraction, MeetsTheLimitItself) {
  const auto missed = [](const std::string& limit) {
    Problem problem(
        parse(lenses("{minimize: fraction, of: coverage, limit: " + limit + "}")),
        plugins(), {0, 2});
    return score_at(problem, 0);
  };
  EXPECT_EQ(missed("4"), 0);
  EXPECT_NEAR(missed("4.5"), 1, 1e-12);
  EXPECT_NEAR(missed("5"), 1, 1e-12);
}

TEST(Fraction, OfCoverageIsSearchedFor) {
  const OptimizeResult found =
      search(parse(lenses("{minimize: fraction, of: coverage, limit: 3}")));
  EXPECT_EQ(found.best.objective, 0);
  EXPECT_LT(found.initial.objective, 0.52);
  EXPECT_GT(found.initial.objective, 0.51);
}

/// 4 mm lenses reach four cameras in every sample.
TEST(Coverage, IsClimbedPlateauByPlateau) {
  for (const char* objective :
       {"{maximize: percentile, of: coverage, level: 0.95}",
        "{maximize: mean, of: coverage}", "{maximize: maximum, of: coverage}"}) {
    const OptimizeResult found = search(parse(lenses(objective)));
    EXPECT_NEAR(found.best.objective, -4, 1e-12) << objective;
    EXPECT_EQ(found.algorithm, "slsqp");
  }
}

TEST(Coverage, IsALimitThatSearchesReach) {
  const OptimizeResult found =
      search(parse(lenses("{minimize: mean, of: eigmax}") +
                   "constraints: [{name: seen, metric: coverage, above: 4}]\n"));
  EXPECT_TRUE(found.constraints.at(0).satisfied);
  EXPECT_EQ(found.constraints.at(0).slack, 0);
}

/// The cameras' common view has 56 of 405 samples, all of them below 10 mm: the rest is
/// blind and misses any limit, however small the guess of what isn't seen.
TEST(Fraction, CountsBlindSamplesAsMissed) {
  for (const char* limit : {"10 mm", "10 cm", "10 m"})
    EXPECT_NEAR(score_as_given(narrow(limit)), 349.0 / 405, 1e-12) << limit;
  std::string bold = narrow("10 cm");
  bold.insert(bold.rfind('}'), ", guess: 1 mm");
  EXPECT_NEAR(score_as_given(bold), 349.0 / 405, 1e-12);
}

/// Where a search starts it sees what it is judged by: 0.86 is missed, not 0.
TEST(Fraction, IsSearchedForWhereTheLimitIsWide) {
  const Scene scene = parse(narrow("10 cm"));
  Problem problem(scene, plugins(), {0, 2});
  EXPECT_GT(problem.soft_score(problem.design().start(), 1e-3).objective, 0.8);
  const OptimizeResult found = search(scene);
  EXPECT_NEAR(found.initial.objective, 349.0 / 405, 1e-12);
  EXPECT_LT(found.best.objective, found.initial.objective);
  // The best field says the same.
  std::size_t met = 0;
  for (const double value : found.best_field.value) met += value <= 0.1;
  EXPECT_NEAR(found.best.objective, 1 - static_cast<double>(met) / 405, 1e-12);
}

/// A blind sample has no density, and misses what is asked of it.
TEST(Fraction, OfADensityIsOfWhatIsTooLow) {
  std::string text = narrow("1e-300");
  text.replace(text.find("of: eigmax"), 10, "of: mle");
  EXPECT_NEAR(score_as_given(text), 349.0 / 405, 1e-12);
  text.replace(text.find("1e-300"), 6, "1e300");
  EXPECT_NEAR(score_as_given(text), 1, 1e-12);
}

}  // namespace
}  // namespace delos::test
