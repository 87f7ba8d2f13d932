// Devices whose readings take time, through whole systems, against a filter that
// integrates them tick by tick.
#include <gtest/gtest.h>

#include <numbers>

#include "delos/field/evaluate.h"
#include "delos/field/point.h"
#include "support/exposing_filter.h"
#include "support/rigs.h"

namespace delos {
namespace {

using testing::ExposingDevice;
using testing::ExposingFilter;
using testing::LongMatrix;
using testing::state_at;
using testing::TestLinear;

constexpr double kTick = 0.001;  // s

double relative(const StateMatrix& a, const LongMatrix& reference) {
  return static_cast<double>((a.cast<long double>() - reference).norm() /
                             reference.norm());
}

/// What is told of both a system's device and the filter's.
struct Given {
  int period, exposure, phase;  // ticks
  Eigen::MatrixXd H;            // m×3
  double variance;
};

Eigen::MatrixXd row(double x, double y, double z) {
  return Eigen::RowVector3d(x, y, z);
}

CoordinateMatrix tied_noise() {
  Eigen::Matrix3d q;
  q << 0.4, 0.1, 0, 0.1, 0.3, -0.05, 0, -0.05, 0.1;
  return q;
}

System system_of(int order, const std::vector<Given>& devices, Fusion fusion) {
  System system;
  system.motion = testing::chain_motion(PoseState::position, order, tied_noise());
  system.fusion = fusion;
  system.markers = {Eigen::Vector3d::Zero()};
  for (const Given& d : devices) {
    const Eigen::Index m = d.H.rows();
    const Eigen::MatrixXd R = d.variance * Eigen::MatrixXd::Identity(m, m);
    system.devices.push_back(
        testing::place("d" + std::to_string(system.devices.size()),
                       std::make_shared<TestLinear>(Span::point, d.H, R), Pose{},
                       1 / (d.period * kTick)));
    system.devices.back().period = d.period * kTick;
    system.devices.back().exposure = d.exposure * kTick;
    system.devices.back().phase = d.phase * kTick;
  }
  return system;
}

ExposingFilter filter_of(int order, const std::vector<Given>& devices) {
  std::vector<ExposingDevice> all;
  for (const Given& d : devices) {
    const Eigen::Index m = d.H.rows();
    const Eigen::MatrixXd R = d.variance * Eigen::MatrixXd::Identity(m, m);
    all.push_back({d.period, d.exposure, d.phase, d.H.cast<long double>(),
                   R.cast<long double>()});
  }
  return {order, Eigen::MatrixXd(tied_noise()).cast<long double>(), kTick, all};
}

/// Of one exposure, of different ones, and of instants beside: three rows in general
/// position.
std::vector<Given> three(int first, int second, int third) {
  return {{20, first, 0, row(1, 0.2, -0.3), 1e-4},
          {20, second, 0, row(0.1, 0.9, 0.5), 4e-4},
          {20, third, 0, row(-0.4, 0.3, 1), 1e-3}};
}

class Exposure : public ::testing::TestWithParam<int> {};  // the order k

/// Expected: the filter.
TEST_P(Exposure, OfStackedDevicesIsExact) {
  const int k = GetParam();
  for (const auto& devices : {three(5, 5, 5), three(13, 13, 13), three(20, 20, 20),
                              three(5, 13, 13), three(0, 20, 7)}) {
    const System system = system_of(k, devices, Fusion::stacked);
    const ExposingFilter filter = filter_of(k, devices);
    const bool together = devices[0].exposure == devices[1].exposure;
    for (const Solver solver : {Solver::automatic, Solver::doubling}) {
      EXPECT_EQ(make_steady_solver(system)->solver(),
                together ? Solver::spectral : Solver::doubling);
      const FusedState state = state_at(system, {}, solver);
      ASSERT_EQ(state.status, RiccatiStatus::converged);
      EXPECT_LT(relative(state.prior, filter.prior.front()), 1e-10);
      EXPECT_LT(relative(state.posterior, filter.posterior.front()), 1e-10);
      const double constant =
          static_cast<double>(-20 * kTick / std::log(filter.radius));
      EXPECT_NEAR(state.time_constant, constant, 1e-8 * constant);
    }
  }
}

/// Windows that reach back over updates of others, take turns or begin together.
TEST_P(Exposure, OfPeriodicDevicesIsExact) {
  const int k = GetParam();
  for (const auto& devices : std::vector<std::vector<Given>>{
           {{20, 20, 0, row(1, 0.2, -0.3), 1e-4},
            {6, 2, 3, row(0.1, 0.9, 0.5), 4e-4},
            {15, 11, 1, row(-0.4, 0.3, 1), 1e-3}},
           {{10, 0, 0, Eigen::Matrix3d::Identity(), 1e-3},
            {30, 30, 5, Eigen::Matrix3d::Identity(), 1e-5}},
           {{12, 5, 0, Eigen::Matrix3d::Identity(), 1e-3},
            {12, 5, 6, Eigen::Matrix3d::Identity(), 1e-3}}}) {
    const FusedState state = state_at(system_of(k, devices, Fusion::periodic), {});
    ASSERT_EQ(state.status, RiccatiStatus::converged);
    const ExposingFilter filter = filter_of(k, devices);
    // The mean by the trapezoid rule, the worst and the best instant.
    LongMatrix mean = LongMatrix::Zero(3 * k, 3 * k);
    const auto size = [](const LongMatrix& P) { return P.topLeftCorner(3, 3).trace(); };
    long double worst = 0, best = 1e9L;
    const std::size_t count = filter.instants.size();
    int length = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = (i + count - 1) % count;
      const int gap =
          i > 0 ? filter.instants[i] - filter.instants[before]
                : filter.instants[0] + filter.length - filter.instants[before];
      length += gap;
      mean += gap * (filter.posterior[before] + filter.prior[i]) / 2;
      worst = std::max(worst, size(filter.prior[i]));
      best = std::min(best, size(filter.posterior[i]));
    }
    EXPECT_EQ(length, filter.length);
    EXPECT_LT(relative(state.prior, mean / length), 1e-8);
    EXPECT_NEAR(state.worst_prior.topLeftCorner(3, 3).trace(),
                static_cast<double>(worst), 1e-8 * static_cast<double>(worst));
    EXPECT_NEAR(state.best_posterior.topLeftCorner(3, 3).trace(),
                static_cast<double>(best), 1e-8 * static_cast<double>(best));
  }
}

/// Turns of 20 and 12 ticks are a cycle of 32, in which each device reports once.
TEST_P(Exposure, OfDevicesInTurnIsExact) {
  const int k = GetParam();
  std::vector<Given> turns = {{20, 20, 0, Eigen::Matrix3d::Identity(), 1e-4},
                              {12, 7, 0, Eigen::Matrix3d::Identity(), 4e-4}};
  const FusedState state = state_at(system_of(k, turns, Fusion::sequential), {});
  turns[0].period = turns[1].period = 32;
  turns[0].phase = 20;
  const ExposingFilter filter = filter_of(k, turns);
  ASSERT_EQ(filter.prior.size(), 2u);
  EXPECT_LT(relative(state.prior, (filter.prior[0] + filter.prior[1]) / 2), 1e-10);
  EXPECT_LT(relative(state.posterior, (filter.posterior[0] + filter.posterior[1]) / 2),
            1e-10);
}

INSTANTIATE_TEST_SUITE_P(Order, Exposure, ::testing::Values(1, 2, 3));

/// A marker on an arm of a turning target: place and turn are averaged alike.
TEST(ExposureOfPoses, IsTheSameByBothSolvers) {
  System system = testing::acoustic_system();
  system.motion = testing::chain_motion(
      PoseState::pose, 2,
      Eigen::Vector<double, 6>(0.4, 0.4, 0.1, 1, 2, 3).asDiagonal());
  system.markers = {{0.1, 0, 0}, {0, 0.1, 0.02}, {-0.05, -0.05, 0.1}};
  for (PlacedDevice& device : system.devices) device.exposure = 0.015;
  const TargetPose pose{rotation_from_rpy({0.3, 0.2, 0.1}), {0.1, 0.3, 0.2}};
  const FusedState a = state_at(system, pose, Solver::spectral),
                   b = state_at(system, pose, Solver::doubling);
  ASSERT_EQ(b.status, RiccatiStatus::converged);
  EXPECT_LT((a.prior - b.prior).norm(), 1e-10 * b.prior.norm());
  EXPECT_LT((a.posterior - b.posterior).norm(), 1e-10 * b.posterior.norm());
  EXPECT_NEAR(a.time_constant, b.time_constant, 1e-8 * b.time_constant);
  const PointReport report =
      evaluate_point(system, pose, testing::metric_of(system, "eigmax"));
  EXPECT_LT(report.residual, 1e-10);
  EXPECT_LT((report.state.prior - a.prior).norm(), 1e-9 * a.prior.norm());
}

/// Fields take the scalar chains side by side.
TEST(ExposureOfFields, IsThatOfPoints) {
  System system = testing::acoustic_system();
  for (PlacedDevice& device : system.devices) device.exposure = 0.02;
  const Samples samples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.2);
  const Metric metric = testing::metric_of(system, "sigma_z");
  const Field field = evaluate_field(system, samples, {}, metric, {.threads = 2});
  const Field without =
      evaluate_field(testing::acoustic_system(), samples, {}, metric, {.threads = 2});
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const TargetPose pose{Eigen::Matrix3d::Identity(), samples.points[i]};
    const FusedState state = state_at(system, pose, Solver::doubling);
    EXPECT_NEAR(field.value[i], std::sqrt(state.prior(2, 2)), 1e-10 * field.value[i]);
    EXPECT_GT(field.value[i], without.value[i]);
  }
}

/// What one range sees of three directions, where nothing is lost but what was.
TEST(ExposureOfPoints, LosesNoOtherDirections) {
  System system = testing::acoustic_system();
  system.devices.resize(1);
  const TargetPose pose{Eigen::Matrix3d::Identity(), {0.3, 0.1, 0.2}};
  const FusedState instants = state_at(system, pose);
  system.devices[0].exposure = 0.01;
  const FusedState a = state_at(system, pose, Solver::spectral),
                   b = state_at(system, pose, Solver::doubling);
  EXPECT_EQ(a.status, RiccatiStatus::unobservable);
  EXPECT_EQ(b.status, RiccatiStatus::unobservable);
  for (const FusedState* state : {&a, &b}) {
    ASSERT_EQ(state->unobservable.cols(), instants.unobservable.cols());
    const StateMatrix both = instants.unobservable.transpose() * state->unobservable;
    EXPECT_NEAR(both.norm(), std::sqrt(both.cols()), 1e-9);  // one subspace
  }
  EXPECT_LT((a.prior - b.prior).norm(), 1e-9 * a.prior.norm());
}

/// A row without noise: the general path, which conditions on it.
TEST(ExposureOfPoints, OfPerfectRowsIsExact) {
  for (const int order : {1, 2, 3}) {
    std::vector<Given> devices = three(7, 7, 7);
    devices[1].variance = 0;
    const FusedState state = state_at(system_of(order, devices, Fusion::stacked), {});
    ASSERT_EQ(state.status, RiccatiStatus::converged);
    const ExposingFilter filter = filter_of(order, devices);
    EXPECT_LT(relative(state.prior, filter.prior.front()), 1e-8);
    EXPECT_LT(relative(state.posterior, filter.posterior.front()), 1e-8);
  }
}

/// ∂⟨Y, P∞⟩/∂S by central differences, on the reduced path and, with a pinned row, on
/// the general one.
TEST(ExposureOfPoints, HasAdjoints) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const auto random_symmetric = [&](int size) {
    StateMatrix X(size, size);
    for (double& x : X.reshaped()) x = normal(random);
    return StateMatrix(X + X.transpose());
  };
  for (const bool pinned : {false, true})
    for (const CovarianceKind kind :
         {CovarianceKind::prior, CovarianceKind::posterior}) {
      System system = system_of(2, three(13, 13, 13), Fusion::stacked);
      system.covariance = kind;
      ASSERT_EQ(adjoint_problem(system), "");
      const auto solver = make_smooth_steady_solver(system);
      const StateMatrix X = random_symmetric(3), Y = random_symmetric(6),
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
        EXPECT_EQ(state.status, RiccatiStatus::converged);
        return state.covariance(kind).cwiseProduct(Y).sum();
      };
      constexpr double kStep = 0.01;
      const double difference =
          (solved(S + kStep * D) - solved(S - kStep * D)) / (2 * kStep);
      solved(S);
      const StateMatrix G = solver->adjoint(at, Y);
      ASSERT_EQ(G.rows(), 3);
      EXPECT_NEAR(G.cwiseProduct(D).sum(), difference, 1e-5 * G.norm() * D.norm());
      EXPECT_GT(G.norm(), 0);
    }
  EXPECT_EQ(adjoint_problem(system_of(2, three(13, 13, 12), Fusion::stacked)),
            "fusion of devices that don't expose equally long has no derivative here");
}

/// What can't be said is refused, with a sentence, where no scene was asked first.
TEST(ExposureOfPoints, IsRefusedWhereItMeansNothing) {
  const auto problem_of = [](const System& system) -> std::string {
    try {
      (void)make_steady_solver(system);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  System system = system_of(2, three(5, 5, 5), Fusion::stacked);
  EXPECT_EQ(problem_of(system), "");
  EXPECT_THROW((void)make_steady_solver(system, Solver::eigenvector), UnsuitableSolver);
  for (const Fusion fusion : {Fusion::continuous, Fusion::artemis}) {
    system.fusion = fusion;
    EXPECT_NE(problem_of(system).find("an exposure isn't known to"), std::string::npos);
  }
  system.fusion = Fusion::stacked;
  system.devices[0].exposure = 0.021;
  EXPECT_EQ(problem_of(system), "d0: its exposure isn't within its period");
  system.devices[0].exposure = 0.005;
  system.devices[0].device = std::make_shared<TestLinear>(
      Span::motion, Eigen::MatrixXd::Identity(3, 18), Eigen::Matrix3d::Identity());
  EXPECT_NE(problem_of(system).find("d0 measures more than the pose"),
            std::string::npos);

  std::vector<Given> many;
  for (int i = 0; i < 9; ++i)
    many.push_back({20, 2 + i, 0, Eigen::Matrix3d::Identity(), 1e-4});
  EXPECT_NE(problem_of(system_of(2, many, Fusion::stacked)).find("33 numbers"),
            std::string::npos);
  many.pop_back();
  EXPECT_EQ(problem_of(system_of(2, many, Fusion::stacked)), "");
}

}  // namespace
}  // namespace delos
