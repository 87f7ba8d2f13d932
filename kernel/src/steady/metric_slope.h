// One metric of one pose as a function of the information, and its slope.
#pragma once

#include "delos/model/metric.h"
#include "delos/riccati/riccati.h"
#include "delos/riccati/spectral.h"
#include "delos/rig/system.h"

namespace delos {

/// The exponent of the eigenvalues' norm that stands for the largest one.
inline constexpr double kEigenPower = 16;

/// The metrics of a system at one pose, from its information; see slope_problem().
/// Reentrant.
class MetricSlope {
 public:
  MetricSlope(const System& system, const std::vector<Metric>& metrics);

  /// @param S information of one update, or its rate, information_size() square
  /// @param[out] values one a metric; +∞ where it isn't finite
  void values(const StateMatrix& S, double* values) const;

  /// Σ_m weight_m ∂value_m/∂S
  /// @param[out] G as S, symmetric; zero where the state isn't observable
  void slope(const StateMatrix& S, const double* weights, StateMatrix& G) const;

 private:
  /// P∞ of the posterior or the prior; false where it has no finite value.
  bool solve(const StateMatrix& S, SpectralForm& form, SteadyState& state,
             StateMatrix& P) const;

  std::vector<Metric> metrics_;
  StateLayout layout_;
  CovarianceKind kind_;
  bool spectral_;
  bool whole_state_;  // whether a metric reads more than the pose
  CoordinateMatrix L_;
  Sampling sampling_;
  MotionStep step_;
};

}  // namespace delos
