#include "measured/curve.h"

#include <Eigen/QR>
#include <cmath>

namespace delos::measured {

Eigen::VectorXd CurveFit::deviation() const {
  const auto left = static_cast<double>(scatter.rows() - parameters);
  return (scatter.colwise().squaredNorm() / left).cwiseSqrt().transpose();
}

std::variant<CurveFit, std::string> fit_curve(const std::vector<double>& t,
                                              const Eigen::MatrixXd& rows, int degree) {
  const Eigen::Index n = rows.rows();
  if (n <= degree + 1)
    return "has " + std::to_string(n) + " places, too few for a curve of degree " +
           std::to_string(degree);
  const double first = t.front(), length = t.back() - first;
  if (!(length > 0)) return std::string("has places of one time alone");
  // (k + 1) L_{k+1} = (2k + 1) s L_k − k L_{k−1} over s = −1 to 1.
  Eigen::MatrixXd L(n, degree + 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double s = 2 * (t[static_cast<std::size_t>(i)] - first) / length - 1;
    L(i, 0) = 1;
    if (degree > 0) L(i, 1) = s;
    for (int k = 1; k < degree; ++k)
      L(i, k + 1) = ((2 * k + 1) * s * L(i, k) - k * L(i, k - 1)) / (k + 1);
  }
  CurveFit fit;
  fit.parameters = degree + 1;
  fit.curve = L * L.colPivHouseholderQr().solve(rows);
  fit.scatter = rows - fit.curve;
  return fit;
}

}  // namespace delos::measured
