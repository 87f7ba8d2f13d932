// What a design depends on: ranges against the objective itself, slopes against
// differences, failures against scenes without the device.
#include "delos/optimize/answers.h"

#include "optimizers/scenes.h"

namespace delos::test {
namespace {

TEST(Answers, RangesEndWhereTheLossIsReached) {
  const Scene scene = load("10-better-speakers");
  Problem problem(scene, plugins(), {200, 1});
  const std::vector<double> x = {0.2, 0.2, 0.1, 0.8, 0.2, 0.1};
  const double here = problem.score(x).objective;
  const Answers all = answers(problem, x, 0.05);
  ASSERT_EQ(all.variables.size(), 6u);
  int inner = 0;
  for (std::size_t v = 0; v < 6; ++v) {
    const VariableEntry& variable = scene.variables[v];
    const double unit = variable.upper - variable.lower;
    for (const double way : {-1.0, 1.0}) {
      const bool bound =
          way < 0 ? all.variables[v].down_is_bound : all.variables[v].up_is_bound;
      const double range = way < 0 ? all.variables[v].down : all.variables[v].up;
      EXPECT_GE(range, 0);
      if (bound) continue;
      ++inner;
      std::vector<double> y = x;
      y[v] = x[v] + way * range / unit;
      EXPECT_LE(problem.score(y).objective, 1.05 * here * (1 + 1e-12));
      y[v] += way * 2e-3;
      const Score beyond = problem.score(y);
      EXPECT_TRUE(beyond.objective > 1.05 * here || !beyond.feasible()) << v;
    }
  }
  EXPECT_GT(inner, 3);
}

TEST(Answers, SlopesAreThoseOfTheObjective) {
  const Scene scene = load("10-better-speakers",
                           {{"objective", "{minimize: mean, of: sigma_position}"}});
  Problem problem(scene, plugins(), {200, 1});
  const std::vector<double> x = {0.2, 0.2, 0.1, 0.8, 0.2, 0.1};
  const Answers all = answers(problem, x, 0.05);
  for (std::size_t v = 0; v < 6; ++v) {
    std::vector<double> up = x, down = x;
    up[v] += 1e-4;
    down[v] -= 1e-4;
    const double step = 2e-4 * (scene.variables[v].upper - scene.variables[v].lower);
    const double difference =
        (problem.score(up).objective - problem.score(down).objective) / step;
    EXPECT_NEAR(all.variables[v].slope, difference, 1e-6 + 1e-4 * std::abs(difference));
  }
}

TEST(Answers, ADeviceThatFailsIsAsIfItWereNotThere) {
  const Scene scene = load("10-better-speakers", {{"constraints", "[]"}});
  Problem problem(scene, plugins(), {200, 1});
  const Answers all = answers(problem, problem.design().start(), 0.05);
  ASSERT_EQ(all.devices.size(), 4u);
  const double whole = problem.score(problem.design().start()).objective;
  for (const DeviceAnswer& device : all.devices) {
    Scene rest = scene;
    rest.objective.guess = problem.guess();
    std::erase_if(rest.devices,
                  [&](const DeviceEntry& d) { return d.name == device.name; });
    // Any variable will do: only the scene as it stands is scored.
    rest.variables = {{"devices." + rest.devices[0].name + ".at.z",
                       0.9,
                       1.2,
                       ParamScale::linear,
                       {}}};
    Problem without(rest, plugins(), {200, 1});
    EXPECT_NEAR(device.without,
                without.score(without.design().start()).objective / whole - 1, 1e-9);
  }
  EXPECT_GE(all.devices.front().without, all.devices.back().without);
}

}  // namespace
}  // namespace delos::test
