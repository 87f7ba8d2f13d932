// Fusion at the level of systems: the modes, the paths and what no device sees.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <stdexcept>

#include "support/rigs.h"

namespace delos {
namespace {

using testing::state_at;
using testing::TestLinear;

double smallest_eigenvalue(const StateMatrix& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues()(0);
}

/// Three coordinates measured directly by devices of the given (period, variance).
System direct_system(const std::vector<std::pair<double, double>>& devices, double q) {
  System system;
  system.motion =
      testing::chain_motion(PoseState::position, 2, q * Eigen::Matrix3d::Identity());
  system.markers = {Eigen::Vector3d::Zero()};
  for (const auto& [period, variance] : devices) {
    const Eigen::Matrix3d H = Eigen::Matrix3d::Identity();
    system.devices.push_back(
        testing::place("d", std::make_shared<TestLinear>(Span::point, H, variance * H),
                       Pose{}, 1 / period));
    system.devices.back().period = period;
  }
  return system;
}

double millimetres(double variance) { return 1000 * std::sqrt(variance); }

struct FusionRow {
  std::vector<std::pair<double, double>> devices;    // period [s], variance [m²]
  double artemis, continuous, average, worst, best;  // standard deviations, mm
};

// Source of the numbers: an explicit filter recursion, 1-D PV with q = 0.3 m²/s³; the
// table of docs/theory.md, "Several devices, several rates", to its printed digits.
class FusionTable : public ::testing::TestWithParam<FusionRow> {};

TEST_P(FusionTable, IsReproduced) {
  const FusionRow& row = GetParam();
  System system = direct_system(row.devices, 0.3);

  system.fusion = Fusion::artemis;
  EXPECT_NEAR(millimetres(state_at(system, {}).prior(0, 0)), row.artemis, 5.1e-5);
  system.fusion = Fusion::continuous;
  EXPECT_NEAR(millimetres(state_at(system, {}).prior(0, 0)), row.continuous, 5.1e-5);
  system.fusion = Fusion::periodic;
  const FusedState periodic = state_at(system, {});
  EXPECT_NEAR(millimetres(periodic.prior(0, 0)), row.average, 5.1e-5);
  EXPECT_EQ(periodic.prior, periodic.posterior);
  EXPECT_NEAR(millimetres(periodic.worst_prior(0, 0)), row.worst, 5.1e-5);
  EXPECT_NEAR(millimetres(periodic.best_posterior(0, 0)), row.best, 5.1e-5);
}

INSTANTIATE_TEST_SUITE_P(
    Table, FusionTable,
    ::testing::Values(
        FusionRow{
            {{0.02, 1e-3}, {0.02, 1e-3}}, 19.1714, 13.6426, 13.8003, 15.0164, 12.4662},
        FusionRow{
            {{0.02, 1e-3}, {0.05, 1e-4}}, 14.9139, 9.6754, 10.1205, 12.7200, 7.6292},
        FusionRow{
            {{0.001, 1e-6}, {0.033, 1e-5}}, 1.6885, 0.4309, 0.4322, 0.4523, 0.4086}));

TEST(Fusion, StackedIsTheWorstPriorOfEqualRates) {
  System system = direct_system({{0.02, 1e-3}, {0.02, 1e-3}}, 0.3);
  system.fusion = Fusion::stacked;
  EXPECT_NEAR(millimetres(state_at(system, {}).prior(0, 0)), 15.0164, 5.1e-5);
}

// One device per update that measures everything, in turns of equal length, is one
// device at that rate: the sequential cycle of two equal devices equals the stacked one
// of one.
TEST(Fusion, SequentialTurnsOfEqualDevicesAreOneDevice) {
  System turns = direct_system({{0.02, 1e-3}, {0.02, 1e-3}}, 0.3);
  turns.fusion = Fusion::sequential;
  const FusedState a = state_at(turns, {});
  const FusedState b = state_at(direct_system({{0.02, 1e-3}}, 0.3), {});
  EXPECT_LT((a.prior - b.prior).norm(), 1e-12 * b.prior.norm());
  EXPECT_LT((a.posterior - b.posterior).norm(), 1e-12 * b.posterior.norm());
  // The cycle's pole is squared over twice the time: the same time constant.
  EXPECT_NEAR(a.time_constant, b.time_constant, 1e-9 * b.time_constant);
}

TEST(Fusion, AllSolversAgreeOnTheAcousticTracker) {
  const System system = testing::acoustic_system();
  for (const double z : {0.0, 0.3, 0.8}) {
    const TargetPose pose{Eigen::Matrix3d::Identity(), {0.1, 0.3, z}};
    const FusedState a = state_at(system, pose, Solver::spectral);
    const FusedState b = state_at(system, pose, Solver::doubling);
    const FusedState c = state_at(system, pose, Solver::eigenvector);
    EXPECT_LT((a.prior - b.prior).norm(), 1e-11 * b.prior.norm());
    EXPECT_LT((a.posterior - b.posterior).norm(), 1e-11 * b.posterior.norm());
    EXPECT_LT((a.prior - c.prior).norm(), 1e-9 * b.prior.norm());
    EXPECT_NEAR(a.time_constant, b.time_constant, 1e-8 * b.time_constant);
  }
}

TEST(Fusion, OneMoreDeviceNeverHurts) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 0.4);
  for (int i = 0; i < 50; ++i) {
    System system = testing::acoustic_system();
    const TargetPose pose{Eigen::Matrix3d::Identity(),
                          {uniform(random), uniform(random), 2 * uniform(random)}};
    const StateMatrix before = state_at(system, pose).prior;
    system.devices.push_back(testing::place(
        "more", std::make_shared<testing::TestRange>(0.02),
        {Eigen::Matrix3d::Identity(), {1, uniform(random), uniform(random)}}, 50));
    const StateMatrix after = state_at(system, pose).prior;
    EXPECT_GE(smallest_eigenvalue(before - after), -1e-12 * before.norm());
    EXPECT_LT(after.trace(), before.trace());
  }
}

/// Acts with G on every 3-block of the state.
StateMatrix congruent(const StateMatrix& P, const Eigen::Matrix3d& G) {
  StateMatrix B = StateMatrix::Zero(P.rows(), P.cols());
  for (Eigen::Index i = 0; i < P.rows(); i += 3) B.block<3, 3>(i, i) = G;
  return B * P * B.transpose();
}

TEST(Fusion, RotatingTheWholeSceneRotatesP) {
  std::mt19937_64 random(11);
  const System system = testing::acoustic_system();
  const TargetPose pose{Eigen::Matrix3d::Identity(), {0.05, 0.31, 0.4}};
  const FusedState still = state_at(system, pose);
  for (int i = 0; i < 20; ++i) {
    const Pose turn{testing::random_rotation(random), {1, -2, 3}};
    System turned = system;
    auto& q = std::get<ChainMotion>(turned.motion.dynamics).q;
    q = (turn.R * q * turn.R.transpose()).eval();
    for (PlacedDevice& d : turned.devices) d.X_WS() = turn * d.X_WS();
    const FusedState moved = state_at(turned, turn * pose);
    const StateMatrix expected = congruent(still.prior, turn.R);
    EXPECT_LT((moved.prior - expected).norm(), 1e-11 * expected.norm());
  }
}

TEST(Fusion, ScalingEveryNoiseScalesP) {
  System system = testing::acoustic_system();
  const TargetPose pose{Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.3}};
  const StateMatrix before = state_at(system, pose).prior;
  const double factor = 37;
  std::get<ChainMotion>(system.motion.dynamics).q *= factor;
  for (PlacedDevice& d : system.devices) {
    d.device = std::make_shared<testing::TestRange>(0.005 * factor);
  }
  const StateMatrix after = state_at(system, pose).prior;
  EXPECT_LT((after - factor * before).norm(), 1e-12 * after.norm());
}

// Two ranges leave the direction perpendicular to their plane unseen. The plane's own
// finite values are those of the two-dimensional problem, solved here by doubling.
TEST(Fusion, NamesTheLostDirectionAndKeepsTheRest) {
  System system = testing::acoustic_system();
  system.devices = {testing::place("a", std::make_shared<testing::TestRange>(0.005),
                                   {Eigen::Matrix3d::Identity(), {1, 0, 0}}, 50),
                    testing::place("b", std::make_shared<testing::TestRange>(0.005),
                                   {Eigen::Matrix3d::Identity(), {0, 0, 1}}, 50)};
  for (const Solver solver : {Solver::spectral, Solver::doubling}) {
    const FusedState state = state_at(system, {}, solver);
    ASSERT_EQ(state.status, RiccatiStatus::unobservable);
    ASSERT_EQ(state.unobservable.cols(), 2);  // y and its velocity
    StateMatrix projector = state.unobservable * state.unobservable.transpose();
    StateMatrix expected = StateMatrix::Zero(6, 6);
    expected(1, 1) = expected(4, 4) = 1;
    EXPECT_LT((projector - expected).norm(), 1e-12);

    // x alone: z = x with R = 0.005 m², q = 0.3951529079.
    MotionModel one = testing::chain_motion(PoseState::position, 2,
                                            0.3951529079 * Eigen::Matrix3d::Identity());
    System x_alone = direct_system({{0.02, 0.005}}, 0.3951529079);
    x_alone.motion = one;
    const FusedState reference = state_at(x_alone, {}, Solver::doubling);
    EXPECT_NEAR(state.prior(0, 0), reference.prior(0, 0), 1e-11);
    EXPECT_NEAR(state.prior(0, 3), reference.prior(0, 3), 1e-11);
    EXPECT_NEAR(state.prior(3, 3), reference.prior(3, 3), 1e-10);
    EXPECT_NEAR(state.prior(1, 1), 0, 1e-20) << "projected off the lost direction";
  }
}

// R = 0 in one of three directions: the limit of R → 0, and no variance after an
// update.
TEST(Fusion, APerfectMeasurementIsSolvedByTheGeneralPath) {
  const auto system_with = [](double r) {
    System system = testing::acoustic_system();
    Eigen::Matrix3d R = 0.01 * Eigen::Matrix3d::Identity();
    R(1, 1) = r;
    system.devices = {testing::place(
        "exact",
        std::make_shared<TestLinear>(Span::point, Eigen::Matrix3d::Identity(), R),
        Pose{}, 50)};
    return system;
  };
  const FusedState exact = state_at(system_with(0), {});
  const FusedState nearly = state_at(system_with(1e-13), {});
  ASSERT_EQ(exact.status, RiccatiStatus::converged);
  EXPECT_NEAR(exact.posterior(1, 1), 0, 1e-18);
  EXPECT_LT((exact.prior - nearly.prior).norm(), 1e-5 * exact.prior.norm());
  EXPECT_LT((exact.prior.block<1, 1>(0, 0) - nearly.prior.block<1, 1>(0, 0)).norm(),
            1e-15);

  // Measured all the time without noise, the direction and its velocity are known.
  System continuous = system_with(0);
  continuous.fusion = Fusion::continuous;
  const FusedState pinned = state_at(continuous, {});
  ASSERT_EQ(pinned.status, RiccatiStatus::converged);
  EXPECT_NEAR(pinned.prior(1, 1), 0, 1e-18);
  EXPECT_NEAR(pinned.prior(4, 4), 0, 1e-18);
  System rest = system_with(1e-30);
  rest.fusion = Fusion::continuous;
  EXPECT_NEAR(pinned.prior(0, 0), state_at(rest, {}).prior(0, 0), 1e-12);
}

// Adjoints of all ways to a smooth P∞, against central differences in S: reduced,
// general (a gyroscope's rows), and with a direction pinned by a row without noise.
TEST(Fusion, AdjointsAreCentralDifferences) {
  System general = testing::acoustic_system();
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(3, 18);
  H.middleCols(6, 3).setIdentity();
  general.devices.push_back(testing::place(
      "speed",
      std::make_shared<TestLinear>(Span::motion, H, Eigen::Matrix3d::Identity()),
      Pose{}, 50));
  System continuous = testing::acoustic_system();
  continuous.fusion = Fusion::continuous;
  struct Way {
    System system;
    bool pinned;
  };
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (Way way :
       {Way{testing::acoustic_system(), false}, Way{testing::acoustic_system(), true},
        Way{general, false}, Way{continuous, false}, Way{continuous, true}}) {
    for (const CovarianceKind kind :
         {CovarianceKind::prior, CovarianceKind::posterior}) {
      way.system.covariance = kind;
      ASSERT_EQ(adjoint_problem(way.system), "");
      const auto solver = make_smooth_steady_solver(way.system);
      const int c = information_size(way.system), n = 6;
      const auto random_symmetric = [&](int size) {
        StateMatrix X(size, size);
        for (double& x : X.reshaped()) x = normal(random);
        return StateMatrix(X + X.transpose());
      };
      const StateMatrix X = random_symmetric(c), Y = random_symmetric(n),
                        D = random_symmetric(c);
      const StateMatrix S = 100 * (X * X.transpose() + StateMatrix::Identity(c, c));
      SteadyEquation at = solver->equation();
      FusedState state;
      const auto solved = [&](const StateMatrix& information) {
        double packed[packed_index(kMaxState, 0)];
        for (int i = 0; i < c; ++i)
          for (int j = 0; j <= i; ++j) packed[packed_index(i, j)] = information(i, j);
        at.clear();
        at.add(0, packed);
        if (way.pinned) at.add_perfect(0, Eigen::Vector3d(1, 2, -1));
        solver->solve(at, {}, state);
        EXPECT_EQ(state.status, RiccatiStatus::converged);
        return state.covariance(kind).cwiseProduct(Y).sum();
      };
      constexpr double kStep = 0.01;
      const double difference =
          (solved(S + kStep * D) - solved(S - kStep * D)) / (2 * kStep);
      solved(S);
      const StateMatrix G = solver->adjoint(at, Y);
      ASSERT_EQ(G.rows(), c);
      EXPECT_NEAR(G.cwiseProduct(D).sum(), difference, 1e-5 * G.norm() * D.norm());
      EXPECT_GT(G.norm(), 0);
    }
  }
}

TEST(Fusion, SaysWhatItsCovariancesAre) {
  System system = testing::acoustic_system();
  for (const auto& [fusion, of] :
       {std::pair{Fusion::stacked, CovarianceOf::every_update},
        std::pair{Fusion::continuous, CovarianceOf::all_times},
        std::pair{Fusion::periodic, CovarianceOf::time_average},
        std::pair{Fusion::sequential, CovarianceOf::turn_average},
        std::pair{Fusion::artemis, CovarianceOf::summed_psi}}) {
    system.fusion = fusion;
    EXPECT_EQ(state_at(system, {}).of, of);
    EXPECT_EQ(adjoint_problem(system).empty(),
              fusion == Fusion::stacked || fusion == Fusion::continuous);
  }
}

TEST(Fusion, ASolverThatCannotDoTheSystemSaysWhatWould) {
  System system = testing::acoustic_system();
  system.fusion = Fusion::artemis;
  try {
    (void)make_steady_solver(system, Solver::doubling);
    FAIL();
  } catch (const UnsuitableSolver& error) {
    EXPECT_EQ(error.instead(), Solver::eigenvector);
    EXPECT_STREQ(error.what(),
                 "the doubling solver can't do artemis fusion, whose sum of Ψ matrices "
                 "is no Riccati equation; the eigenvector solver can");
  }
  EXPECT_THROW((void)make_steady_solver(system, Solver::spectral), UnsuitableSolver);
  EXPECT_THROW((void)make_steady_solver(system, Solver::doubling), UnsuitableSolver);
  EXPECT_EQ(make_steady_solver(system)->solver(), Solver::eigenvector);
  system.fusion = Fusion::continuous;
  EXPECT_THROW((void)make_steady_solver(system, Solver::eigenvector), UnsuitableSolver);
  EXPECT_EQ(make_steady_solver(system)->solver(), Solver::spectral);
  system.fusion = Fusion::periodic;
  EXPECT_EQ(make_steady_solver(system)->solver(), Solver::doubling);
}

// A gyroscope measures ω, not the pose: the general path takes over, and improves the
// velocity that a marker's position alone gives.
// A prior is a device that measures the pose itself whenever anybody reports.
TEST(Fusion, APriorIsWhatADeviceOfThePoseTells) {
  constexpr double kRate = 50, kVariance = 0.04;
  for (const Fusion fusion : {Fusion::stacked, Fusion::continuous, Fusion::periodic}) {
    for (const int devices : {1, 4}) {
      System system = testing::acoustic_system(kRate);
      system.fusion = fusion;
      system.devices.resize(static_cast<std::size_t>(devices));
      System with_device = system;
      system.prior = (fusion == Fusion::continuous ? kRate : 1) / kVariance;
      with_device.devices.push_back(
          testing::place("guess",
                         std::make_shared<testing::TestLinear>(
                             Span::pose, Eigen::MatrixXd::Identity(3, 6),
                             Eigen::MatrixXd(kVariance * Eigen::Matrix3d::Identity())),
                         Pose{}, kRate));
      const TargetPose pose{Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.3}};
      const FusedState a = testing::state_at(system, pose),
                       b = testing::state_at(with_device, pose);
      ASSERT_EQ(a.status, RiccatiStatus::converged);
      EXPECT_LT((a.prior - b.prior).norm(), 1e-11 * b.prior.norm());
      EXPECT_LT((a.posterior - b.posterior).norm(), 1e-11 * b.posterior.norm());
    }
  }
}

TEST(Fusion, DerivativeMeasurementsTakeTheGeneralPath) {
  System system = testing::acoustic_system();
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(3, 18);
  H.middleCols(6, 3).setIdentity();
  const FusedState without = state_at(system, {});
  system.devices.push_back(testing::place(
      "speed",
      std::make_shared<TestLinear>(Span::motion, H, 1e-4 * Eigen::Matrix3d::Identity()),
      {rotation_from_rpy({0.3, 0.2, 0.1}), {0, 0, 0}}, 50));
  EXPECT_EQ(information_size(system), 6);
  EXPECT_EQ(make_steady_solver(system)->solver(), Solver::doubling);
  const FusedState with = state_at(system, {});
  ASSERT_EQ(with.status, RiccatiStatus::converged);
  EXPECT_GE(smallest_eigenvalue(without.prior - with.prior), -1e-12);
  EXPECT_LT(with.prior(3, 3), 0.2 * without.prior(3, 3));
  // Isotropic noise looks the same from any mounting.
  system.devices.back().X_WS().R.setIdentity();
  const FusedState upright = state_at(system, {});
  EXPECT_LT((upright.prior - with.prior).norm(), 1e-12);
}

}  // namespace
}  // namespace delos
