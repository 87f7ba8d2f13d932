// Rotation and translation apart, joint, and with an inertial sensor.
#include "delos/rigid_body/comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "delos/rigid_body/apart.h"
#include "delos/rigid_body/refine.h"

namespace delos::rigid_body {
namespace {

const ComparedMotion& motion_named(const char* name) {
  for (const ComparedMotion& motion : compared_motions())
    if (motion.name == name) return motion;
  throw std::logic_error(name);
}

/// What it filters is a line and a parabola: of exact poses it has them exactly.
TEST(Apart, FindsTheMotionOfExactPoses) {
  ApartFilter filter({1e-4, 1e-4, 1e-4, 1e-12, 1e-12});
  const Eigen::Vector3d w(0.5, -0.2, 1), v(0.3, 0.1, -0.2), a(0.5, 1, -0.5);
  const auto at = [&](double t) {
    return BodyPose{turned_by(t * w), t * v + t * t / 2 * a};
  };
  const double dt = 0.05;
  for (int k = 1; k <= 40; ++k) filter.frame(dt, at((k - 1) * dt), at(k * dt));
  const BodyPose shown = filter.moved(dt, 0.1, at(2)), is = at(2.1);
  EXPECT_LT((shown.t - is.t).norm(), 1e-5);
  EXPECT_LT((shown.R - is.R).norm(), 1e-6);
}

/// p″ by differences of Theorem 1: read so, it changes nothing of a filter that has the
/// motion; off by something, it moves the acceleration there. And so does a gyroscope.
TEST(Joint, TakesInAnInertialSensorAtItsPlace) {
  BodyState s{{0.3, -0.2, 0.9}, {1, 2, -1}, {0.5, -0.4, 0.2}};
  const double dt = 0.05, h = 1e-4;
  BodyFilter filter({1e-4, 1e-8, 1e-4, 1e-10});
  BodyPoints before = unit_points({}), after = before;
  for (int k = 0; k < 30; ++k) {
    before = after;
    after = moved(s, dt, before);
    filter.frame(dt, before, after);
    if (k < 29) s.v += dt * s.a;
  }
  const auto at = [&](double t) { return moved(s, t, before[1]); };
  const Eigen::Vector3d second = (at(dt + h) - 2 * at(dt) + at(dt - h)) / (h * h);
  const BodyState had = filter.state();
  ASSERT_LT((had.a - s.a).norm(), 1e-3);
  BodyFilter told = filter;
  told.accelerometer(dt, at(dt), second, 1e-6);
  told.gyroscope(s.omega, 1e-6);
  EXPECT_LT((told.state().a - had.a).norm(), 2e-3);
  EXPECT_LT((told.state().omega - s.omega).norm(), 1e-4);
  const Eigen::Vector3d more(0.3, 0.2, -0.5);
  filter.accelerometer(dt, at(dt), second + more, 1e-9);
  EXPECT_LT((filter.state().a - had.a - more).norm(), 0.02);
  filter.gyroscope(s.omega + more, 1e-12);
  EXPECT_LT((filter.state().omega - s.omega - more).norm(), 0.02);
}

/// What docs/rigid-body-filter.md says of the comparison, over three seconds of it:
/// with variances near the best ones.
TEST(Comparison, JointAboutTheBodyIsAsGoodAsApartAndAboutTheFloorWorse) {
  const MeasuredRun run = measured_run(motion_named("swing"), 60, 1 / 30., 3, 1);
  EXPECT_EQ(run.lost, 0u);
  const Tuning tuning{{-1.5, -4, -0.5, -4, -2}};
  const auto error = [&](Formulation f, bool inertial = false) {
    return pixel_error(run, f, inertial, tuning);
  };
  const double apart = error(Formulation::apart);
  EXPECT_GT(error(Formulation::none), 3 * apart);
  EXPECT_NEAR(error(Formulation::joint_about_body) / apart, 1, 0.1);
  EXPECT_GT(error(Formulation::joint), 1.05 * apart);
  EXPECT_LT(error(Formulation::apart, true), 0.7 * apart);
}

TEST(Comparison, TuningFindsNoWorseThanItsStart) {
  const std::vector<MeasuredRun> runs = {
      measured_run(motion_named("look about"), 30, 1 / 30., 2, 5)};
  for (const Formulation f : {Formulation::apart, Formulation::joint_about_body})
    EXPECT_LT(pixel_error(runs[0], f, false, tuned(runs, f, false)),
              pixel_error(runs[0], f, false, {}));
}

}  // namespace
}  // namespace delos::rigid_body
