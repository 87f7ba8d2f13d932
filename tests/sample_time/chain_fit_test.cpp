// Motion models from records that were drawn from known ones.
#include "motion/chain_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "motion/motion_fit.h"
#include "support/walk.h"

namespace delos::motion {
namespace {

constexpr double kDt = 0.01;

using test::Walk;

/// −2 log L by the joint covariance of all values, which is a Gaussian of that
/// covariance: of z_t − z_0 for a P chain from a known start, q t and r each.
TEST(ChainFit, HasTheLikelihoodOfTheJointGaussian) {
  const int n = 80;
  const std::vector<double> z = Walk(1, 2.0, 0.01, kDt, 5).record(n);
  const ChainFit fit = fit_chains(z, kDt)[0];
  // The first kOrders values find the state: what is left is given them.
  const auto log_density = [&](int count) {
    // A start that is as good as unknown.
    Eigen::MatrixXd C = Eigen::MatrixXd::Constant(count, count, 1e8);
    Eigen::VectorXd v(count);
    for (int i = 0; i < count; ++i) {
      v(i) = z[static_cast<std::size_t>(i)] - z[0];
      for (int j = 0; j < count; ++j) C(i, j) += fit.q.value * kDt * std::min(i, j);
      C(i, i) += fit.r.value;
    }
    const Eigen::LDLT<Eigen::MatrixXd> chol(C);
    return v.dot(chol.solve(v)) + chol.vectorD().array().log().sum() +
           count * std::log(2 * std::numbers::pi);
  };
  EXPECT_NEAR(fit.minus_2_log_likelihood, log_density(n) - log_density(kOrders), 1e-3);
}

/// Over many records: the right order in 95 %, q and r within their intervals in 95 %,
/// and white in 99 %, each within what so many trials let one see (3 standard
/// deviations).
TEST(ChainFit, FindsOrderAndNoiseAgain) {
  constexpr int kRecords = 60, kFrames = 600;
  for (int k = 1; k <= kOrders; ++k) {
    int order = 0, q_inside = 0, r_inside = 0, white = 0;
    for (unsigned s = 0; s < kRecords; ++s) {
      const double q = std::pow(10, (s % 7) / 3.0 - 1);
      const double r = q * std::pow(kDt, 2 * k - 1) * std::pow(10, (s % 5) / 2.0);
      const std::vector<double> z =
          Walk(k, q, r, kDt, 1000 * static_cast<unsigned>(k) + s).record(kFrames);
      const auto fits = fit_chains(z, kDt);
      int best = 0;
      for (int o = 1; o < kOrders; ++o)
        if (fits[static_cast<std::size_t>(o)].minus_2_log_likelihood <
            fits[static_cast<std::size_t>(best)].minus_2_log_likelihood)
          best = o;
      const ChainFit& fit = fits[static_cast<std::size_t>(k - 1)];
      order += best == k - 1;
      q_inside += fit.q.low <= q && q <= fit.q.high;
      r_inside += fit.r.low <= r && r <= fit.r.high;
      white += fit.p_value >= 0.01;
      EXPECT_EQ(fit.edge, Edge::none);
    }
    const auto least = [&](double part) {
      return kRecords * part - 3 * std::sqrt(kRecords * part * (1 - part));
    };
    EXPECT_GE(order, 0.95 * kRecords) << k;
    EXPECT_GE(q_inside, least(0.95)) << k;
    EXPECT_GE(r_inside, least(0.95)) << k;
    EXPECT_LT(q_inside + r_inside, 2 * kRecords) << "intervals that say nothing";
    EXPECT_GE(white, least(0.99)) << k;
  }
}

/// Frames that are missing are stepped over: less is known, and it is the same.
TEST(ChainFit, StepsOverGaps) {
  Walk walk(2, 1.0, 1e-6, kDt, 3);
  std::vector<double> z = walk.record(4000);
  for (std::size_t i = 0; i < z.size(); ++i)
    if (i % 10 == 3 || (i > 1000 && i < 1200) || i < 5) z[i] = NAN;
  const ChainFit fit = fit_chains(z, kDt)[1];
  EXPECT_LE(fit.q.low, 1.0);
  EXPECT_GE(fit.q.high, 1.0);
  EXPECT_LE(fit.r.low, 1e-6);
  EXPECT_GE(fit.r.high, 1e-6);
}

recordings::Track track_of(int k, double q, double r, int frames) {
  recordings::Track track{"hand", {}};
  track.at.resize(frames, 3);
  for (unsigned a = 0; a < 3; ++a) {
    Walk walk(k, q * (a + 1), r, kDt, 77 + a);
    for (int i = 0; i < frames; ++i) track.at(i, a) = walk.next();
  }
  return track;
}

TEST(MotionFit, DecidesAndWritesABlock) {
  const auto answer = fit_motion(track_of(2, 0.5, 1e-6, 2000), kDt, {});
  ASSERT_TRUE(std::holds_alternative<MotionFit>(answer));
  const MotionFit& fit = std::get<MotionFit>(answer);
  EXPECT_EQ(fit.best, 1);
  EXPECT_TRUE(fit.fits);
  EXPECT_FALSE(fit.still);
  for (std::size_t a = 0; a < 3; ++a) {
    const double q = 0.5 * static_cast<double>(a + 1);
    EXPECT_LE(fit.orders[1].axes[a].q.low, q);
    EXPECT_GE(fit.orders[1].axes[a].q.high, q);
  }
  const std::string block = motion_block(fit, "walk.csv");
  EXPECT_NE(block.find("type: position_velocity\n"), std::string::npos) << block;
  EXPECT_EQ(block.find("None"), std::string::npos) << block;
}

/// A target that swings is none of these chains.
TEST(MotionFit, SaysThatNoneFits) {
  recordings::Track track{"pendulum", {}};
  track.at.resize(3000, 3);
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 3000; ++i)
    for (int a = 0; a < 3; ++a)
      track.at(i, a) =
          std::sin(2 * std::numbers::pi * 8 * kDt * i + a) + 1e-3 * normal(random);
  const auto answer = fit_motion(track, kDt, {});
  ASSERT_TRUE(std::holds_alternative<MotionFit>(answer));
  EXPECT_FALSE(std::get<MotionFit>(answer).fits);
  EXPECT_NE(motion_block(std::get<MotionFit>(answer), "p.csv").find("None of"),
            std::string::npos);
}

/// What is white counts before what is likely: a chain whose noise isn't white has a
/// likeliest order, and is taken by a higher one that whitens it.
TEST(MotionFit, TakesTheLikeliestOfThoseThatAreWhite) {
  const auto answer = fit_motion(track_of(1, 0.5, 1e-4, 3000), kDt, {});
  const MotionFit& fit = std::get<MotionFit>(answer);
  EXPECT_EQ(fit.best, 0);
  EXPECT_EQ(fit.likeliest, 0);
  FitQuestion question;
  // Between the p-values of P and of PV nothing but the whitest is left.
  double white = 0;
  std::size_t whitest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (fit.orders[k].p_value > white) white = fit.orders[whitest = k].p_value;
  question.significance = white * 0.999;
  const auto again = fit_motion(track_of(1, 0.5, 1e-4, 3000), kDt, question);
  EXPECT_EQ(std::get<MotionFit>(again).best, static_cast<int>(whitest));
  EXPECT_TRUE(std::get<MotionFit>(again).fits);
  question.significance = 1;
  const auto none = fit_motion(track_of(1, 0.5, 1e-4, 3000), kDt, question);
  EXPECT_EQ(std::get<MotionFit>(none).best, 0);
  EXPECT_FALSE(std::get<MotionFit>(none).fits);
}

/// Noise about one place: no q is told from 0.
TEST(MotionFit, KnowsAStillTarget) {
  recordings::Track track{"table", {}};
  track.at.resize(2000, 3);
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (double& x : track.at.reshaped()) x = 1e-4 * normal(random);
  const auto answer = fit_motion(track, kDt, {});
  ASSERT_TRUE(std::holds_alternative<MotionFit>(answer));
  const MotionFit& fit = std::get<MotionFit>(answer);
  EXPECT_TRUE(fit.still);
  for (const ChainFit& axis : fit.orders[0].axes) {
    EXPECT_EQ(axis.q.low, 0);
    EXPECT_NEAR(axis.r.value, 1e-8, 2e-9);
  }
}

TEST(MotionFit, RefusesWhatSaysNothing) {
  const auto refused = [](const recordings::Track& track, const FitQuestion& question) {
    const auto answer = fit_motion(track, kDt, question);
    const auto* problem = std::get_if<std::string>(&answer);
    return problem ? *problem : std::string();
  };
  recordings::Track track = track_of(1, 1, 1e-6, 200);
  EXPECT_EQ(refused(track, {}), "");
  FitQuestion question;
  question.interval = 0.015;
  EXPECT_NE(refused(track, question).find("isn't a multiple"), std::string::npos);
  question.interval = 0.05;
  EXPECT_NE(refused(track, question).find("only 40 frames"), std::string::npos);
  question = {};
  question.to = 0.3;
  EXPECT_NE(refused(track, question).find("only 30 frames"), std::string::npos);
  track.at.col(1).setConstant(0.7);
  EXPECT_NE(refused(track, {}).find("the same place in all frames along 1"),
            std::string::npos);
  track.at.col(1).setConstant(NAN);
  EXPECT_NE(refused(track, {}).find("only 0 frames"), std::string::npos);
}

/// Every fifth frame of a record is a record of a longer interval.
TEST(MotionFit, TakesTheDevicesInterval) {
  FitQuestion question;
  question.interval = 0.05;
  const auto answer = fit_motion(track_of(2, 0.5, 1e-6, 5000), kDt, question);
  const MotionFit& fit = std::get<MotionFit>(answer);
  EXPECT_EQ(fit.frames, 1000u);
  EXPECT_NEAR(fit.dt, 0.05, 1e-12);
  EXPECT_EQ(fit.best, 1);
  EXPECT_LE(fit.orders[1].axes[0].q.low, 0.5);
  EXPECT_GE(fit.orders[1].axes[0].q.high, 0.5);
}

}  // namespace
}  // namespace delos::motion
