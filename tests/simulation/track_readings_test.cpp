// A filter on readings that were recorded, against a textbook's and P∞.
#include "delos/simulation/track_readings.h"

#include <Eigen/LU>

#include "simulation/simulated.h"

namespace delos::test {
namespace {

TimedReading reading_of(double t, int device, double z) {
  TimedReading timed;
  timed.t = t;
  timed.reading = {device, 0, 0, {0, 6}, {}};
  timed.reading.z.setConstant(1, z);
  return timed;
}

System three_axes() {
  return moving(2, {axis(0, 1e-3, 50), axis(1, 4e-3, 50), axis(2, 1e-3, 50)});
}

/// Times that aren't a scene's rate, two readings together, in plain matrices.
TEST(TrackReadings, AreATextbooksKalmanFilter) {
  const System system = three_axes();
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::vector<TimedReading> readings;
  double t = 0;
  for (int i = 0; i < 60; ++i) {
    if (i % 4 != 1) t += 0.01 + 0.02 * (i % 3);
    readings.push_back(reading_of(t, i % 3, 50 + normal(random)));
  }
  const auto track = track_readings(system, {kOrigin, 2, 0.5}, readings,
                                    *make_filter(FilterKind::extended));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(6);
  Eigen::MatrixXd P = Eigen::MatrixXd::Zero(6, 6);
  P.diagonal() << 4, 4, 4, 0.25, 0.25, 0.25;
  const double q[] = {0.4, 0.4, 0.1}, r[] = {1e-3, 4e-3, 1e-3};
  std::size_t next = 0;
  for (const TrackedInstant& at : track) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(6, 6),
                    Q = Eigen::MatrixXd::Zero(6, 6);
    for (int k = 0; k < 3; ++k) {
      const double dt = at.gap;
      A(k, k + 3) = dt;
      Q(k, k) = q[k] * dt * dt * dt / 3;
      Q(k, k + 3) = Q(k + 3, k) = q[k] * dt * dt / 2;
      Q(k + 3, k + 3) = q[k] * dt;
    }
    x = (A * x).eval();
    P = (A * P * A.transpose() + Q).eval();
    for (; next < readings.size() && readings[next].t == at.t; ++next) {
      const int k = readings[next].reading.device;
      // An axis reads from the device, 50 m off.
      const double left = readings[next].reading.z(0) - (x(k) - 50), s = P(k, k) + r[k];
      const Eigen::VectorXd K = P.col(k) / s;
      x += K * left;
      P -= (K * P.row(k)).eval();
    }
    EXPECT_LT((at.x - x).norm(), 1e-9 * (1 + x.norm()));
    EXPECT_LT((at.P - P).norm(), 1e-9);
  }
  EXPECT_EQ(next, readings.size());
  EXPECT_LT(track.size(), readings.size());
}

/// Regular ones settle at P∞, and after a gap it knows as little as the motion says.
TEST(TrackReadings, SettleAtPInfinityAndCoastOverGaps) {
  const System system = three_axes();
  std::vector<TimedReading> readings;
  for (int i = 0; i < 200; ++i)
    for (int k = 0; k < 3; ++k) readings.push_back(reading_of(0.02 * i, k, -50));
  readings.push_back(reading_of(0.02 * 199 + 3, 0, -50));
  const auto track = track_readings(system, {kOrigin, 1, 1}, readings,
                                    *make_filter(FilterKind::extended));
  ASSERT_EQ(track.size(), 201u);
  const StateMatrix steady = state_at(system, kOrigin).posterior;
  EXPECT_LT((track[199].P - steady).norm(), 1e-6 * steady.norm());
  EXPECT_DOUBLE_EQ(track[200].gap, 3);
  const MotionStep step = discretize(system.motion, 3);
  const StateMatrix coasted = step.A * steady * step.A.transpose() + step.Q;
  EXPECT_NEAR(track[200].P(1, 1), coasted(1, 1), 1e-6 * coasted(1, 1));
}

TEST(TrackReadings, RefuseTimesThatFallAndMotionsOfOneUpdate) {
  System system = three_axes();
  const auto filter = make_filter(FilterKind::extended);
  EXPECT_THROW(static_cast<void>(track_readings(
                   system, {kOrigin, 1, 1},
                   {reading_of(1, 0, 0), reading_of(0.5, 1, 0)}, *filter)),
               std::invalid_argument);
  system.motion.dynamics =
      CustomMotion{StateMatrix::Identity(6, 6), StateMatrix::Identity(6, 6)};
  EXPECT_THROW(static_cast<void>(track_readings(system, {kOrigin, 1, 1},
                                                {reading_of(1, 0, 0)}, *filter)),
               std::invalid_argument);
}

}  // namespace
}  // namespace delos::test
