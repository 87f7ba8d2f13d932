// How noise and rate follow the sample time: laws, keys of scenes, and refusals.
#include <cmath>
#include <numbers>

#include "delos/scene/definition.h"
#include "scenes.h"

namespace delos {
namespace {

using test::findings_of;
using test::scene_of;
using test::two_cameras;

double ratio(NoiseOverTime noise, double at, double exposure) {
  noise.at = at;
  return noise_ratio(noise, exposure);
}

TEST(NoiseOverTime, FollowsEachLaw) {
  EXPECT_EQ(ratio({}, 1, 0), 1);
  EXPECT_NEAR(ratio({NoiseLaw::inverse}, 0.01, 0.04), 0.25, 1e-15);
  NoiseOverTime samples{NoiseLaw::samples};
  samples.frequency = 1000;
  EXPECT_NEAR(ratio(samples, 0.01, 0.04), 0.25, 1e-15);
  EXPECT_NEAR(ratio(samples, 0.01, 1e-6), 10, 1e-13) << "one sample at least";
  NoiseOverTime photon{NoiseLaw::photon};
  photon.read = 0.2;
  EXPECT_NEAR(ratio(photon, 0.01, 0.005), 0.8 * 2 + 0.2 * 4, 1e-15);
  NoiseOverTime formula{NoiseLaw::expression};
  formula.expression = "1e-9/tau + 2e-8";
  EXPECT_NEAR(ratio(formula, 0.1, 0.01), 12e-8 / 3e-8, 1e-14);
  EXPECT_TRUE(std::isinf(ratio({NoiseLaw::inverse}, 0.01, 0)));
}

/// Golden values of the dissertation's listing, computed from it by other means
/// (Appendix C: 160 kHz, 20 µs).
TEST(NoiseOverTime, KnowsPhotodiodes) {
  EXPECT_NEAR(photodiode_gain(100e-6, 1.6e5, 2e-5), 140.716226, 1e-6);
  EXPECT_NEAR(photodiode_gain(630e-6, 1.6e5, 2e-5), 56.299118, 1e-6);
  EXPECT_NEAR(photodiode_gain(20e-6, 1.6e5, 2e-5), 308.263537, 1e-6);
  // Long windows leave 2/T, less what their two ends share.
  const double a = std::numbers::pi * 1.6e5, T = 1, T0 = 2e-5;
  EXPECT_NEAR(
      photodiode_gain(T, 1.6e5, T0),
      std::sqrt(2 / (T * T) * (T - 1 / (2 * a) - std::exp(-2 * a * T0) / (4 * a))),
      1e-12);
  NoiseOverTime noise{NoiseLaw::photodiode};
  noise.bandwidth = 1.6e5;
  noise.gap = 2e-5;
  // X_n is proportional to G: 2.257e-4 at 21 µs and 4.219e-5 at 630 µs.
  EXPECT_NEAR(std::sqrt(ratio(noise, 630e-6, 21e-6)), 2.257 / 0.4219, 2e-3);
}

/// Three terms are found again from readings without error, each by itself as well, and
/// scatter of 5 % is told as such.
TEST(BenchFit, FindsItsTerms) {
  const auto table = [](double a, double b, double c, double scatter) {
    std::vector<BenchReading> readings;
    for (int i = 0; i < 12; ++i) {
      const double t = 1e-4 * std::pow(1.6, i);
      readings.push_back(
          {t, (a + b / t + c / t / t) * (1 + (i % 2 ? scatter : -scatter))});
    }
    return readings;
  };
  for (const auto& [a, b, c] :
       {std::array{2e-6, 3e-9, 5e-13}, std::array{0.0, 3e-9, 0.0},
        std::array{2e-6, 0.0, 0.0}, std::array{0.0, 0.0, 5e-13}}) {
    const BenchFit fit = fit_bench(table(a, b, c, 0));
    EXPECT_NEAR(fit.constant, a, 1e-8 * 2e-6);
    EXPECT_NEAR(fit.inverse, b, 1e-8 * 3e-9);
    EXPECT_NEAR(fit.inverse_square, c, 1e-8 * 5e-13);
    EXPECT_LT(fit.error, 1e-9);
  }
  EXPECT_NEAR(fit_bench(table(2e-6, 3e-9, 5e-13, 0.05)).error, 0.05, 0.01);
}

/// R of the system is that of the sample time, and the update takes what it takes.
TEST(SampleTime, SetsNoiseAndRate) {
  const Scene scene = scene_of(
      two_cameras("exposure: 2 ms, timing: {processing: 3 ms, idle: 1 ms, windows: 2}, "
                  "noise_over_time: {law: inverse, at: 10 ms}"));
  EXPECT_NEAR(rate_of(scene.devices[0]), 125, 1e-9);
  const System system = build_system(scene, test::plugins());
  EXPECT_NEAR(system.devices[1].noise, 5, 1e-12);
  EXPECT_NEAR(system.devices[1].period, 8e-3, 1e-15);
  EXPECT_EQ(system.fusion, Fusion::stacked);
  EXPECT_EQ(system.devices[0].exposure, 2e-3);
}

TEST(SampleTime, IsWrittenAsItWasRead) {
  for (const char* noise :
       {"{law: photon, at: 10 ms, read: 0.2}",
        "{law: samples, at: 1 ms, frequency: 10 kHz}",
        "{law: photodiode, at: 630 us, bandwidth: 160 kHz, gap: 20 us}",
        "{law: table, at: 1 ms, table: [[1 ms, 4], [2 ms, 2], [4 ms, 1.05]]}",
        "{law: expression, at: 1 ms, expression: 1/tau + 3}"}) {
    const Scene scene = scene_of(
        two_cameras("exposure: 2 ms, timing: {processing: 3 ms}, noise_over_time: " +
                        std::string(noise),
                    "lag: 20 ms\nexposures: averaged\n"));
    EXPECT_EQ(scene.lag, 0.02);
    EXPECT_EQ(scene.exposures, ExposureModel::averaged);
    EXPECT_TRUE(scene_of(write_scene(scene)) == scene) << write_scene(scene);
  }
}

/// Both rates follow one exposure: still one rate, and stacked.
TEST(SampleTime, OfAVariableKeepsTheFusion) {
  const std::string cameras = two_cameras("exposure: 2 ms, timing: {processing: 3 ms}");
  const std::string together =
      "variables: [{path: devices.a.exposure, lower: 1 ms, upper: 9 ms, tie: "
      "[devices.b.exposure]}]\n";
  EXPECT_TRUE(varies_rates(scene_of(cameras + together)));
  EXPECT_EQ(definition_of(scene_of(cameras + together)).fusion, Fusion::stacked);
  const std::string apart =
      "variables: [{path: devices.a.exposure, lower: 1 ms, upper: 9 ms}]\n";
  const std::vector<std::string> findings = findings_of(cameras + apart);
  ASSERT_FALSE(findings.empty()) << "two rates are fused continuously";
  EXPECT_NE(findings[0].find("isn't known to continuous fusion"), std::string::npos);
}

TEST(SampleTime, IsRefusedWithASentence) {
  const auto first = [](const std::string& keys, const std::string& more = "") {
    const std::vector<std::string> all = findings_of(two_cameras(keys, more));
    return all.empty() ? std::string("no finding") : all[0];
  };
  const auto says = [&](const std::string& keys, const std::string& part,
                        const std::string& more = "") {
    const std::string found = first(keys, more);
    EXPECT_NE(found.find(part), std::string::npos) << keys << "\n" << found;
    EXPECT_TRUE(found.starts_with("s.yaml:")) << found;
  };
  says("exposure: 1 ms", "devices.a.rate: missing: updates a second");
  says("rate: 50 Hz, timing: {processing: 1 ms}", "devices.a.timing: says the rate");
  says("timing: {idle: 0}", "leaves an update no time");
  says("timing: {processing: -1 ms}", "processing: must not be below 0");
  says("timing: {windows: 0}", "windows: must be above 0");
  says("exposure: 3 ms, timing: {windows: 0.5}", "exposure: must not be longer than");
  const auto noise = [&](const std::string& keys, const std::string& part) {
    says("rate: 50 Hz, exposure: 1 ms, noise_over_time: " + keys, part);
  };
  noise("{law: inverse}", "at: missing: the exposure that the noise");
  noise("{law: constant, at: 1 ms}", "has no meaning where the noise is constant");
  noise("{law: inverse, at: 0}", "at: must be above 0");
  noise("{law: inverse, at: 1 ms, read: 0.1}", "read: goes with law: photon");
  noise("{law: photon, at: 1 ms, read: 1.1}", "read: must be from 0 to 1");
  noise("{law: samples, at: 1 ms}", "frequency: missing");
  noise("{law: expression, at: 1 ms, expression: 1/t}", "expression: ");
  noise("{law: expression, at: 1 ms, expression: tau - 1}", "has no positive value");
  noise("{law: table, at: 1 ms, table: [[1 ms, 1], [2 ms, 1]]}", "three pairs");
  noise("{law: table, at: 1 ms, table: [[2 ms, 1], [1 ms, 2], [3 ms, 1]]}",
        "table.1: its exposure isn't longer than the one before");
  noise("{law: table, at: 1 ms, table: [[1 ms, 1], [2 ms, 0], [3 ms, 1]]}",
        "table.1: its variance must be above 0");
  noise("{law: table, at: 1 ms, table: [[1 ms, 1], [2 ms, 10], [3 ms, 100]]}",
        "is near it: the best is off by");
  says("rate: 50 Hz, noise_over_time: {law: inverse, at: 1 ms}",
       "exposure: of 0 ms leaves its noise_over_time no finite value");
  says("rate: 50 Hz", "lag: must not be below 0", "lag: -1 ms\n");
  says("rate: 50 Hz", "lag: isn't known to artemis", "lag: 1 ms\nfusion: artemis\n");
  says("rate: 50 Hz", "lag: isn't known to single", "lag: 1 ms\ncovariance: single\n");
  says("rate: 50 Hz", "lag: '5 m' is a length", "lag: 5 m\n");
}

}  // namespace
}  // namespace delos
