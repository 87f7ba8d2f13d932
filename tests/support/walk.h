// Records of chains whose order and noise are known.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

namespace delos::test {

/// A chain of order k, drawn step by step, and seen with noise.
class Walk {
 public:
  /// @param q, r spectral density and variance, as motion/chain_fit.h has them
  Walk(int k, double q, double r, double dt, unsigned seed)
      : A_(Eigen::MatrixXd::Zero(k, k)), Q_(k, k), r_(r), random_(seed) {
    for (int i = 0; i < k; ++i)
      for (int j = 0; j < k; ++j) {
        const int p = 2 * k - 1 - i - j;
        if (j >= i) A_(i, j) = std::pow(dt, j - i) / std::tgamma(j - i + 1.0);
        Q_(i, j) = q * std::pow(dt, p) /
                   (p * std::tgamma(k - i + 0.0) * std::tgamma(k - j + 0.0));
      }
    L_ = Q_.llt().matrixL();
    x_ = Eigen::VectorXd::Zero(k);
  }
  double next() {
    Eigen::VectorXd w(x_.size());
    for (double& v : w) v = normal_(random_);
    x_ = A_ * x_ + L_ * w;
    return x_(0) + std::sqrt(r_) * normal_(random_);
  }
  std::vector<double> record(int n) {
    std::vector<double> z;
    for (int i = 0; i < n; ++i) z.push_back(next());
    return z;
  }

 private:
  Eigen::MatrixXd A_, Q_, L_;
  Eigen::VectorXd x_;
  double r_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace delos::test
