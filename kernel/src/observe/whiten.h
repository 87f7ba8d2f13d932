// Splits rows of correlated noise into rows of independent noise.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "delos/device/device.h"

namespace delos {

/// Whether a variance is large enough to be inverted: a smaller one is no noise.
[[nodiscard]] inline bool is_noise(double variance) {
  return variance >= std::numeric_limits<double>::min();
}

/// R = V diag(r) Vᵀ.
struct IndependentNoise {
  decltype(Observation::R) directions;  ///< V
  decltype(Observation::z) variance;    ///< r, with 0 for what counts as no noise
};

/// Variances up to m·ε times the largest, or too small to invert, count as no noise.
IndependentNoise independent_noise(const decltype(Observation::R)& R);

/// Split an observation into directions of independent noise: `visit(row, variance)`
/// for each eigenvector of R, with a variance of 0 where it has no noise.
template <class Visit>
void whiten(const decltype(Observation::H)& H, const decltype(Observation::R)& R,
            Visit&& visit) {
  if (R.rows() == 1) {
    visit(H.row(0), is_noise(R(0, 0)) ? R(0, 0) : 0.0);
    return;
  }
  const bool diagonal = R.rows() == 2 && R(0, 1) == 0 && R(1, 0) == 0;
  if (diagonal && is_noise(R(0, 0)) && is_noise(R(1, 1))) {
    visit(H.row(0), R(0, 0));
    visit(H.row(1), R(1, 1));
    return;
  }
  const IndependentNoise split = independent_noise(R);
  for (Eigen::Index i = 0; i < R.rows(); ++i) {
    const Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMaxState> row =
        split.directions.col(i).transpose() * H;
    visit(row, split.variance(i));
  }
}

}  // namespace delos
