// Splits rows of correlated noise into rows of independent noise.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "delos/device/device.h"

namespace delos {

/// Rows over the pose coordinates or the whole state, stored inline.
using StateRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                kMaxRows, kMaxState>;

/// R = V diag(r) Vᵀ.
struct IndependentNoise {
  decltype(Observation::R) directions;  ///< V
  decltype(Observation::z) variance;    ///< r, with 0 for what counts as no noise
};

/// Variances up to m·ε times the largest, or too small to invert, count as no noise.
IndependentNoise independent_noise(const decltype(Observation::R)& R);

/// Split an observation into directions of independent noise: `noisy(row, variance)`
/// for each eigenvector of R with finite weight, `exact(row)` for those without noise.
///
/// Smaller than m·ε times the largest variance, or too small to invert: no noise.
template <class Noisy, class Exact>
void whiten(const StateRows& rows, const decltype(Observation::R)& R, Noisy&& noisy,
            Exact&& exact) {
  const double least = std::numeric_limits<double>::min();
  if (R.rows() == 1) {
    if (R(0, 0) >= least) {
      noisy(rows.row(0), R(0, 0));
    } else {
      exact(rows.row(0));
    }
    return;
  }
  if (R.rows() == 2 && R(0, 1) == 0 && R(1, 0) == 0 && R(0, 0) >= least &&
      R(1, 1) >= least) {
    noisy(rows.row(0), R(0, 0));
    noisy(rows.row(1), R(1, 1));
    return;
  }
  const IndependentNoise split = independent_noise(R);
  for (Eigen::Index i = 0; i < R.rows(); ++i) {
    const Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMaxState> row =
        split.directions.col(i).transpose() * rows;
    if (split.variance(i) > 0) {
      noisy(row, split.variance(i));
    } else {
      exact(row);
    }
  }
}

}  // namespace delos
