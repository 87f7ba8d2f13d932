// A reading's moments over the error of a state, by points of its covariance.
#pragma once

#include "delos/observe/reading_model.h"

namespace delos {

/// What a reading is over x ~ N(estimate, P), without its noise.
struct UnscentedMoments {
  decltype(PredictedReading::z) mean;  ///< less the reading at the estimate, m×1
  decltype(PredictedReading::R) S;     ///< covariance, m×m
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxState,
                kMaxRows>
      C;  ///< covariance of the state with it, N×m
};

/// By 2N points at ±√(N + κ) along the columns of P's root and the mean, with weights
/// 1/(2(N + κ)) and κ/(N + κ), κ = max(0, 3 − N).
/// @param middle the reading at x, R
/// @returns false where one of the points is out of the device's view
/// @throws DeviceFault
/// Source: Julier, Uhlmann (2004), Proc. IEEE 92(3), 401–422, Eqs. 7–11.
[[nodiscard]] bool unscented_moments(const ReadingModel& model,
                                     const TrackReading& reading,
                                     const PredictedReading& middle,
                                     const StateVector& x, const Eigen::Matrix3d& R,
                                     const StateMatrix& P, UnscentedMoments& out);

}  // namespace delos
