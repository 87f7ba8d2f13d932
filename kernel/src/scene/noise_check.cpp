#include "scene/noise_check.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "delos/text/units.h"
#include "text/number_text.h"
#include "text/numbers.h"

namespace delos {
namespace {

bool check_symmetric(Reader& reader, const Place& at, const Eigen::MatrixXd& m) {
  const auto entry = [&](Eigen::Index i, Eigen::Index j) {
    return std::to_string(i) + '.' + std::to_string(j) + " is " + shortest(m(i, j));
  };
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      if (m(i, j) == m(j, i)) continue;
      reader.error(at, "is not symmetric: " + entry(j, i) + ", " + entry(i, j));
      return false;
    }
  return true;
}

double least_eigenvalue(const Eigen::MatrixXd& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m, Eigen::EigenvaluesOnly)
      .eigenvalues()[0];
}

bool refuse(Reader& reader, const Place& at, const char* property, double least) {
  reader.error(at, std::string("is not ") + property + ": its least eigenvalue is " +
                       rounded(least, 6));
  return false;
}

}  // namespace

bool check_positive_definite(Reader& reader, const Place& at,
                             const Eigen::MatrixXd& m) {
  if (!check_symmetric(reader, at, m)) return false;
  if (Eigen::LLT<Eigen::MatrixXd>(m).info() == Eigen::Success) return true;
  return refuse(reader, at, "positive definite", least_eigenvalue(m));
}

bool check_positive_semidefinite(Reader& reader, const Place& at,
                                 const Eigen::MatrixXd& m) {
  if (!check_symmetric(reader, at, m)) return false;
  // Eigenvalues are exact to rounding only, and singular matrices are allowed.
  constexpr double kRounding = 1e-12;
  const double least = least_eigenvalue(m);
  if (least >= -kRounding * m.cwiseAbs().maxCoeff()) return true;
  return refuse(reader, at, "positive semidefinite", least);
}

}  // namespace delos
