// How good readings are: power, the noise of electronics, coded windows.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "readings/amplifier_noise.h"
#include "readings/coded_window.h"
#include "readings/power.h"

namespace delos::readings {
namespace {

/// Of a t test: Cohen (1988), Table 2.3.5 and 2.4.1 (two means; d = 0.2, 0.5, 0.8:
/// 393, 64, 26), as G*Power 3.1 has them exactly: 394, 64, 26, and 34 for one mean at
/// d = 0.5, with powers of 0.8006, 0.8015, 0.8075 and 0.8078.
TEST(Power, HasThePublishedCounts) {
  PowerTest test;
  test.known = false;
  test.two_means = true;
  for (const auto& [d, count, power] :
       {std::tuple{0.2, 394, 0.8006}, {0.5, 64, 0.8015}, {0.8, 26, 0.8075}}) {
    EXPECT_EQ(readings_for(test, d, 0.8), count);
    EXPECT_NEAR(power_of(test, d, count), power, 1e-4);
  }
  test.two_means = false;
  EXPECT_EQ(readings_for(test, 0.5, 0.8), 34);
  EXPECT_NEAR(power_of(test, 0.5, 34), 0.8078, 1e-4);
}

/// Allen (2007), §8.4: z of 0.025 and 0.20 are 1.96 and 0.84; of X_n taken for a
/// variance, the least effects of one reading after 1, 2, 8, 15 and 30 clocks
/// (Fig. 8.1: 0.042 to 0.018), the mean of 30 of them after one clock each (0.007),
/// and, by the two-sample formula alone, the readings of Fig. 8.2.
TEST(Power, HasThePublishedEffects) {
  PowerTest test;
  const CriticalValues z = critical_values(test, 0.8);
  EXPECT_NEAR(z.alpha, 1.959964, 1e-6);
  EXPECT_NEAR(z.beta, 0.841621, 1e-6);
  const Amplifier amplifier;
  const double current = 5.361239747e-6;  // of an LED 1 m ahead
  const auto sigma = [&](int clocks) {
    return std::sqrt(position_noise(amplifier, current, 0.5, clocks * 21e-6, 1).linear);
  };
  // With 7.84, as printed, in the place of (1.960 + 0.842)² = 7.849.
  const double rounding = std::sqrt(7.84) / (z.alpha + z.beta);
  for (const auto& [clocks, effect] : {std::pair{1, 0.04207},
                                       {2, 0.03559},
                                       {8, 0.02528},
                                       {15, 0.02162},
                                       {30, 0.01819}}) {
    test.sigma = sigma(clocks);
    EXPECT_NEAR(effect_for(test, 1, 0.8) * rounding, effect, 6e-6) << clocks;
  }
  test.sigma = sigma(1);
  EXPECT_NEAR(effect_for(test, 30, 0.8) * rounding, 0.00768, 6e-6);
  test.two_means = true;
  for (const auto& [clocks, percent1, permille1] :
       {std::tuple{1, 9, 886}, {15, 3, 234}, {30, 2, 166}}) {
    test.sigma = sigma(clocks);
    EXPECT_EQ(readings_for(test, 0.02, 0.8), percent1);
    EXPECT_NEAR(readings_for(test, 0.002, 0.8), permille1, 1);
    EXPECT_EQ(readings_for(test, 0.2, 0.8), 1);
  }
}

/// The share of 20,000 drawn experiments that find the difference.
TEST(Power, IsTheShareThatFindsIt) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  PowerTest test;
  test.known = false;
  constexpr int kReadings = 8, kTrials = 20'000;
  const double t = 2.364624;  // of 0.025 at either end and 7 degrees, any table
  int found = 0;
  for (int i = 0; i < kTrials; ++i) {
    double sum = 0, squares = 0;
    for (int n = 0; n < kReadings; ++n) {
      const double v = 0.9 + normal(random);
      sum += v;
      squares += v * v;
    }
    const double mean = sum / kReadings,
                 variance = (squares - sum * mean) / (kReadings - 1);
    found += std::abs(mean) / std::sqrt(variance / kReadings) > t;
  }
  EXPECT_NEAR(power_of(test, 0.9, kReadings), found / double{kTrials}, 0.012);
}

TEST(Power, AnswersTheThreeQuestionsAlike) {
  for (const bool two_sided : {false, true})
    for (const bool two_means : {false, true})
      for (const bool known : {false, true}) {
        const PowerTest test{2.0, 0.01, two_sided, two_means, known};
        const double count = readings_for(test, 0.7, 0.9);
        EXPECT_GE(power_of(test, 0.7, count), 0.9);
        EXPECT_LT(power_of(test, 0.7, count - 1), 0.9);
        const double effect = effect_for(test, count, 0.9);
        EXPECT_NEAR(power_of(test, effect, count), 0.9, 1e-9);
        EXPECT_LE(effect, 0.7);
        EXPECT_NEAR(power_of(test, 0, count), 0.01, 1e-9) << "no difference: alpha";
      }
  EXPECT_EQ(readings_for({1, 0.05, true, false, true}, 1e-9, 0.8), 0);
  EXPECT_EQ(power_of({1, 0.05, true, false, false}, 1e6, 3), 1);
}

/// The listing's values, computed from it by other means: x = 0.5, an LED 3 m away and
/// 60° aside, by windows of 20 µs to 2 ms, and two of one 1 m ahead.
TEST(AmplifierNoise, HasTheListingsValues) {
  const Amplifier amplifier;
  const double K = 5.361239747e-6, aside = K * 0.5 / 9;
  for (const auto& [window, noise] : {std::pair{20e-6, 3.836470e-3},
                                      {40e-6, 2.748061e-3},
                                      {60e-6, 2.253299e-3},
                                      {80e-6, 1.955522e-3},
                                      {100e-6, 1.751273e-3},
                                      {200e-6, 1.241444e-3},
                                      {400e-6, 8.789294e-4},
                                      {1e-3, 5.562994e-4},
                                      {2e-3, 3.934610e-4}})
    EXPECT_NEAR(position_noise(amplifier, aside, 0.5, window, 1).linear, noise,
                1e-6 * noise);
  EXPECT_NEAR(position_noise(amplifier, K, 0.5, 630e-6, 1).linear, 4.219e-5, 5e-9);
  EXPECT_NEAR(position_noise(amplifier, K, 0.5, 21e-6, 1).linear, 2.257e-4, 5e-8);
  EXPECT_NEAR(position_noise(amplifier, K, 0.5, 21e-6, 4).linear, 2.257e-4 / 2, 5e-8);
  const PositionNoise both = position_noise(amplifier, K, 0, 1e-4, 1);
  EXPECT_NEAR(both.independent, both.linear / std::sqrt(2), 1e-12);
}

TEST(AmplifierNoise, HasJohnsonAndShot) {
  EXPECT_NEAR(johnson_noise(7500, 300, 160e3), 4.459e-6, 5e-10);
  EXPECT_NEAR(shot_noise(1e-6, 160e3), 2.264e-10, 5e-14);
  Amplifier one_end;
  one_end.interelectrode = INFINITY;
  const auto sources = noise_of(one_end, 1e-6, 1e-4);
  EXPECT_EQ(sources[2].density, 0) << "no other amplifier";
  EXPECT_EQ(sources[4].density, 0) << "no resistance of the diode";
  EXPECT_EQ(sources[1].density, one_end.voltage);
}

/// G² is twice the integral of the windows' spectrum over the filter's, and a 1/f
/// corner adds twice that of f_c/f times it: both over a logarithm of f.
TEST(AmplifierNoise, OfACornerIsTheIntegralOfItsSpectrum) {
  Amplifier a;
  a.voltage_corner = 300;
  const double window = 1e-4;
  const auto integral = [&](double power) {
    const auto of_log = [&](double log_f) {
      const double f = std::exp(log_f), x = std::numbers::pi * f * window;
      const double sinc = std::sin(x) / x,
                   both = 2 * std::sin(std::numbers::pi * f * (window + a.gap));
      return sinc * sinc * both * both / (1 + std::pow(f / a.bandwidth, 2)) *
             std::pow(f, 1 - power);
    };
    double sum = 0;
    for (double log = std::log(1e-3); log < std::log(3e7); log += 0.005)
      sum += 0.005 * of_log(log + 0.0025);
    return sum;
  };
  const double density = noise_of(a, 1e-6, window)[2].density;
  const double white = 2 * integral(0), pink = 2 * 300 * integral(1);
  EXPECT_NEAR(std::pow(noise_of(a, 1e-6, window)[2].rms, 2) / (density * density),
              white + pink, 2e-3 * white);
  EXPECT_GT(pink, 0.02 * white) << "a corner that shows";
  EXPECT_EQ(noise_of(a, 1e-6, window)[3].rms, noise_of({}, 1e-6, window)[3].rms)
      << "the current's has no corner";
}

CodedWindow window_of(const std::string& code, double chop) {
  return {code_of(code).value(), chop};
}

/// One open window of τ: qτ/3, qτ³/20, qτ⁵/252, and h = −τ/2, τ²/6.
TEST(CodedWindow, OfOneWindowIsTheMeanOverIt) {
  for (const char* code : {"1", "11", "1111111"}) {
    const CodedWindow window = window_of(code, 0.7 / double(std::string(code).size()));
    EXPECT_NEAR(motion_of(window, 1), 0.7 / 3, 1e-13);
    EXPECT_NEAR(motion_of(window, 2), std::pow(0.7, 3) / 20, 1e-13);
    EXPECT_NEAR(motion_of(window, 3), std::pow(0.7, 5) / 252, 1e-13);
    EXPECT_NEAR(lever_of(window, 0), 1, 1e-13);
    EXPECT_NEAR(lever_of(window, 1), -0.35, 1e-13);
    EXPECT_NEAR(lever_of(window, 2), 0.49 / 6, 1e-13);
    EXPECT_NEAR(spread_of(window), 0.7 / std::sqrt(12), 1e-13);
  }
}

/// Of a code: a target that walks at random, backwards from a known end.
TEST(CodedWindow, IsTheVarianceOfDrawnPaths) {
  const CodedWindow window = window_of("1001101", 0.1);
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  constexpr int kPaths = 20'000, kSteps = 10;  // a chop
  double squares = 0;
  for (int path = 0; path < kPaths; ++path) {
    double x = 0, sum = 0;
    for (int i = 6; i >= 0; --i)
      for (int s = 0; s < kSteps; ++s) {
        const double step = std::sqrt(0.1 / kSteps) * normal(random);
        if (window.open[static_cast<std::size_t>(i)]) sum += x + step / 2;
        x += step;
      }
    squares += std::pow(sum / (4 * kSteps), 2) / kPaths;
  }
  EXPECT_NEAR(squares / motion_of(window, 1), 1, 4 * std::sqrt(2.0 / kPaths) + 2e-3);
}

/// The code of Raskar, Agrawal and Tumblin (2006), 52 chops of which 26 are open, has a
/// spectrum without zeros; a whole window's vanishes.
TEST(CodedWindow, CanBeUndone) {
  const CodedWindow coded =
      window_of("1010000111000001010000110011110111010111001001100111", 1e-3);
  EXPECT_EQ(coded.open.size(), 52u);
  EXPECT_NEAR(coded.light(), 26e-3, 1e-12);
  const Smear smear = smear_of(coded);
  EXPECT_GT(smear.least, 0.01);
  EXPECT_TRUE(std::isfinite(smear.noise_gain));
  const Smear whole = smear_of(window_of("1111", 1e-3));
  EXPECT_EQ(whole.least, 0);
  EXPECT_TRUE(std::isinf(whole.noise_gain));
  EXPECT_NEAR(smear_of(window_of("1", 1e-3)).noise_gain, 1, 1e-12);
}

TEST(CodedWindow, RefusesWhatIsNoCode) {
  for (const std::string& bad :
       {std::string(), std::string("000"), std::string("12"), std::string(1001, '1')})
    EXPECT_FALSE(code_of(bad));
}

}  // namespace
}  // namespace delos::readings
