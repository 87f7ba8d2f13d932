// Rows that are measured without noise.
#pragma once

#include "delos/model/state.h"

namespace delos {

/// Add a row to an orthonormal basis of rows unless it depends on them: a perfect
/// measurement says no more when it is repeated.
inline void append_independent(const StateVector& row, StateMatrix& basis) {
  StateVector rest = row;
  for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Kahan)
    for (Eigen::Index r = 0; r < basis.rows(); ++r) {
      rest -= basis.row(r).dot(rest) * basis.row(r).transpose();
    }
  }
  const double norm = rest.norm();
  if (!(norm > 1e-12 * row.norm())) return;
  const Eigen::Index rows = basis.rows();
  basis.conservativeResize(rows + 1, row.size());
  basis.row(rows) = rest.transpose() / norm;
}

}  // namespace delos
