// Searches over metrics by formulas: those over the metric that a formula names, to the
// last bit, and none that is lured to where nobody sees.
#include <cmath>

#include "delos/optimize/optimize.h"
#include "optimizers/scenes.h"

namespace delos::test {
namespace {

const std::string kRoom = R"(delos: 1
name: Two cameras
motion: {type: position_velocity, q: [0.4, 0.4, 0.1]}
metrics:
  same: {expression: eigmax}
  round: {expression: abs(log(sigma_z / sigma_x))}
sample: {volume: {min: [1, 1, 0.5], max: [3, 3, 1.5], step: 0.5}}
devices:
  - {name: a, type: pinhole_camera, rate: 100 Hz, at: [0, 0, 2.5], aim: [2, 2, 1], params: &c {focal: 8 mm, pitch: 5 um, resolution: [1280, 1024], sigma: 0.1}}
  - {name: b, type: pinhole_camera, rate: 100 Hz, at: [4, 0, 2.5], aim: [2, 2, 1], params: *c}
  - {name: c, type: pinhole_camera, rate: 100 Hz, at: [2, 5, 2], aim: [2, 2, 1], params: *c}
variables: [{path: devices.*.aim, lower: [-3, -3, 0], upper: [6, 6, 2]}]
)";

TEST(OwnMetric, IsSearchedAsTheMetricThatItNames) {
  const Scene built_in = parse(kRoom + "objective: {minimize: mean, of: eigmax}\n"),
              own = parse(kRoom + "objective: {minimize: mean, of: same}\n");
  Problem expected(built_in, plugins(), {0, 2}), found(own, plugins(), {0, 2});
  ASSERT_EQ(found.slope_problem(), "");
  const std::vector<double> x = expected.design().start();
  const std::size_t n = x.size();
  EXPECT_EQ(found.score(x).objective, expected.score(x).objective);
  for (const double width : {0.3, 0.02}) {
    std::vector<double> a(n), b(n), none;
    const Score of_built_in = expected.score_with_slopes(x, width, a.data(), nullptr),
                of_own = found.score_with_slopes(x, width, b.data(), nullptr);
    EXPECT_EQ(of_own.objective, of_built_in.objective);
    EXPECT_EQ(a, b);
  }
  OptimizeOptions options;
  options.evaluations = 120;
  const OptimizeResult one = search(built_in, options), other = search(own, options);
  EXPECT_EQ(one.best.objective, other.best.objective);
  for (std::size_t i = 0; i < one.scene.devices.size(); ++i)
    EXPECT_EQ(one.scene.devices[i].placement, other.scene.devices[i].placement);
}

// With a guess alone σ_z/σ_x is 1 and its logarithm 0: the best that there is.
TEST(OwnMetric, IsNeverGoodWhereNobodySees) {
  const Scene scene = parse(kRoom + "objective: {minimize: mean, of: round}\n");
  Problem problem(scene, plugins(), {0, 2});
  ASSERT_EQ(problem.slope_problem(), "");
  const std::vector<double> sees = problem.design().start();
  std::vector<double> away = sees;
  for (std::size_t v = 0; v < away.size(); ++v) away[v] = v % 3 == 2 ? 0.5 : 0.0;
  EXPECT_LT(problem.score(sees).objective, problem.score(away).objective);
  // Edges as wide as 0.3 rad still see a little there.
  for (const double width : {0.05, 0.01})
    EXPECT_LT(problem.soft_score(sees, width).objective,
              problem.soft_score(away, width).objective)
        << width;
  OptimizeOptions options;
  options.evaluations = 200;
  const OptimizeResult found = search(scene, options);
  EXPECT_LE(found.best.objective, found.initial.objective);
  const Field before = problem.field(sees);
  const auto observable = [](const Field& field) {
    return std::count(field.observable.begin(), field.observable.end(), 1);
  };
  Problem after(found.scene, plugins(), {0, 2});
  EXPECT_GE(observable(after.field(after.design().start())), observable(before));
}

}  // namespace
}  // namespace delos::test
