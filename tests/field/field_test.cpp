// Whole fields: the published table, determinism, agreement with single points.
#include "delos/field/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "delos/field/point.h"
#include "support/rigs.h"

namespace delos {
namespace {

using testing::acoustic_system;
using testing::metric_of;

Field field_of(const System& system, const Samples& samples, const std::string& metric,
               FieldOptions options = {}, const Orientations& orientations = {}) {
  return evaluate_field(system, samples, orientations, metric_of(system, metric),
                        options);
}

struct PublishedRate {
  double rate, least, greatest;  // Hz, m, m
  double least_off;              // m
};

// Allen (2007), dissertation, Table 6.2. The geometry is inferred (docs/theory.md): the
// maxima agree within one unit of the printed last digit, the minima within two; at
// 12.5 Hz within 5 %.
class Table62 : public ::testing::TestWithParam<PublishedRate> {};

TEST_P(Table62, EigMaxOfTheAcousticTracker) {
  System system = acoustic_system(GetParam().rate);
  for (PlacedDevice& d : system.devices) {
    for (int i = 0; i < 2; ++i) d.X_WS().p[i] = d.X_WS().p[i] > 0.2 ? 0.47 : -0.07;
    d.X_WS().p.z() = 1.2141;
  }
  const Field field =
      field_of(system, testing::volume({0, 0, 0}, {0.4, 0.4, 1.14}, 0.02), "eigmax");
  const FieldStatistics s = summarize(field);
  EXPECT_EQ(s.samples, 21u * 21u * 58u);
  EXPECT_EQ(s.observable, s.samples);
  EXPECT_NEAR(s.max.value, GetParam().greatest, 1e-4);
  EXPECT_EQ(s.max.at.z(), 0) << "at the floor's corners";
  EXPECT_NEAR(s.min.value, GetParam().least, GetParam().least_off);
}

INSTANTIATE_TEST_SUITE_P(Rates, Table62,
                         ::testing::Values(PublishedRate{6, 0.0546, 0.2063, 2.5e-4},
                                           PublishedRate{12.5, 0.0323, 0.1460, 0.0016},
                                           PublishedRate{25, 0.0231, 0.1084, 2.5e-4},
                                           PublishedRate{50, 0.0170, 0.0817, 1e-4},
                                           PublishedRate{100, 0.0126, 0.0622, 1e-4},
                                           PublishedRate{200, 0.0095, 0.0476, 1e-4}));

TEST(Field, EqualsThePoint) {
  const System system = acoustic_system();
  const Samples samples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.2);
  for (const std::string& name : metric_names(system.motion.layout)) {
    const Field field = field_of(system, samples, name);
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      const PointReport point =
          evaluate_point(system, {Eigen::Matrix3d::Identity(), samples.points[i]},
                         metric_of(system, name));
      for (const MetricValue& m : point.metrics) {
        if (m.metric.name != name) continue;
        if (std::isinf(m.value))  // no device has pixels
          EXPECT_EQ(field.value[i], m.value) << name;
        else
          EXPECT_NEAR(field.value[i], m.value, 1e-10 * std::abs(m.value)) << name;
      }
    }
  }
}

TEST(Field, HasTheSameBytesForAnyNumberOfThreads) {
  const System system = acoustic_system();
  const Samples samples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.02);
  for (const char* metric : {"eigmax", "mle", "latency", "sigma_vz"}) {
    const Field one = field_of(system, samples, metric, {.threads = 1});
    const Field eight = field_of(system, samples, metric, {.threads = 8});
    ASSERT_EQ(one.value.size(), eight.value.size());
    EXPECT_EQ(std::memcmp(one.value.data(), eight.value.data(),
                          one.value.size() * sizeof(double)),
              0)
        << metric;
  }
}

TEST(Field, FromKeptLayersAfterAMoveIsTheFreshField) {
  System system = acoustic_system();
  const Samples samples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.05);
  InformationLayers layers(system, field_poses(samples, {}));
  system.devices[2].X_WS().p.z() += 0.1;
  layers.update(system);
  const Field updated =
      evaluate_field(layers, samples, {}, metric_of(system, "eigmax"));
  EXPECT_EQ(updated.value, field_of(system, samples, "eigmax").value);
}

TEST(Field, ForcedSolversAgree) {
  const System system = acoustic_system();
  const Samples samples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.2);
  const Field a = field_of(system, samples, "eigmax", {.solver = Solver::spectral});
  const Field b = field_of(system, samples, "eigmax", {.solver = Solver::doubling});
  const Field c = field_of(system, samples, "eigmax", {.solver = Solver::eigenvector});
  for (std::size_t i = 0; i < a.value.size(); ++i) {
    EXPECT_NEAR(a.value[i], b.value[i], 1e-11);
    EXPECT_NEAR(a.value[i], c.value[i], 1e-9);
  }
}

TEST(Field, BlindSamplesAreInfiniteAndCounted) {
  System system = acoustic_system();
  for (PlacedDevice& d : system.devices) {
    d.device = std::make_shared<testing::TestRange>(0.005, 0.8);
  }
  const Samples samples =
      testing::points({{0.2, 0.2, 0.6}, {0.2, 0.2, 0.0}, {0, 0, 0.3}});
  const Field field = field_of(system, samples, "eigmax");
  EXPECT_TRUE(std::isfinite(field.value[0]));
  EXPECT_TRUE(std::isinf(field.value[1])) << "none reaches 1.05 m";
  EXPECT_TRUE(std::isinf(field.value[2])) << "one reaches 0.75 m";
  const FieldStatistics s = summarize(field);
  EXPECT_EQ(s.observable, 1u);
  EXPECT_EQ(s.finite, 1u);
  EXPECT_EQ(field_of(system, samples, "coverage").value,
            (std::vector<double>{4, 0, 1}));
}

// One state may be known where another isn't: a single range above sees z alone.
TEST(Field, ASigmaIsFiniteWhereItsOwnStateIsObserved) {
  System system = acoustic_system();
  system.devices.resize(1);
  system.devices[0].X_WS().p = {0, 0, 1};
  const Samples below = testing::points({{0, 0, 0}});
  EXPECT_TRUE(std::isinf(field_of(system, below, "sigma_x").value[0]));
  EXPECT_TRUE(std::isfinite(field_of(system, below, "sigma_z").value[0]));
  EXPECT_TRUE(std::isfinite(field_of(system, below, "sigma_vz").value[0]));
  EXPECT_TRUE(std::isinf(field_of(system, below, "eigmax").value[0]));
  EXPECT_EQ(field_of(system, below, "sigma_z").observable[0], 0);
}

// A marker half a metre off the target's centre, turned towards and away from the
// speakers.
TEST(Field, OrientationsCombineByWorstOrMean) {
  System system = acoustic_system();
  system.markers = {{0, 0, 0.5}};
  const Samples samples = testing::points({{0.2, 0.2, 0.0}});
  Orientations both;
  both.rpy = {{0, 0, 0}, {3.14159265358979, 0, 0}};
  Orientations up, down;
  down.rpy = {both.rpy[1]};
  const double near = field_of(system, samples, "eigmax", {}, up).value[0];
  const double far = field_of(system, samples, "eigmax", {}, down).value[0];
  ASSERT_LT(near, far);
  EXPECT_EQ(field_of(system, samples, "eigmax", {}, both).value[0], far);
  EXPECT_EQ(field_of(system, samples, "eigmax", {}, both).evaluations, 2u);
  both.combine = OrientationRule::mean;
  EXPECT_DOUBLE_EQ(field_of(system, samples, "eigmax", {}, both).value[0],
                   (near + far) / 2);
}

TEST(Field, CancellingKeepsTheFront) {
  const System system = acoustic_system();
  const Samples samples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.01);
  std::atomic<bool> cancel = false;
  FieldOptions options;
  options.threads = 1;
  options.cancel = &cancel;
  options.progress = [&](std::size_t done, std::size_t) { cancel = done >= 640; };
  const Field part = field_of(system, samples, "eigmax", options);
  EXPECT_TRUE(part.cancelled);
  EXPECT_EQ(part.evaluated, 640u);
  const Field whole = field_of(system, samples, "eigmax");
  EXPECT_FALSE(whole.cancelled);
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    EXPECT_EQ(part.value[i], i < 640 ? whole.value[i] : INFINITY);
  }
}

TEST(Field, LatencyUnderArtemisFusionIsRefused) {
  System system = acoustic_system();
  system.fusion = Fusion::artemis;
  EXPECT_THROW((void)field_of(system, testing::points({{0, 0, 0}}), "latency"),
               std::invalid_argument);
}

// Differences by hand: 1 − 2, 3 − 3, blind in one or both.
TEST(Compare, CountsImprovementsAndDifferences) {
  Field a, b;
  a.samples = b.samples = testing::points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  a.value = {2, 3, INFINITY, INFINITY};
  b.value = {1, 3.5, 4, INFINITY};
  const Comparison c = compare_fields(a, b);
  EXPECT_EQ(c.common, 2u);
  EXPECT_DOUBLE_EQ(c.mean, -0.25);
  EXPECT_DOUBLE_EQ(c.min, -1);
  EXPECT_DOUBLE_EQ(c.max, 0.5);
  EXPECT_DOUBLE_EQ(c.improved_fraction, 0.5);
  EXPECT_EQ(c.difference.value, (std::vector<double>{-1, 0.5, INFINITY, INFINITY}));
  a.larger_is_better = b.larger_is_better = true;
  EXPECT_DOUBLE_EQ(compare_fields(a, b).improved_fraction, 0.5);
}

}  // namespace
}  // namespace delos
