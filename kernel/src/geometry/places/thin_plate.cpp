#include "geometry/places/thin_plate.h"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <string>

namespace delos {
namespace {

/// φ of a squared distance. Its double Laplacian is 8π δ.
double plate(double square) { return square > 0 ? square * std::log(square) / 2 : 0; }

Eigen::Vector2d mean_of(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points)
    mean += p / static_cast<double>(points.size());
  return mean;
}

}  // namespace

bool in_one_line(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3) return true;
  const Eigen::Vector2d mean = mean_of(points);
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& p : points) spread += (p - mean) * (p - mean).transpose();
  return !(spread.determinant() > 1e-12 * spread.trace() * spread.trace());
}

/// Solves [Φ T; Tᵀ 0] (w, c) = (v, 0) with T = (1, x, y).
ThinPlate::ThinPlate(const std::vector<Eigen::Vector2d>& points,
                     const std::vector<double>& values) {
  if (points.size() > kMostPoints)
    throw std::invalid_argument("a plate of minimum curvature goes through at most " +
                                std::to_string(kMostPoints) + " places, not " +
                                std::to_string(points.size()) +
                                "; natural-neighbour takes any number");
  middle_ = mean_of(points);
  scale_ = 0;
  for (const Eigen::Vector2d& p : points)
    scale_ = std::max(scale_, (p - middle_).norm());
  const auto n = static_cast<Eigen::Index>(points.size());
  points_.resize(2, n);
  for (Eigen::Index i = 0; i < n; ++i)
    points_.col(i) = (points[static_cast<std::size_t>(i)] - middle_) / scale_;
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n + 3, n + 3);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j)
      M(i, j) = M(j, i) = plate((points_.col(i) - points_.col(j)).squaredNorm());
    M.row(i).tail<3>() << 1, points_.col(i).transpose();
    M.col(i).tail<3>() = M.row(i).tail<3>().transpose();
    right(i) = values[static_cast<std::size_t>(i)];
  }
  weights_ = M.partialPivLu().solve(right);
}

double ThinPlate::at(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d p = (place - middle_) / scale_;
  const Eigen::Index n = points_.cols();
  double sum = weights_(n) + weights_.tail<2>().dot(p);
  for (Eigen::Index i = 0; i < n; ++i)
    sum += weights_(i) * plate((p - points_.col(i)).squaredNorm());
  return sum;
}

}  // namespace delos
