// P∞ at one pose as a function of the information, and its slopes.
#pragma once

#include <string>

#include "delos/api.h"
#include "delos/riccati/riccati.h"
#include "delos/riccati/spectral.h"
#include "delos/rig/system.h"

namespace delos {

/// Empty where CovarianceMap knows the system's equation; else a sentence.
[[nodiscard]] DELOS_API std::string covariance_map_problem(const System& system);

/// S ↦ P∞ of a system, prior or posterior as the system says, and the adjoint of its
/// derivative. P∞ is matrix-convex and decreasing in S. Reentrant; no heap.
class DELOS_API CovarianceMap {
 public:
  /// @param whole_state whether more than the pose block of P∞ is wanted
  /// @pre covariance_map_problem() is empty
  explicit CovarianceMap(const System& system, bool whole_state = true);

  /// P∞ and what its derivative is made of.
  struct Solution {
    StateMatrix P;  ///< n×n, or d×d where the pose block is enough
    SpectralForm form;
    Measurement measurement;
    SteadyState state;
    bool spectral = false;
  };

  /// @param S information of one update, or its rate, information_size() square
  /// @param exact any number of rows measured without noise, information_size() columns
  /// @returns converged where P∞ is finite; out.P is unspecified else
  RiccatiStatus solve(const StateMatrix& S, const Eigen::MatrixXd& exact,
                      Solution& out) const;

  /// ∂⟨Y, P∞⟩/∂S, as S, symmetric.
  /// @param Y as out.P of solve(), symmetric
  [[nodiscard]] StateMatrix adjoint(const Solution& at, const StateMatrix& Y) const;

 private:
  StateLayout layout_;
  CovarianceKind kind_;
  bool reducible_;
  bool whole_state_;
  CoordinateMatrix L_;
  Sampling sampling_;
  MotionStep step_;
};

}  // namespace delos
