// Statistics of adaptive fields against Monte Carlo over the same volume.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>

#include "delos/field/adaptive.h"
#include "shipped.h"

namespace delos::test {
namespace {

/// A number of the environment: DELOS_SEEDS=40 DELOS_POINTS=8000000 are the full run.
/// The reference's own error is the same for all seeds: with a million points it may
/// decide, as it does for the mean of the two cameras (32 of 40; 38 with eight
/// million).
int asked(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

/// Two cameras beside a room whose views cover 90 % of it.
constexpr const char* kTwoCameras = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {volume: {min: [0, 0, 0], max: [4, 4, 2], adaptive: {}}}
devices:
  - {name: a, type: pinhole_camera, rate: 100 Hz, at: [-1, -1, 2.5], aim: [2, 2, 1], params: &c {focal: 6 mm, pitch: 5 um, resolution: [1280, 1024], sigma: 0.1}}
  - {name: b, type: pinhole_camera, rate: 100 Hz, at: [5, -1, 2.5], aim: [2, 2, 1], params: *c}
)";

Scene two_cameras() {
  Diagnostics findings;
  return parse_scene(kTwoCameras, "two.yaml", {}, plugins(), findings).value();
}

struct Study {
  const char* name;
  const char* metric;
  /// The scene's volume, sampled adaptively; empty: two_cameras().
  const char* volume;
};

class Statistics : public ::testing::TestWithParam<Study> {
 protected:
  Statistics()
      : scene_(*GetParam().volume
                   ? load(GetParam().name, {{"sample", GetParam().volume}})
                   : two_cameras()),
        system_(build_system(scene_, plugins())),
        sampling_(std::get<AdaptiveSampling>(scene_.samples[0].shape)),
        metric_(
            std::get<Metric>(parse_metric(GetParam().metric, scene_.motion.layout))) {}

  Field monte_carlo(int count) const {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    Samples samples;
    for (int i = 0; i < count; ++i) {
      Eigen::Vector3d p = sampling_.min;
      for (int k = 0; k < 3; ++k)
        p(k) += uniform(random) * (sampling_.max - sampling_.min)(k);
      samples.points.push_back(p);
    }
    samples.parts.push_back({"", 0, samples.points.size(), ScatteredShape{}});
    return evaluate_field(system_, samples, scene_.orientations, metric_,
                          {.threads = 2});
  }

  FieldStatistics adaptive(int seed) const {
    AdaptiveOptions options;
    options.field.threads = 2;
    options.held_back = 0;
    options.seed = static_cast<std::uint64_t>(seed);
    return summarize(
        evaluate_adaptive(system_, sampling_, scene_.orientations, metric_, options)
            .field());
  }

  const Scene scene_;
  const System system_;
  const AdaptiveSampling sampling_;
  const Metric metric_;
};

/// What of a statistic's error Monte Carlo has itself, 95 %: quantiles by the density
/// between their neighbours, means by the standard deviation.
struct Reference {
  double value, error;
};

struct References {
  Reference observable, mean, median, p95;
  std::vector<double> sorted;
};

References references(const Field& field) {
  References r;
  double sum = 0, squares = 0, outside = 0, observable = 0;
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    if (!field.inside.empty() && field.inside[i]) continue;
    ++outside;
    observable += field.observable[i];
    if (!std::isfinite(field.value[i])) continue;
    sum += field.value[i];
    squares += field.value[i] * field.value[i];
    r.sorted.push_back(field.value[i]);
  }
  std::sort(r.sorted.begin(), r.sorted.end());
  const double n = static_cast<double>(r.sorted.size());
  const double share = observable / outside, mean = sum / n;
  r.observable = {share, 1.96 * std::sqrt(share * (1 - share) / outside)};
  r.mean = {mean, 1.96 * std::sqrt((squares / n - mean * mean) / n)};
  const auto at = [&](double p) {
    return r.sorted[static_cast<std::size_t>(std::clamp(p, 0.0, 1.0) * (n - 1))];
  };
  for (const auto& [p, of] : {std::pair{0.5, &r.median}, std::pair{0.95, &r.p95}}) {
    const double e = 1.96 * std::sqrt(p * (1 - p) / n);
    *of = {at(p), (at(p + e) - at(p - e)) / 2};
  }
  return r;
}

TEST_P(Statistics, AreWithinTheirErrorsOfMonteCarlo) {
  const int seeds = asked("DELOS_SEEDS", 8);
  const References truth = references(monte_carlo(asked("DELOS_POINTS", 100'000)));
  const std::vector<double>& sorted = truth.sorted;
  std::map<std::string, int> kept;
  std::map<std::string, double> error;
  for (int seed = 1; seed <= seeds; ++seed) {
    const FieldStatistics s = adaptive(seed);
    ASSERT_TRUE(s.volume.has_value());
    const VolumeStatistics& v = *s.volume;
    const auto judge = [&](const char* name, double value, double e,
                           const Reference& of) {
      kept[name] += std::abs(value - of.value) <= std::hypot(e, of.error);
      error[name] = std::max(error[name], e);
    };
    judge("observable", v.observable, v.observable_error, truth.observable);
    judge("mean", s.mean, v.mean_error, truth.mean);
    judge("median", s.median, v.median_error, truth.median);
    judge("p95", s.p95, v.p95_error, truth.p95);
    // Parts of the volume below the least and above the greatest value.
    const double n = static_cast<double>(sorted.size());
    const auto below =
        std::lower_bound(sorted.begin(), sorted.end(), s.min.value) - sorted.begin();
    const auto above =
        sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), s.max.value);
    const double more = static_cast<double>(std::max(below, above)) / n;
    kept["beyond"] += more <= v.beyond + 1.96 * std::sqrt(v.beyond / n);
    error["beyond"] = std::max(error["beyond"], v.beyond);
  }
  for (const auto& [name, count] : kept) {
    RecordProperty(name, std::to_string(count) + " of " + std::to_string(seeds) +
                             ", error at most " + std::to_string(error[name]));
    // One of eight misses in a third of all cases, three in one of 170.
    EXPECT_GE(count, seeds >= 40 ? 0.95 * seeds - 2 : seeds - 2) << name;
  }
  // The errors are small enough to be of use: about a part in 250 of the volume.
  EXPECT_LT(error["observable"], 0.004);
  EXPECT_LT(error["mean"], 0.01 * truth.mean.value);
  EXPECT_LT(error["beyond"], 0.004);
}

constexpr const char* kSmall =
    "{volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], adaptive: {}}}";
constexpr const char* kLaboratory =
    "{volume: {min: [-3.0, -4.2, 0], max: [1.6, 3.4, 2.0], adaptive: {depth: 3}}}";

INSTANTIATE_TEST_SUITE_P(
    Scenes, Statistics,
    ::testing::Values(Study{"02-eight-cameras", "eigmax", kSmall},
                      Study{"05-optitrack-lab", "eigmax", kLaboratory},
                      Study{"06-furnished-lab", "eigmax", kLaboratory},
                      Study{"06-furnished-lab", "coverage", kLaboratory},
                      Study{"two cameras", "eigmax", ""},
                      Study{"two cameras", "coverage", ""}));

/// 8,000 points of a user's own Monte Carlo: 89.9 % of the volume is observable (a
/// regular grid of 25 mm: 89.5 %), 1.89 cameras see a point of it in the mean.
TEST(VolumeStatistics, AreNotThoseOfTheNodes) {
  const Scene scene = two_cameras();
  const System system = build_system(scene, plugins());
  const auto& sampling = std::get<AdaptiveSampling>(scene.samples[0].shape);
  const auto field = [&](const char* metric) {
    return evaluate_adaptive(
               system, sampling, scene.orientations,
               std::get<Metric>(parse_metric(metric, scene.motion.layout)))
        .field();
  };
  const FieldStatistics eigmax = summarize(field("eigmax"));
  ASSERT_TRUE(eigmax.volume.has_value());
  EXPECT_NEAR(eigmax.volume->observable, 0.899, 0.006);
  EXPECT_NEAR(summarize(field("coverage")).mean, 1.89, 0.01);
  // Of the nodes, 79 %.
  EXPECT_LT(static_cast<double>(eigmax.observable) / eigmax.samples, 0.8);
}

}  // namespace
}  // namespace delos::test
