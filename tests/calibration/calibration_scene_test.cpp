// `calibration` and `error` in scenes: what is read, written, refused and answered.
#include <gtest/gtest.h>

#include <cmath>

#include "delos/field/evaluate.h"
#include "delos/field/point.h"
#include "delos/scene/definition.h"
#include "delos/steady/metric_slopes.h"
#include "scenes.h"
#include "support/heap_count.h"

namespace delos {
namespace {

using test::findings_of;
using test::scene_of;
using test::system_of;
using test::three_ranges;
using test::two_cameras;

const std::string kAll =
    "calibration: {place: [1 mm, 2 mm, 3 mm], orientation: 0.1 deg, offset: 0.5 px, "
    "params: {field_of_view: 0.2 deg}}";

TEST(CalibrationKeys, AreReadAndWritten) {
  const Scene scene = scene_of(two_cameras(kAll, "error: bias\n"));
  EXPECT_EQ(scene.error, ErrorPart::bias);
  const Calibration& known = scene.devices[0].calibration;
  EXPECT_EQ(known.place, Eigen::Vector3d(0.001, 0.002, 0.003));
  EXPECT_NEAR(known.orientation.z(), 0.1 * std::acos(-1) / 180, 1e-15);
  EXPECT_EQ(known.offset, 0.5);
  ASSERT_EQ(known.params.size(), 1u);
  EXPECT_NEAR(known.params[0].second, 0.2 * std::acos(-1) / 180, 1e-15);
  EXPECT_EQ(scene_of(write_scene(scene)), scene);
  EXPECT_TRUE(scene_of(three_ranges("")).devices[0].calibration.exact());
}

TEST(CalibrationKeys, RefuseWhatHasNoMeaning) {
  EXPECT_EQ(findings_of(three_ranges("calibration: {place: -1 mm}")).front(),
            "s.yaml:5:101: error: devices.r1.calibration.place: is a standard "
            "deviation, which must not be below 0");
  const auto has = [](const std::string& text, const std::string& part) {
    for (const std::string& finding : findings_of(text))
      if (finding.find(part) != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(has(three_ranges("calibration: {offset: 3 kg}"), "calibration.offset: "));
  EXPECT_TRUE(has(three_ranges("calibration: {params: {sigmas: 1}}"),
                  "is no parameter of it; did you mean 'sigma'?"));
  EXPECT_TRUE(has(three_ranges("calibration: {params: {noise: 1}}"),
                  "isn't a number, whose deviation could be told"));
  for (const char* fusion : {"periodic", "sequential", "artemis"}) {
    const std::string line = "fusion: " + std::string(fusion) + "\n";
    EXPECT_TRUE(has(three_ranges("calibration: {offset: 1 cm}", line),
                    "use fusion: stacked or continuous, or error: scatter"))
        << fusion;
    EXPECT_EQ(findings_of(three_ranges("calibration: {offset: 1 cm}",
                                       line + "error: scatter\n")),
              std::vector<std::string>{});
  }
  const std::string carried =
      "delos: 1\nmotion: {type: position_velocity, q: [1, 1, 1]}\n"
      "sample: {points: [[3, 4, 1.9]]}\n"
      "beacons: {ceiling: {grid: {min: [0, 0, 2.8], max: [6, 9, 2.8], step: 0.1}}}\n"
      "devices:\n  - {name: h, type: hiball, rate: 1 kHz, mount: target, select: mean, "
      "params: {layout: six, r: 2e-5}, calibration: {";
  EXPECT_TRUE(has(carried + "orientation: 1 deg}}\n",
                  "of a carried device needs a motion whose state has the whole "
                  "orientation"));
  EXPECT_TRUE(has(carried + "offset: 0.1}}\n", "give its place and orientation"));
  EXPECT_EQ(findings_of(carried + "place: 1 mm}}\n"), std::vector<std::string>{});
}

Field field_of(const std::string& text, const std::string& metric) {
  const Scene scene = scene_of(text);
  const System system = build_system(scene, test::plugins());
  return evaluate_field(system, make_samples(scene.samples), scene.orientations,
                        std::get<Metric>(parse_metric(metric, known_metrics(scene))));
}

// The trace is a sum of variances, and so is the total of both parts.
TEST(ErrorParts, AddUpToTheTotal) {
  const auto trace = [](const std::string& part) {
    return field_of(two_cameras(kAll, "error: " + part + "\n"), "trace").value[0];
  };
  EXPECT_GT(trace("bias"), trace("scatter")) << "0.1 deg at 3 m are 5 mm";
  EXPECT_NEAR(trace("total"), trace("scatter") + trace("bias"), 1e-12 * trace("total"));
  EXPECT_EQ(trace("scatter"), field_of(two_cameras("phase: 0"), "trace").value[0]);
  EXPECT_EQ(field_of(two_cameras(kAll), "trace").value[0], trace("total"))
      << "whoever says how well a device is known is told the total";
}

TEST(ErrorParts, AreNamedWithTheNumbers) {
  const auto of = [](const std::string& text) { return definition_of(scene_of(text)); };
  EXPECT_EQ(to_string(of(two_cameras(kAll))),
            "a-priori covariance, stacked fusion, scatter and calibration");
  EXPECT_EQ(to_string(of(two_cameras("phase: 0"))),
            "a-priori covariance, stacked fusion");
  EXPECT_TRUE(alike(of(two_cameras(kAll)), of(two_cameras("phase: 0"))));
  EXPECT_FALSE(alike(of(two_cameras(kAll)), of(two_cameras(kAll, "error: scatter\n"))));
  EXPECT_FALSE(
      alike(of(two_cameras("phase: 0")), of(two_cameras(kAll, "error: bias\n"))));
}

TEST(ErrorParts, OfAPointAreItsFields) {
  const Scene scene = scene_of(two_cameras(kAll));
  const System system = build_system(scene, test::plugins());
  const Metric metric =
      std::get<Metric>(parse_metric("sigma_position", known_metrics(scene)));
  const PointReport report =
      evaluate_point(system, {Eigen::Matrix3d::Identity(), {0, 0, 0}}, metric);
  ASSERT_TRUE(report.budget);
  for (std::size_t m = 0; m < report.metrics.size(); ++m) {
    const std::string& name = report.metrics[m].metric.name;
    if (!std::isfinite(report.metrics[m].value)) continue;
    EXPECT_EQ(report.metrics[m].value, report.budget->total[m]) << name;
    EXPECT_NEAR(report.metrics[m].value, field_of(two_cameras(kAll), name).value[0],
                1e-9 * report.metrics[m].value)
        << name;
    const double bias = field_of(two_cameras(kAll, "error: bias\n"), name).value[0];
    if (std::isfinite(bias))  // of no volume, mle isn't
      EXPECT_NEAR(report.budget->bias[m], bias, 1e-9 * report.metrics[m].value) << name;
  }
}

// Known exactly, one of two orthogonal ranges takes its part of the bias with it:
// 1 − √((3 s² + 2 b²)/(3 s² + 3 b²)), s² scatter and b² bias of an axis.
TEST(ErrorParts, SayWhoseCalibrationIsWorthMost) {
  const System system = system_of(three_ranges("calibration: {offset: 5 cm}"));
  const Metric metric =
      std::get<Metric>(parse_metric("sigma_position", system.motion.layout));
  const PointReport report =
      evaluate_point(system, {Eigen::Matrix3d::Identity(), {0, 0, 0}}, metric);
  System exact = system;
  exact.error = ErrorPart::scatter;
  const double s2 =
      std::pow(evaluate_point(exact, report.pose, metric).metrics[0].value, 2);
  const double part = 1 - std::sqrt((3 * s2 + 2 * 25e-4) / (3 * s2 + 3 * 25e-4));
  for (const DeviceShare& device : report.devices)
    EXPECT_NEAR(device.calibration, part, 1e-9) << device.name;
}

// Of equal readings all alike, plain least squares is the best: S⁻¹ = σ² I of three
// orthogonal ranges. Of one that is ten times worse it isn't.
TEST(ErrorParts, StandBesidePlainLeastSquares) {
  const Metric metric =
      std::get<Metric>(parse_metric("trace", StateLayout{PoseState::position, 2, {}}));
  const auto plain = [&](const std::string& text) {
    const System system = system_of(text);
    return *evaluate_point(system, {Eigen::Matrix3d::Identity(), {0, 0, 0}}, metric)
                .budget->plain;
  };
  const std::string text = three_ranges("calibration: {offset: 5 cm}");
  EXPECT_NEAR(plain(text).scatter, 3 * 9e-4, 1e-15);
  EXPECT_NEAR(plain(text).bias, 3 * 25e-4, 1e-15);
  EXPECT_NEAR(plain(text).total, 3 * 34e-4, 1e-15);
  // A second one on the first axis: x̂ is the mean of both.
  const std::string more = text +
                           "  - {name: rough, type: range, rate: 20 Hz, params: "
                           "{sigma: 30 cm}, at: [5, 0, 0], "
                           "calibration: {offset: 1 m}}\n";
  EXPECT_NEAR(plain(more).scatter, 2 * 9e-4 + (9e-4 + 900e-4) / 4, 1e-14);
  EXPECT_NEAR(plain(more).bias, 2 * 25e-4 + (25e-4 + 1) / 4, 1e-14);
}

// Ten times the rate leaves the bias as it is. Ranges of one noise and one offset:
// where the bias is of the offset and the place along the sight line alone, it is (5² +
// 3²) cm²/10² cm² of the covariance of a single reading.
TEST(ErrorParts, OfTheShippedAnchors) {
  const auto mean = [](const std::vector<Override>& changes) {
    Diagnostics diagnostics;
    const Scene scene =
        *load_scene(std::string(DELOS_SCENES) + "/24-surveyed-anchors.yaml", changes,
                    test::plugins(), diagnostics);
    const System system = build_system(scene, test::plugins());
    const Field field = evaluate_field(
        system, make_samples(scene.samples), scene.orientations,
        std::get<Metric>(parse_metric(scene.metric, known_metrics(scene))));
    double sum = 0;
    for (const double value : field.value) sum += value;
    return sum / static_cast<double>(field.value.size());
  };
  EXPECT_NEAR(mean({}), 0.1280, 1e-4);
  EXPECT_NEAR(mean({{"error", "scatter"}}), 0.0917, 1e-4);
  const double bias = mean({{"error", "bias"}});
  EXPECT_NEAR(bias, 0.0892, 1e-4);
  EXPECT_NEAR(bias,
              std::sqrt(0.34) * mean({{"covariance", "single"}, {"error", "scatter"}}),
              1e-9);
  EXPECT_NEAR(mean({{"devices.*.rate", "200 Hz"}}), 0.0962, 1e-4);
  EXPECT_NEAR(mean({{"devices.*.rate", "200 Hz"}, {"error", "bias"}}), bias, 1e-9);
}

// Ten times the samples take nothing more from the heap but room for themselves.
TEST(ErrorParts, TakeNothingFromTheHeapInTheirLoop) {
  const Scene scene = scene_of(two_cameras(kAll));
  const System system = build_system(scene, test::plugins());
  const Metric metric = std::get<Metric>(parse_metric("trace", system.motion.layout));
  const auto taken = [&](int count) {
    const Samples samples = make_samples(
        {{"",
          PointSampling{"", std::vector<Eigen::Vector3d>(
                                static_cast<std::size_t>(count), {0.1, 0.2, 0.3})}}});
    return test::allocations([&] {
      (void)evaluate_field(system, samples, scene.orientations, metric, {.threads = 1});
    });
  };
  const std::size_t once = taken(256);
  EXPECT_GT(once, 0u);
  EXPECT_LE(taken(2560), once + 10);
}

TEST(ErrorParts, HaveNoSlopes) {
  const System system = system_of(two_cameras(kAll));
  const Metric metric = std::get<Metric>(parse_metric("trace", system.motion.layout));
  EXPECT_NE(slope_problem(system, metric).find("error: scatter"), std::string::npos);
  EXPECT_EQ(slope_problem(system_of(two_cameras(kAll, "error: scatter\n")), metric),
            "");
}

}  // namespace
}  // namespace delos
