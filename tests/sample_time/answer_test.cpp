// Optimum, crossover and P∞ over the sample time against closed forms, published
// numbers and brute force.
#include <cmath>
#include <numbers>

#include "scenes.h"
#include "session/sample_time.h"

namespace delos::session {
namespace {

using test::loaded;
using test::plugins;
using test::scene_of;
using test::two_cameras;

LoadedScene shipped(const std::string& name) {
  Diagnostics findings;
  auto scene =
      load(std::string(DELOS_SCENES) + "/" + name + ".yaml", {}, plugins(), findings);
  for (const Diagnostic& finding : findings) ADD_FAILURE() << to_string(finding);
  return scene.value();
}

std::vector<double> steps(double from, double step, int count) {
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(from + step * i);
  return times;
}

/// R = c/τ with c = 1e-9 against q = 0.4 and |h| = 1: by q τ³/12 the least is at
/// (4c/q)^¼ and the crossing at (12c/q)^¼, by q τ³/20 at (20c/3q)^¼ and (20c/q)^¼.
TEST(SampleTimeAnswer, AgreesWithClosedForms) {
  const LoadedScene scene = loaded(scene_of(two_cameras(
      "rate: 20 Hz, exposure: 10 ms, noise_over_time: {law: inverse, at: 10 ms}")));
  SampleTimeQuestion question;
  question.times = usual_times(scene.scene, "");
  EXPECT_NEAR(question.times.back(), 0.05, 1e-12) << "no longer than an update";
  question.motion = MotionTerm::averaged;
  const auto half = answer_sample_time(scene, {0, 0, 0}, question, plugins());
  ASSERT_EQ(half.rows.size(), 4u);  // u and v of two
  for (const SampleTimeRow& row : half.rows) {
    EXPECT_NEAR(row.best, std::pow(4e-9 / 0.4, 0.25), 1e-7);
    EXPECT_NEAR(row.best, 10.000e-3, 5e-7);
    EXPECT_NEAR(*row.crossover, 13.161e-3, 5e-7);
    EXPECT_FALSE(row.at_end);
  }
  question.motion = MotionTerm::exact;
  const auto exact = answer_sample_time(scene, {0, 0, 0}, question, plugins());
  EXPECT_NEAR(exact.rows[0].best, 11.362e-3, 5e-7);
  EXPECT_NEAR(*exact.rows[0].crossover, 14.953e-3, 5e-7);
  EXPECT_NEAR(exact.rows[0].least, 1e-9 / 11.362e-3 + 0.4 * std::pow(11.362e-3, 3) / 20,
              1e-12);
}

/// Fig. 7.7 of the dissertation: crossover 0.993 ms, least 1.5636e-4 at 8 clocks, an
/// update of 0.964 ms; with variances the least is at 0.979 ms.
TEST(SampleTimeAnswer, ShowsThePublishedPhotodiode) {
  const LoadedScene scene = shipped("31-photodiode-window");
  SampleTimeQuestion question;
  question.times = steps(21e-6, 21e-6, 15);
  question.motion = MotionTerm::update;
  question.deviations = true;
  const auto answer = answer_sample_time(scene, {0, 0, 0}, question, plugins());
  const SampleTimeRow& row = answer.rows[0];
  const auto update = [](double tau) { return 628e-6 + 2 * tau; };
  EXPECT_NEAR(update(*row.crossover), 0.993e-3, 5e-7);
  EXPECT_EQ(row.best_drawn, 7u);
  EXPECT_NEAR(update(question.times[row.best_drawn]), 0.964e-3, 1e-9);
  EXPECT_NEAR(row.sum[row.best_drawn], 1.5636e-4, 5e-9);
  EXPECT_NEAR(row.least, 1.5634e-4, 5e-9);
  EXPECT_NEAR(update(row.best), 0.971e-3, 5e-7);
  question.deviations = false;
  const auto variances = answer_sample_time(scene, {0, 0, 0}, question, plugins());
  EXPECT_NEAR(update(variances.rows[0].best), 0.979e-3, 5e-7);
  EXPECT_NEAR(variances.rows[0].least, 1.223e-8, 5e-12);
}

/// Fig. 8 of the paper: least at about 0.4 ms near and 0.8 ms far, whose mean is where
/// Fig. 9 has its least, at about 0.6 ms.
TEST(SampleTimeAnswer, ShowsThePublishedLed) {
  const LoadedScene scene = shipped("32-rotating-led");
  SampleTimeQuestion question;
  question.times = steps(50e-6, 50e-6, 60);
  question.motion = MotionTerm::blur;
  question.speed = 2 * std::numbers::pi * 0.15 / 10;
  question.deviations = true;
  const auto answer = answer_sample_time(scene, {0, 0, 0}, question, plugins());
  ASSERT_EQ(answer.rows.size(), 4u);
  const SampleTimeRow &near = answer.rows[0], &far = answer.rows[2];
  EXPECT_NEAR(near.best, 0.4e-3, 2e-6);
  EXPECT_NEAR(far.best, 0.8e-3, 4e-6);
  EXPECT_NEAR((near.best + far.best) / 2, 0.6e-3, 4e-6);
  // 218.33 and 117.56 px/s of blur; cameras read images of focal length 1.
  const double f = 6e-3 / 7.4e-6;
  EXPECT_NEAR(f * near.motion[0] / question.times[0], 218.33, 0.01);
  EXPECT_NEAR(f * far.motion[0] / question.times[0], 117.56, 0.01);
}

/// Table 6.2 with R that follows: P∞ is worse for windows shorter and longer than the
/// best. Expected: every sample time by itself, and a scan.
TEST(SampleTimeAnswer, FindsTheBestOfPInfinity) {
  const LoadedScene scene = shipped("30-averaged-speakers");
  SampleTimeQuestion question;
  question.times = usual_times(scene.scene, "");
  const auto answer = answer_sample_time(scene, {0, 0, 0}, question, plugins());
  EXPECT_FALSE(answer.at_end);
  EXPECT_GT(answer.metric.front(), 1.2 * answer.least);
  EXPECT_GT(answer.metric.back(), 1.2 * answer.least);
  const auto value_at = [&](double tau) {
    Scene changed = scene.scene;
    for (DeviceEntry& device : changed.devices) {
      device.exposure = tau;
      device.timing.reset();
      device.rate = 1 / (tau + 5e-3);
      device.noise_over_time.reset();
      // Of R = r z², so that r follows.
      std::get<double>(device.params.edit("r")) = 0.005 * 10e-3 / tau;
    }
    Samples one;
    one.points = {Eigen::Vector3d::Zero()};
    one.parts = {{"", 0, 1, ScatteredShape{}}};
    return evaluate_field(build_system(changed, plugins()), one, {}, scene.metric)
        .value[0];
  };
  EXPECT_NEAR(answer.least, value_at(answer.best), 1e-9 * answer.least);
  for (const std::size_t i : {0u, 40u, 80u})
    EXPECT_NEAR(answer.metric[i], value_at(question.times[i]), 1e-9 * answer.metric[i]);
  for (double tau = 1e-3; tau < 0.1; tau *= 1.05)
    EXPECT_GE(value_at(tau), answer.least * (1 - 1e-12));
  // The rule of thumb costs something, and says how much.
  EXPECT_NEAR(answer.rows[0].metric_at_best, value_at(answer.rows[0].best),
              1e-9 * answer.least);
  EXPECT_GE(answer.rows[0].metric_at_best, answer.least);
  ASSERT_EQ(answer.of_motion.size(), 5u);
  EXPECT_NEAR(answer.of_motion[2].best, answer.best, 1e-4 * answer.best);
  for (std::size_t i = 1; i < 5; ++i)
    EXPECT_LT(answer.of_motion[i].best, answer.of_motion[i - 1].best)
        << "the livelier, the shorter";
}

/// One device alone would have another rate than the rest.
TEST(SampleTimeAnswer, IsRefusedWhereRatesWouldPart) {
  const LoadedScene scene = shipped("30-averaged-speakers");
  SampleTimeQuestion question;
  question.times = steps(1e-3, 1e-3, 5);
  question.device = "s1";
  EXPECT_THROW((void)answer_sample_time(scene, {0, 0, 0}, question, plugins()),
               std::invalid_argument);
}

TEST(SampleTimeAnswer, IsRefusedWhereNothingIsAsked) {
  const LoadedScene scene = loaded(scene_of(two_cameras("rate: 20 Hz")));
  SampleTimeQuestion question;
  question.times = steps(1e-3, 1e-3, 5);
  EXPECT_THROW((void)answer_sample_time(scene, {0, 0, 0}, question, plugins()),
               std::invalid_argument);
  question.device = "c";
  EXPECT_THROW((void)answer_sample_time(scene, {0, 0, 0}, question, plugins()),
               std::invalid_argument);
  question.device = "a";
  question.times = {1e-3, 2e-3};
  EXPECT_THROW((void)answer_sample_time(scene, {0, 0, -5}, question, plugins()),
               std::invalid_argument)
      << "nothing is seen there";
}

}  // namespace
}  // namespace delos::session
