// Square roots of covariances that may be singular.
#pragma once

#include <algorithm>
#include <cmath>

#include "delos/model/state.h"

namespace delos {

/// L, lower triangular, with L Lᵀ = M: Cholesky's, with a column of zeros where nothing
/// is left of a pivot.
/// @pre M = Mᵀ ≥ 0 but for rounding
inline StateMatrix lower_root(const StateMatrix& M) {
  const Eigen::Index n = M.rows();
  StateMatrix L = StateMatrix::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double pivot = M(j, j) - L.row(j).head(j).squaredNorm();
    if (!(pivot > 1e-14 * std::max(0.0, M(j, j)))) continue;
    L(j, j) = std::sqrt(pivot);
    for (Eigen::Index i = j + 1; i < n; ++i)
      L(i, j) = (M(i, j) - L.row(i).head(j).dot(L.row(j).head(j))) / L(j, j);
  }
  return L;
}

}  // namespace delos
