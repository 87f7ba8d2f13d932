// Seeded random systems for the tests of the riccati room.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <random>

#include "delos/model/covariance_kind.h"
#include "delos/model/motion.h"
#include "delos/riccati/riccati.h"
#include "delos/riccati/spectral.h"

namespace delos::testing {

inline constexpr CovarianceKind kPrior = CovarianceKind::prior;
inline constexpr CovarianceKind kPosterior = CovarianceKind::posterior;
inline constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Random matrices from one seed.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// 10^uniform(low, high)
  double decades(double low, double high) { return std::pow(10, uniform(low, high)); }

  Eigen::MatrixXd matrix(int rows, int cols) {
    std::normal_distribution<double> normal;
    return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return normal(engine_); });
  }
  Eigen::MatrixXd rotation(int n) {
    return Eigen::HouseholderQR<Eigen::MatrixXd>(matrix(n, n)).householderQ();
  }
  /// U diag(10^uniform(low, high)) Uᵀ
  Eigen::MatrixXd spd(int n, double low = -1, double high = 1) {
    const Eigen::MatrixXd U = rotation(n);
    const Eigen::VectorXd lambda =
        Eigen::VectorXd::NullaryExpr(n, [&] { return decades(low, high); });
    const Eigen::MatrixXd m = U * lambda.asDiagonal() * U.transpose();
    return (m + m.transpose()) / 2;
  }

 private:
  std::mt19937_64 engine_;
};

/// A chain of order k with process noise q; d = q.rows().
inline MotionModel chain_model(int order, const Eigen::MatrixXd& q) {
  MotionModel model;
  model.layout.order = order;
  model.layout.pose = q.rows() == 6 ? PoseState::pose : PoseState::position;
  model.dynamics = ChainMotion{q};
  return model;
}

inline CoordinateMatrix cholesky(const Eigen::MatrixXd& q) {
  return Eigen::MatrixXd(Eigen::LLT<Eigen::MatrixXd>(q).matrixL());
}

/// S on the pose block of an n-state system.
inline StateMatrix embed(const Eigen::MatrixXd& S, Eigen::Index n) {
  StateMatrix full = StateMatrix::Zero(n, n);
  full.topLeftCorner(S.rows(), S.cols()) = S;
  return full;
}

inline Measurement informed(const StateMatrix& S) {
  return {S, StateMatrix(0, S.cols())};
}

inline double relative(const Eigen::MatrixXd& a, const Eigen::MatrixXd& reference) {
  return (a - reference).norm() / reference.norm();
}

inline double smallest_eigenvalue(const Eigen::MatrixXd& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m).eigenvalues()[0];
}

inline double condition(const Eigen::MatrixXd& spd) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> e(spd);
  return e.eigenvalues()[spd.rows() - 1] / e.eigenvalues()[0];
}

/// closed_loop_radius() of one step repeated.
inline double closed_loop_radius(const MotionStep& motion, const SteadyState& state) {
  const CycleStep step{motion, {}};
  return delos::closed_loop_radius({&step, 1}, {&state, 1});
}

}  // namespace delos::testing
