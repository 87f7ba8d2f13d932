// A scene's own metrics: where their names can stand, and what is said of wrong ones.
#include <gtest/gtest.h>

#include "delos/model/metric_expression.h"
#include "delos/scene/definition.h"
#include "scene/load.h"

namespace delos::test {
namespace {

std::string with_metrics(const std::string& metrics) {
  return good_with("groups:", metrics + "\ngroups:");
}

const std::string kOwn = R"(metrics:
  flatness: {expression: "sigma_z / sigma_x"}
  reach: {expression: 1/(flatness*eigmax), better: more}
  mixed: {expression: sigma_x + 0.1 * sigma_vx, unit: m}
metric: flatness)";

TEST(OwnMetrics, AreMetrics) {
  const Scene scene = load(with_metrics(kOwn)).scene.value();
  const KnownMetrics known = known_metrics(scene);
  ASSERT_EQ(known.own.size(), 3u);
  EXPECT_EQ(known.own[0].name, "flatness");
  EXPECT_EQ(known.own[0].unit, "1");
  EXPECT_FALSE(known.own[0].larger_is_better);
  EXPECT_EQ(known.own[1].unit, "m^-1");
  EXPECT_TRUE(known.own[1].larger_is_better);
  EXPECT_EQ(known.own[2].unit, "m");
  EXPECT_EQ(std::get<Metric>(parse_metric(scene.metric, known)).kind,
            MetricKind::expression);
  EXPECT_EQ(build_system(scene, plugins()).own_metrics.size(), 3u);
}

TEST(OwnMetrics, StandWhereMetricsDo) {
  const std::string search = R"(
variables: [{path: devices.s1.at.z, lower: 0.5, upper: 2}]
objective: {terms: [{minimize: mean, of: flatness}, {maximize: mean, of: reach}]}
constraints: [{metric: mixed, below: 3 cm}, {metric: reach, above: 0.1}]
groups:)";
  const Loaded loaded = load(good_with("groups:", kOwn + search));
  ASSERT_TRUE(loaded.scene);
  const Scene& scene = *loaded.scene;
  EXPECT_EQ(scene.objective.terms[0].metric, "flatness");
  EXPECT_EQ(std::get<KeepMetric>(scene.constraints[0].what).limit, 0.03);
  const std::string text = write_scene(scene);
  EXPECT_EQ(load(text).scene.value(), scene) << text;
}

TEST(OwnMetrics, OfASingleReadingReadThePose) {
  EXPECT_TRUE(
      load(with_metrics("covariance: single\n" + kOwn.substr(0, kOwn.find("  mixed"))))
          .scene);
  const Loaded loaded = load(with_metrics("covariance: single\n" + kOwn));
  ASSERT_EQ(loaded.findings.size(), 1u);
  EXPECT_EQ(
      loaded.findings[0].rfind("scene.yaml:13:39: error: metrics.mixed.expression: "
                               "'sigma_vx' isn't known here",
                               0),
      0u)
      << loaded.findings[0];
}

struct WrongMetric {
  std::string metrics;
  std::vector<std::string> begin;  // of the findings
};

TEST(OwnMetrics, AreRefusedAtTheColumnThatIsWrong) {
  const std::string at = "scene.yaml:";
  for (const WrongMetric& wrong : std::vector<WrongMetric>{
           {"metrics: [a]", {at + "9:10: error: metrics: expected a mapping of names"}},
           {"metrics:\n  a: {expression: sigma_x / sgma_z}",
            {at + "10:29: error: metrics.a.expression: 'sgma_z' isn't known here; did "
                  "you mean 'sigma_z'?; there are sigma_x, sigma_y"}},
           // The quote is a column of its own.
           {"metrics:\n  a: {expression: \"sigma_x / sgma_z\"}",
            {at + "10:30: error: metrics.a.expression: 'sgma_z' isn't known here"}},
           {"metrics:\n  a: {expression: 'P[x, q]'}",
            {at +
             "10:25: error: metrics.a.expression: 'q' is no state; there are x, y, "
             "z, vx, vy, vz"}},
           {"metrics:\n  a: {expression: sigma_x + sigma_vx}",
            {at + "10:19: error: metrics.a.expression: has no unit by itself"}},
           {"metrics:\n  a: {expression: sigma_x, unit: rad}",
            {at + "10:19: error: metrics.a.expression: is in m, not in rad"}},
           {"metrics:\n  a: {better: more}",
            {at + "10:6: error: metrics.a.expression: missing: a formula"}},
           {"metrics:\n  a: {expression: sigma_x, better: smaller}",
            {at + "10:36: error: metrics.a.better: 'smaller' is none of less, more"}},
           {"metrics:\n  eigmax: {expression: sigma_x}",
            {at + "10:3: error: metrics.eigmax: has a meaning already; take another"}},
           {"metrics:\n  x: {expression: sigma_x}",
            {at + "10:3: error: metrics.x: has a meaning already; take another name"}},
           {"metrics:\n  my-own: {expression: sigma_x}",
            {at +
             "10:3: error: metrics.my-own: isn't a name: letters, digits and '_'"}},
           // Later ones may read what is wrong: one mistake, one finding.
           {"metrics:\n  a: {expression: sigma_x +}\n  b: {expression: a/2}\nmetric: b",
            {at + "10:28: error: metrics.a.expression: expected a number, a name or "
                  "'(', found the end"}},
           // A metric may read those before it, not itself or those behind.
           {"metrics:\n  a: {expression: b}\n  b: {expression: sigma_x}",
            {at + "10:19: error: metrics.a.expression: 'b' isn't known here"}},
       }) {
    const Loaded loaded = load(with_metrics(wrong.metrics));
    EXPECT_FALSE(loaded.scene) << wrong.metrics;
    ASSERT_EQ(loaded.findings.size(), wrong.begin.size()) << wrong.metrics;
    for (std::size_t i = 0; i < wrong.begin.size(); ++i)
      EXPECT_EQ(loaded.findings[i].substr(0, wrong.begin[i].size()), wrong.begin[i])
          << loaded.findings[i];
  }
}

}  // namespace
}  // namespace delos::test
