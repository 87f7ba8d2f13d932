// Readings as rows of independent noise, with what they are off by.
#pragma once

#include "delos/observe/reading_model.h"
#include "observe/whiten.h"

namespace delos {

/// Visit each row of independent noise: visit(h, z, variance), with a variance of 0
/// where it has none. @param z m×1, any numbers that go with the rows
template <class Vector, class Visit>
void each_row(const PredictedReading& predicted, const Vector& z, Visit&& visit) {
  const Eigen::Index m = predicted.R.rows();
  if (predicted.R.isDiagonal(0)) {
    for (Eigen::Index r = 0; r < m; ++r) {
      const double variance = predicted.R(r, r);
      visit(predicted.H.row(r), z(r), is_noise(variance) ? variance : 0.0);
    }
    return;
  }
  const IndependentNoise split = independent_noise(predicted.R);
  Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMaxState> row;
  for (Eigen::Index r = 0; r < m; ++r) {
    row = split.directions.col(r).transpose() * predicted.H;
    visit(row, split.directions.col(r).dot(z), split.variance(r));
  }
}

}  // namespace delos
