// Any linear system through the program: custom motion and linear devices, against the
// Riccati recursion written out here.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <iomanip>
#include <random>
#include <sstream>

#include "program.h"

namespace delos::test {
namespace {

using Eigen::MatrixXd;

struct LinearSystem {
  MatrixXd A, Q;
  std::vector<MatrixXd> H, R;  // one a device
};

MatrixXd random_matrix(int rows, int columns, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

/// A covariance that is symmetric to the last bit.
MatrixXd random_covariance(int size, std::mt19937_64& random) {
  const MatrixXd root = random_matrix(size, size, random);
  const MatrixXd product = root * root.transpose() / size;
  return (product + product.transpose()) / 2;
}

/// @param radius of A's spectrum; above 1 the motion alone is unstable
LinearSystem random_system(int n, double radius, std::mt19937_64& random) {
  LinearSystem system;
  system.A = random_matrix(n, n, random);
  system.A *=
      radius /
      Eigen::EigenSolver<MatrixXd>(system.A, false).eigenvalues().cwiseAbs().maxCoeff();
  system.Q = random_covariance(n, random);
  for (const int m : {2, 1}) {
    system.H.push_back(random_matrix(m, n, random));
    system.R.push_back(random_covariance(m, random) + MatrixXd::Identity(m, m));
  }
  return system;
}

std::string yaml(const MatrixXd& M) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (int i = 0; i < M.rows(); ++i) {
    text << (i == 0 ? "[[" : ", [");
    for (int j = 0; j < M.cols(); ++j) text << (j == 0 ? "" : ", ") << M(i, j);
    text << "]";
  }
  return text.str() + "]";
}

std::string scene_of(const LinearSystem& system) {
  std::string names;
  for (int i = 3; i < system.A.rows(); ++i) {
    names += (i == 3 ? "b" : ", b") + std::to_string(i);
  }
  std::string text =
      "delos: 1\nmotion:\n  type: custom\n  state: position\n  names: [" + names +
      "]\n  A: " + yaml(system.A) + "\n  Q: " + yaml(system.Q) +
      "\nsample: {points: [[0, 0, 0]]}\ndevices:\n";
  for (std::size_t i = 0; i < system.H.size(); ++i) {
    text += "  - {name: d" + std::to_string(i) +
            ", type: linear, rate: 50 Hz, params: {H: " + yaml(system.H[i]) +
            ", R: " + yaml(system.R[i]) + "}}\n";
  }
  return text;
}

/// P ← A (P − P Hᵀ (H P Hᵀ + R)⁻¹ H P) Aᵀ + Q until it stands still.
MatrixXd fixed_point(const LinearSystem& system) {
  const int n = static_cast<int>(system.A.rows());
  int m = 0;
  for (const MatrixXd& H : system.H) m += static_cast<int>(H.rows());
  MatrixXd H(m, n), R = MatrixXd::Zero(m, m);
  int row = 0;
  for (std::size_t i = 0; i < system.H.size(); ++i) {
    const int rows = static_cast<int>(system.H[i].rows());
    H.middleRows(row, rows) = system.H[i];
    R.block(row, row, rows, rows) = system.R[i];
    row += rows;
  }
  MatrixXd P = system.Q;
  for (int step = 0; step < 100000; ++step) {
    const MatrixXd HP = H * P;
    const MatrixXd innovation = HP * H.transpose() + R;
    const MatrixXd posterior = P - HP.transpose() * innovation.ldlt().solve(HP);
    MatrixXd next = system.A * posterior * system.A.transpose() + system.Q;
    next = (next + next.transpose()).eval() / 2;
    const double change = (next - P).cwiseAbs().maxCoeff();
    P = next;
    if (change < 1e-15 * P.cwiseAbs().maxCoeff()) break;
  }
  return P;
}

void expect_fixed_point(const LinearSystem& system) {
  const Folder folder;
  folder.write("scene.yaml", scene_of(system));
  const Finished done =
      run({"point", "scene.yaml", "--at", "0,0,0", "--json"}, folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  EXPECT_EQ(json["observable"], true);
  const MatrixXd expected = fixed_point(system);
  const Json& prior = json["P_prior"];
  ASSERT_EQ(prior.size(), static_cast<std::size_t>(expected.rows()));
  EXPECT_EQ(json["state"].size(), prior.size());
  double error = 0;
  for (int i = 0; i < expected.rows(); ++i) {
    for (int j = 0; j < expected.cols(); ++j) {
      ASSERT_TRUE(prior[i][j].is_number());
      error = std::max(error, std::abs(prior[i][j].get<double>() - expected(i, j)));
    }
  }
  EXPECT_LT(error, 1e-9 * expected.cwiseAbs().maxCoeff());
}

TEST(LinearSystems, OfFourStatesReachTheFixedPoint) {
  std::mt19937_64 random(1960);
  expect_fixed_point(random_system(4, 0.9, random));
  expect_fixed_point(random_system(4, 1.05, random));
}

TEST(LinearSystems, OfThirtyStatesReachTheFixedPoint) {
  std::mt19937_64 random(30);
  expect_fixed_point(random_system(30, 0.9, random));
  expect_fixed_point(random_system(30, 1.02, random));
}

/// One reading is perfect, then two that differ by nothing but a common noise.
TEST(LinearSystems, TakeASingularNoise) {
  std::mt19937_64 random(7);
  LinearSystem system = random_system(4, 0.95, random);
  system.R[0] << 0.3, 0, 0, 0;
  expect_fixed_point(system);
  system.R[0] << 0.5, 0.5, 0.5, 0.5;
  expect_fixed_point(system);
  system.R[0].setZero();
  expect_fixed_point(system);
}

}  // namespace
}  // namespace delos::test
