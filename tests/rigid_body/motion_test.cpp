// Theorem 1 against its own integrals and differences, near rest and far from it.
#include "delos/rigid_body/motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "delos/rigid_body/filter.h"

namespace delos::rigid_body {
namespace {

const Eigen::Vector3d kAxis = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
const double kAngles[] = {0,   1e-12, 1e-9, 1e-6, 1e-4,  1e-3,  0.01, 0.1, 0.7,
                          1.5, 2.5,   3,    3.9,  3.999, 4.001, 5,    9};

TEST(BodyMotion, TurnsByTheExponentialMap) {
  for (const double angle : kAngles) {
    const double dt = 0.8;
    const BodyMotion m = body_motion(angle / dt * kAxis, dt);
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, kAxis).toRotationMatrix();
    EXPECT_LT((m.W - R).norm(), 3e-15 * (1 + angle)) << angle;
  }
}

/// V = ∫ W dt, A = ∫ V dt, by five Gauss nodes in each of 20 parts.
TEST(BodyMotion, HoldsItsIntegrals) {
  const double nodes[] = {0, 0.5384693101056831, -0.5384693101056831,
                          0.9061798459386640, -0.9061798459386640};
  const double weights[] = {0.5688888888888889, 0.4786286704993665, 0.4786286704993665,
                            0.2369268850561891, 0.2369268850561891};
  for (const double angle : kAngles) {
    const double dt = 0.8;
    const Eigen::Vector3d w = angle / dt * kAxis;
    Eigen::Matrix3d V = Eigen::Matrix3d::Zero(), A = V;
    for (int part = 0; part < 20; ++part)
      for (int k = 0; k < 5; ++k) {
        const double t = dt / 20 * (part + (1 + nodes[k]) / 2);
        const BodyMotion m = body_motion(w, t);
        V += weights[k] / 2 * dt / 20 * m.W;
        A += weights[k] / 2 * dt / 20 * m.V;
      }
    const BodyMotion m = body_motion(w, dt);
    EXPECT_LT((m.V - V).norm(), 1e-13) << angle;
    EXPECT_LT((m.A - A).norm(), 1e-13) << angle;
  }
}

TEST(BodyMotion, SlopesEqualDifferences) {
  const Eigen::Vector3d p(1.1, -0.7, 0.4), v(0.2, 0.9, -1.3), a(-0.8, 0.3, 0.6);
  const double dt = 0.8, h = 1e-5;
  for (const double angle : kAngles) {
    const Eigen::Vector3d w = angle / dt * kAxis;
    const BodyMotionSlopes by = body_motion_slopes(w, dt, p, v, a);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(k);
      const BodyMotion up = body_motion(w + step, dt), down = body_motion(w - step, dt);
      EXPECT_LT(((up.W - down.W) * p / (2 * h) - by.W.col(k)).norm(), 5e-10) << angle;
      EXPECT_LT(((up.V - down.V) * v / (2 * h) - by.V.col(k)).norm(), 5e-10) << angle;
      EXPECT_LT(((up.A - down.A) * a / (2 * h) - by.A.col(k)).norm(), 5e-10) << angle;
    }
  }
}

/// The paper's limits at rest: −Δt P̃, −Δt²/2 ṽ, −Δt³/6 ã.
TEST(BodyMotion, SlopesHaveThePapersLimitsAtRest) {
  const Eigen::Vector3d p(1.1, -0.7, 0.4), v(0.2, 0.9, -1.3), a(-0.8, 0.3, 0.6);
  const double dt = 0.8;
  for (const double rate : {0.0, 1e-12}) {
    const BodyMotionSlopes by = body_motion_slopes(rate * kAxis, dt, p, v, a);
    EXPECT_LT((by.W + dt * skew(p)).norm(), 1e-11);
    EXPECT_LT((by.V + dt * dt / 2 * skew(v)).norm(), 1e-11);
    EXPECT_LT((by.A + dt * dt * dt / 6 * skew(a)).norm(), 1e-11);
  }
}

/// The bracket as printed, −ω̃ p̃, isn't the derivative: off by 0.23 in W, as was
/// computed independently of this program for |ω| ≈ 0.7 and Δt = 0.8.
TEST(BodyMotion, SlopesAreNotThosePrinted) {
  const Eigen::Vector3d w = 0.7 * kAxis, p(1.1, -0.7, 0.4);
  const double dt = 0.8, theta = w.norm();
  const double c2 = (1 - std::cos(theta * dt)) / (theta * theta);
  const Eigen::Matrix3d printed = -skew(w) * skew(p), right = -skew(w.cross(p));
  EXPECT_GT((c2 * (printed - right)).cwiseAbs().maxCoeff(), 0.05);
}

/// Where a point is by small steps of p' = ω × p + v + a t.
TEST(BodyMotion, SolvesItsDifferentialEquation) {
  const BodyState s{{0.3, -0.2, 0.9}, {1, 2, -1}, {0.5, -0.4, 0.2}};
  const double dt = 1.3;
  const int steps = 2000;
  const auto rate = [&](double t, const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return s.omega.cross(p) + s.v + t * s.a;
  };
  Eigen::Vector3d p(0.4, 0.1, -0.7);
  const Eigen::Vector3d start = p;
  const double h = dt / steps;
  for (int i = 0; i < steps; ++i) {  // Runge–Kutta of fourth order
    const double t = i * h;
    const Eigen::Vector3d k1 = rate(t, p), k2 = rate(t + h / 2, p + h / 2 * k1),
                          k3 = rate(t + h / 2, p + h / 2 * k2),
                          k4 = rate(t + h, p + h * k3);
    p += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  EXPECT_LT((moved(s, dt, start) - p).norm(), 1e-11);
}

TEST(BodyFilter, ResidualHasItsSlope) {
  const BodyState s{{0.3, -0.2, 0.9}, {1, 2, -1}, {0.5, -0.4, 0.2}};
  const BodyPoints before = unit_points({}),
                   after = unit_points({skew({1, 2, 3}), {4, 5, 6}});
  const PointResidual at = point_residual(s, 0.7, before, after);
  for (int k = 0; k < 9; ++k) {
    const double h = 1e-5;
    const auto moved_by = [&](double step) {
      BodyState m = s;
      Eigen::Vector3d* part[] = {&m.omega, &m.v, &m.a};
      (*part[k / 3])(k % 3) += step;
      return point_residual(m, 0.7, before, after).f;
    };
    EXPECT_LT(((moved_by(h) - moved_by(-h)) / (2 * h) - at.slope.col(k)).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace delos::rigid_body
