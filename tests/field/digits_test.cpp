// Readings that differ much in what they know: P∞ against the same equations in numbers
// of 50 digits, which lose none. Fault 21: noise of 1e-14 beside one of 1.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <random>

#include "delos/field/point.h"
#include "delos/rig/schedule.h"
#include "support/rigs.h"

namespace delos {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

Matrix identity(Eigen::Index n) { return Matrix::Identity(n, n); }

/// What updates in a row make of a covariance: Π ↦ H + A Π (I + G Π)⁻¹ Aᵀ.
struct Map {
  Matrix A, G, H;
};

Map then(const Map& first, const Map& second) {
  const Matrix W = (identity(first.A.rows()) + first.H * second.G).inverse();
  return {second.A * W * first.A,
          first.G + first.A.transpose() * second.G * W * first.A,
          second.H + second.A * W * first.H * second.A.transpose()};
}

Matrix fixed_point(Map map) {
  for (int doubling = 0; doubling < 80; ++doubling) {
    const Matrix before = map.H;
    map = then(map, map);
    if ((map.H - before).norm() <= Real(1e-40) * map.H.norm()) break;
  }
  return map.H;
}

/// One instant of a cycle: the motion up to it, and S = Σ hᵀh/r.
struct Step {
  Matrix A, Q, S;

  [[nodiscard]] Matrix prior(const Matrix& before) const {
    return A * before * A.transpose() + Q;
  }
  [[nodiscard]] Matrix posterior(const Matrix& prior) const {
    return (identity(prior.rows()) + prior * S).inverse() * prior;
  }
  [[nodiscard]] Map map() const {
    const Matrix W = (identity(A.rows()) + Q * S).inverse();
    return {W * A, A.transpose() * S * W * A, W * Q};
  }
};

/// A reading of the state: z = h x + v, v ~ N(0, r).
struct Reading {
  Eigen::RowVectorXd h;
  double r;
};

Matrix information(const Reading& reading) {
  const Matrix h = reading.h.cast<Real>();
  return h.transpose() * h / Real(reading.r);
}

class Digits : public ::testing::TestWithParam<int> {
 protected:
  /// Devices of one reading each. @param columns of h: of the whole state, or 3
  System drawn(int order, int columns, Fusion fusion) {
    std::mt19937_64 random(static_cast<std::uint64_t>(GetParam()));
    std::uniform_real_distribution<double> entry(-1, 1), digits(-14, 0);
    System system;
    system.motion =
        testing::chain_motion(PoseState::position, order, Eigen::Matrix3d::Identity());
    system.markers = {Eigen::Vector3d::Zero()};
    system.fusion = fusion;
    const double rates[] = {50, 25, 100, 50, 100};
    for (int d = 0; d < 5; ++d) {
      Reading reading{Eigen::RowVectorXd::Zero(columns), std::pow(10, digits(random))};
      for (double& h : reading.h) h = entry(random);
      const bool one_rate = fusion == Fusion::stacked;
      system.devices.push_back(testing::place(
          "d" + std::to_string(d),
          std::make_shared<testing::TestLinear>(
              columns == 3 ? Span::point : Span::state, Eigen::MatrixXd(reading.h),
              Eigen::MatrixXd::Constant(1, 1, reading.r)),
          Pose{Eigen::Matrix3d::Identity(), {7, 8, 9}}, one_rate ? 50 : rates[d]));
      readings_.push_back(reading);
    }
    return system;
  }

  /// The steps of a system's cycle; the information stands in the first states.
  [[nodiscard]] std::vector<Step> steps_of(const System& system) const {
    const Eigen::Index n = system.motion.layout.size();
    std::vector<UpdateSlot> slots;
    if (system.fusion == Fusion::stacked)
      slots = {{system.devices.front().period, {0, 1, 2, 3, 4}}};
    else
      slots = std::get<std::vector<UpdateSlot>>(update_cycle(system));
    std::vector<Step> steps;
    for (const UpdateSlot& slot : slots) {
      const MotionStep motion = discretize(system.motion, slot.interval);
      Step step{motion.A.cast<Real>(), motion.Q.cast<Real>(), Matrix::Zero(n, n)};
      for (const int d : slot.devices) {
        const Matrix S = information(readings_[static_cast<std::size_t>(d)]);
        step.S.topLeftCorner(S.rows(), S.cols()) += S;
      }
      steps.push_back(step);
    }
    return steps;
  }

  /// Priors and posteriors of the steps; checked to return to themselves.
  static void solve(const std::vector<Step>& steps, std::vector<Matrix>& priors,
                    std::vector<Matrix>& posteriors) {
    Map map = steps.front().map();
    for (std::size_t s = 1; s < steps.size(); ++s) map = then(map, steps[s].map());
    const Matrix begin = fixed_point(map);
    Matrix Pi = begin;
    for (const Step& step : steps) {
      priors.push_back(step.prior(Pi));
      posteriors.push_back(Pi = step.posterior(priors.back()));
    }
    ASSERT_LT((Pi - begin).norm(), Real(1e-25) * begin.norm());
  }

  std::vector<Reading> readings_;
};

/// Entry by entry, in standard deviations.
void expect_equal(const StateMatrix& P, const Matrix& expected, const char* what) {
  for (Eigen::Index i = 0; i < P.rows(); ++i)
    for (Eigen::Index j = 0; j <= i; ++j) {
      const double scale =
          std::sqrt(static_cast<double>(Real(expected(i, i) * expected(j, j))));
      EXPECT_NEAR(P(i, j) / scale, static_cast<double>(expected(i, j)) / scale, 1e-9)
          << what << " " << i << ", " << j;
    }
}

TEST_P(Digits, AreKeptByStackedFusion) {
  const System system =
      drawn(1 + GetParam() % 2, 3 * (1 + GetParam() % 2), Fusion::stacked);
  std::vector<Matrix> priors, posteriors;
  solve(steps_of(system), priors, posteriors);
  const FusedState state = testing::state_at(system, {}, Solver::doubling);
  ASSERT_EQ(state.status, RiccatiStatus::converged);
  expect_equal(state.prior, priors[0], "prior");
  expect_equal(state.posterior, posteriors[0], "posterior");
}

TEST_P(Digits, AreKeptByPeriodicFusion) {
  const System system = drawn(2, 6, Fusion::periodic);
  const std::vector<Step> steps = steps_of(system);
  std::vector<Matrix> priors, posteriors;
  solve(steps, priors, posteriors);
  // The trapezoid rule over the cycle.
  const auto slots = std::get<std::vector<UpdateSlot>>(update_cycle(system));
  Matrix mean = Matrix::Zero(6, 6);
  Real length = 0;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    const Real dt = slots[s].interval;
    mean += dt / 2 * (posteriors[(s + steps.size() - 1) % steps.size()] + priors[s]);
    length += dt;
  }
  const FusedState state = testing::state_at(system, {});
  ASSERT_EQ(state.status, RiccatiStatus::converged);
  expect_equal(state.prior, mean / length, "mean");
}

TEST_P(Digits, AreKeptBySequentialFusion) {
  const System system = drawn(2, 6, Fusion::sequential);
  const std::vector<Step> steps = steps_of(system);
  std::vector<Matrix> priors, posteriors;
  solve(steps, priors, posteriors);
  Matrix prior = Matrix::Zero(6, 6), posterior = prior;
  for (std::size_t s = 0; s < steps.size(); ++s) {
    prior += priors[s] / Real(static_cast<double>(steps.size()));
    posterior += posteriors[s] / Real(static_cast<double>(steps.size()));
  }
  const FusedState state = testing::state_at(system, {});
  ASSERT_EQ(state.status, RiccatiStatus::converged);
  expect_equal(state.prior, prior, "prior");
  expect_equal(state.posterior, posterior, "posterior");
}

// F P + P Fᵀ + Q − P S P = 0 by the map of a Cayley transform (Chu, Fan, Lin 2005), and
// put into the equation.
TEST_P(Digits, AreKeptByContinuousFusion) {
  const System system = drawn(2, 6, Fusion::continuous);
  const MotionStep form = continuous_form(system.motion);
  const Matrix F = form.A.cast<Real>(), Q = form.Q.cast<Real>();
  Matrix S = Matrix::Zero(6, 6);
  for (std::size_t d = 0; d < readings_.size(); ++d)
    S += information(readings_[d]) / Real(system.devices[d].period);
  const Real gamma = 1000;
  const Matrix A = F.transpose() - gamma * identity(6), inverse = A.inverse(),
               W = (A.transpose() + Q * inverse * S).inverse();
  const Matrix P =
      fixed_point({identity(6) + 2 * gamma * W, 2 * gamma * inverse * S * W,
                   2 * gamma * W * Q * inverse});
  const Matrix left = F * P + P * F.transpose() + Q - P * S * P;
  ASSERT_LT(left.norm(), Real(1e-20) * Q.norm());
  const FusedState state = testing::state_at(system, {});
  ASSERT_EQ(state.status, RiccatiStatus::converged);
  expect_equal(state.prior, P, "P");
}

// The field reduces to scalar chains in lanes; where the sum of all information has
// lost its digits it goes back to the readings, of which `point` always is.
TEST_P(Digits, AreKeptByFields) {
  const System system = drawn(2, 3, Fusion::stacked);
  std::vector<Matrix> priors, posteriors;
  solve(steps_of(system), priors, posteriors);
  const Metric metric = testing::metric_of(system, "eigmax");
  const Eigen::Matrix3d P = priors[0].topLeftCorner(3, 3).cast<double>();
  const double expected =
      std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(P).eigenvalues()(2));
  const Field field = evaluate_field(system, testing::points({{0, 0, 0}}), {}, metric);
  EXPECT_TRUE(field.observable[0]);
  EXPECT_NEAR(field.value[0] / expected, 1, 1e-9);
  const double closely = std::sqrt(
      evaluate_point(system, {}, metric).state.prior.topLeftCorner(3, 3).trace());
  EXPECT_NEAR(closely / std::sqrt(P.trace()), 1, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Drawn, Digits, ::testing::Range(1, 13));

}  // namespace
}  // namespace delos
