// σ at the time of use: P(t + lag) against the motion's equation written out here.
#include <gtest/gtest.h>

#include "delos/field/evaluate.h"
#include "delos/field/point.h"
#include "support/rigs.h"

namespace delos {
namespace {

using testing::chain_motion;
using testing::state_at;
using testing::TestLinear;

constexpr double kLag = 0.035;

CoordinateMatrix tied_noise() {
  Eigen::Matrix3d q;
  q << 0.4, 0.1, 0, 0.1, 0.3, -0.05, 0, -0.05, 0.1;
  return q;
}

/// Two devices of 50 Hz (or 50 and 20) that see two and three directions.
System system_of(int order, Fusion fusion, double second_rate = 50) {
  System system;
  system.motion = chain_motion(PoseState::position, order, tied_noise());
  system.fusion = fusion;
  system.markers = {Eigen::Vector3d::Zero()};
  Eigen::MatrixXd two(2, 3);
  two << 1, 0.2, -0.3, 0.1, 0.9, 0.5;
  const auto linear = [](const Eigen::MatrixXd& H, double variance) {
    const Eigen::Index m = H.rows();
    return std::make_shared<TestLinear>(Span::point, H,
                                        variance * Eigen::MatrixXd::Identity(m, m));
  };
  system.devices = {testing::place("a", linear(two, 1e-4), Pose{}, 50),
                    testing::place("b", linear(Eigen::Matrix3d::Identity(), 1e-3),
                                   Pose{}, second_rate)};
  return system;
}

/// x_i after t is Σ_j t^(j−i)/(j−i)! x_j, and what came in since then has the
/// covariance q t^(2k−1−i−j)/((2k−1−i−j)(k−1−i)!(k−1−j)!).
StateMatrix later(const StateMatrix& P, int k, double t) {
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  const int d = 3;
  StateMatrix A = StateMatrix::Zero(d * k, d * k), Q = A;
  for (int i = 0; i < k; ++i)
    for (int j = 0; j < k; ++j) {
      if (j >= i)
        A.block(d * i, d * j, d, d) =
            std::pow(t, j - i) / factorial(j - i) * Eigen::Matrix3d::Identity();
      const int p = 2 * k - 1 - i - j;
      Q.block(d * i, d * j, d, d) =
          tied_noise() *
          (std::pow(t, p) / (p * factorial(k - 1 - i) * factorial(k - 1 - j)));
    }
  return A * P * A.transpose() + Q;
}

double relative(const StateMatrix& a, const StateMatrix& b) {
  return (a - b).norm() / b.norm();
}

class Lag : public ::testing::TestWithParam<int> {};  // the order k

TEST_P(Lag, CarriesEveryCovariance) {
  const int k = GetParam();
  for (const auto& [fusion, rate] :
       {std::pair{Fusion::stacked, 50.0}, std::pair{Fusion::continuous, 20.0},
        std::pair{Fusion::periodic, 20.0}, std::pair{Fusion::sequential, 50.0}}) {
    System system = system_of(k, fusion, rate);
    for (const Solver solver : {Solver::automatic, Solver::doubling}) {
      system.lag = 0;
      const FusedState now = state_at(system, {}, solver);
      system.lag = kLag;
      const FusedState used = state_at(system, {}, solver);
      ASSERT_EQ(used.status, RiccatiStatus::converged);
      EXPECT_LT(relative(used.prior, later(now.prior, k, kLag)), 1e-12);
      EXPECT_LT(relative(used.posterior, later(now.posterior, k, kLag)), 1e-12);
      EXPECT_EQ(used.time_constant, now.time_constant);
      if (now.worst_prior.size() == 0) continue;
      EXPECT_LT(relative(used.worst_prior, later(now.worst_prior, k, kLag)), 1e-12);
      EXPECT_LT(relative(used.best_posterior, later(now.best_posterior, k, kLag)),
                1e-12);
    }
  }
}

/// Fields are worked out 64 poses at a time, by the scalar chains.
TEST_P(Lag, IsInFields) {
  const int k = GetParam();
  System system = testing::acoustic_system();
  system.motion = chain_motion(PoseState::position, k, tied_noise());
  const Samples samples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.4}, 0.2);
  for (const double exposure : {0.0, 0.01})
    for (const CovarianceKind kind :
         {CovarianceKind::prior, CovarianceKind::posterior}) {
      for (PlacedDevice& device : system.devices) device.exposure = exposure;
      system.covariance = kind;
      system.lag = kLag;
      const Metric metric = testing::metric_of(system, "sigma_x");
      const Field field = evaluate_field(system, samples, {}, metric);
      EXPECT_EQ(field.definition.lag, kLag);
      system.lag = 0;
      for (std::size_t i = 0; i < samples.points.size(); ++i) {
        const FusedState now =
            state_at(system, {Eigen::Matrix3d::Identity(), samples.points[i]});
        const double expected = std::sqrt(later(now.covariance(kind), k, kLag)(0, 0));
        EXPECT_NEAR(field.value[i], expected, 1e-10 * expected);
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Orders, Lag, ::testing::Values(1, 2, 3));

/// Searches ask for slopes: central differences, on the reduced and the general path.
TEST(LagOfPoints, HasAdjoints) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const auto random_symmetric = [&](int size) {
    StateMatrix X(size, size);
    for (double& x : X.reshaped()) x = normal(random);
    return StateMatrix(X + X.transpose());
  };
  for (const bool pinned : {false, true})
    for (const int size : {3, 6}) {  // Y of the pose, and of the whole state
      System system = system_of(2, Fusion::stacked);
      system.covariance = CovarianceKind::posterior;
      system.lag = kLag;
      const auto solver = make_smooth_steady_solver(system);
      const StateMatrix X = random_symmetric(3), Y = random_symmetric(size),
                        D = random_symmetric(3);
      const StateMatrix S = 100 * (X * X.transpose() + StateMatrix::Identity(3, 3));
      SteadyEquation at = solver->equation();
      FusedState state;
      const auto solved = [&](const StateMatrix& information) {
        double packed[packed_index(3, 0)];
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j <= i; ++j) packed[packed_index(i, j)] = information(i, j);
        at.clear();
        at.add(0, packed);
        if (pinned) at.add_perfect(0, Eigen::Vector3d(1, 2, -1));
        solver->solve(at, {}, state);
        return state.posterior.topLeftCorner(size, size).cwiseProduct(Y).sum();
      };
      constexpr double kStep = 0.01;
      const double difference =
          (solved(S + kStep * D) - solved(S - kStep * D)) / (2 * kStep);
      solved(S);
      const StateMatrix G = solver->adjoint(at, Y);
      EXPECT_NEAR(G.cwiseProduct(D).sum(), difference, 1e-5 * G.norm() * D.norm());
      EXPECT_GT(G.norm(), 0);
    }
}

/// What is read all the time without noise is known with its velocity, and moves on
/// from there: Q(lag) alone.
TEST(LagOfPoints, MovesWhatIsPinned) {
  System system = system_of(2, Fusion::continuous);
  system.devices[1].device = std::make_shared<TestLinear>(
      Span::point, Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero());
  system.lag = kLag;
  const StateMatrix expected = later(StateMatrix::Zero(6, 6), 2, kLag);
  EXPECT_LT(relative(state_at(system, {}).posterior, expected), 1e-12);
}

/// Direction z is lost, and stays lost; x and y as where nothing is.
TEST(LagOfPoints, LeavesLostDirectionsLost) {
  System system = system_of(2, Fusion::stacked);
  Eigen::MatrixXd H(2, 3);
  H << 1, 0, 0, 0, 1, 0;
  const auto flat =
      std::make_shared<TestLinear>(Span::point, H, 1e-4 * Eigen::Matrix2d::Identity());
  system.motion = chain_motion(PoseState::position, 2, Eigen::Matrix3d::Identity());
  for (PlacedDevice& device : system.devices) device.device = flat;
  const FusedState now = state_at(system, {});
  system.lag = kLag;
  for (const Solver solver : {Solver::spectral, Solver::doubling}) {
    const FusedState used = state_at(system, {}, solver);
    EXPECT_EQ(used.status, RiccatiStatus::unobservable);
    EXPECT_EQ(used.unobservable.cols(), 2);
    const double t = kLag;
    EXPECT_NEAR(used.prior(0, 0),
                now.prior(0, 0) + 2 * t * now.prior(0, 3) + t * t * now.prior(3, 3) +
                    t * t * t / 3,
                1e-12);
    EXPECT_NEAR(used.prior(2, 2), 0, 1e-12);
  }
}

/// The residual is of the equation, whatever becomes of its solution.
TEST(LagOfPoints, LeavesTheResidual) {
  System system = testing::acoustic_system();
  system.lag = kLag;
  const PointReport report =
      evaluate_point(system, {Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.3}},
                     testing::metric_of(system, "eigmax"), Solver::automatic);
  EXPECT_LT(report.residual, 1e-9);
}

TEST(LagOfPoints, IsRefusedWhereItMeansNothing) {
  System system = system_of(2, Fusion::artemis);
  system.lag = kLag;
  EXPECT_THROW((void)make_steady_solver(system), std::invalid_argument);
  system.fusion = Fusion::stacked;
  system.motion.dynamics =
      CustomMotion{StateMatrix::Identity(6, 6), StateMatrix::Identity(6, 6)};
  EXPECT_THROW((void)make_steady_solver(system), std::invalid_argument);
}

}  // namespace
}  // namespace delos
