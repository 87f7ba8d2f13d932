// What is smooth along a path, and what scatters about it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

namespace delos::measured {

/// A polynomial fitted to each column of rows over time.
struct CurveFit {
  Eigen::MatrixXd curve;    ///< at the rows' times
  Eigen::MatrixXd scatter;  ///< rows − curve
  int parameters = 0;       ///< of each column: degree + 1

  /// Of each column √(Σ scatter² / (rows − parameters)): what isn't smooth, without
  /// what the fit took with it.
  [[nodiscard]] Eigen::VectorXd deviation() const;
};

/// Least squares by Legendre's polynomials, which keep their digits.
///
/// The sag of a rail under its own weight w and a load F at a, of length l, stiffness
/// E I and freely supported, is
///
///     w x (l³ − 2 l x² + x³) / (24 E I) + F b x (l² − b² − x²) / (6 l E I),  b = l −
///     a,
///
/// to the left of the load; of what rides along it the load is where the reading is,
/// F x² (l − x)²/(3 l E I). Both are of the fourth degree in x, which at even speed is
/// that in time. Source: Young, Budynas (2002), Roark's formulas for stress and strain,
/// 7th ed., table 8.1, cases 1e, 2e.
/// @param degree 0 to 20
/// @returns it, or a sentence that says why not: too few rows
[[nodiscard]] std::variant<CurveFit, std::string> fit_curve(
    const std::vector<double>& t, const Eigen::MatrixXd& rows, int degree);

}  // namespace delos::measured
