#include "scene/noise_check.h"

#include <Eigen/Cholesky>

#include "delos/model/symmetric.h"
#include "delos/text/number_text.h"
#include "delos/text/numbers.h"
#include "delos/text/units.h"

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
  return refuse(reader, at, "positive definite", symmetric_eigenvalues(m)[0]);
}

bool check_positive_semidefinite(Reader& reader, const Place& at,
                                 const Eigen::MatrixXd& m) {
  if (!check_symmetric(reader, at, m)) return false;
  // Eigenvalues are exact to rounding only, and singular matrices are allowed.
  constexpr double kRounding = 1e-12;
  const double least = symmetric_eigenvalues(m)[0];
  if (least >= -kRounding * m.cwiseAbs().maxCoeff()) return true;
  return refuse(reader, at, "positive semidefinite", least);
}

}  // namespace delos
