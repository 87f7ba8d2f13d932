// The exact spectral reduction of pose-level measurements.
#pragma once

#include "delos/model/exposure_model.h"
#include "delos/model/lanes.h"
#include "delos/model/state.h"
#include "delos/riccati/chain.h"

namespace delos {

/// How often a chain is measured, and when its state is asked for.
struct Sampling {
  bool continuous = false;  ///< true: λ is an information rate and dt is not used
  double dt = 0;            ///< update period, seconds
  double exposure = 0;      ///< a reading is the mean over so many of them, ≤ dt
  ExposureModel model = ExposureModel::exact;  ///< of the motion meanwhile
  double lag = 0;  ///< seconds after what CovarianceKind says, ≥ 0
};

/// M = LᵀSL = U Λ Uᵀ: the measurement seen in coordinates of unit process noise, q = L
/// Lᵀ.
struct SpectralForm {
  CoordinateVector lambda;  ///< Λ, d×1, ascending; 0 where a direction is lost
  CoordinateMatrix LU;      ///< L·U, d×d: the directions in pose coordinates
  int unobservable = 0;     ///< number of leading zero eigenvalues

  /// Whether the least eigenvalue, of a formed S, has lost eight digits or more.
  [[nodiscard]] bool lacks_digits() const {
    return lambda(0) < kFewDigits * lambda(lambda.size() - 1);
  }
  static constexpr double kFewDigits = 1e-8;
};

/// Reduce the information of one update (or its rate) to d scalar chains.
///
/// Eigenvalues below 16·d·ε·λmax are set to zero: below it, they are the rounding of
/// the sum that formed S, not information.
/// @param L d×d, lower Cholesky factor of q
/// @param S d×d, symmetric ≥ 0
/// @cost Jacobi rotations; no heap.
[[nodiscard]] DELOS_API SpectralForm spectral_form(const CoordinateMatrix& L,
                                                   const CoordinateMatrix& S);

/// The careful way to the same: one-sided, from the stacked whitened rows R^(−1/2)·H
/// instead of their product, so that λmin keeps a relative error of about ε·√cond(S).
/// @param rows m×d, whitened measurement rows
/// @cost a singular value decomposition; allocates.
[[nodiscard]] DELOS_API SpectralForm spectral_form_of_rows(
    const CoordinateMatrix& L, const Eigen::Ref<const Eigen::MatrixXd>& rows);

/// P∞(block i,j) = L U diag(f_ij(λ)) Uᵀ Lᵀ, n×n with n = d·k.
///
/// Unobservable directions contribute nothing, and the rest is projected orthogonally
/// to them: finite entries are right for every combination of states that avoids them.
/// Source: theory in docs/theory.md, section "Exact spectral reduction".
[[nodiscard]] DELOS_API StateMatrix spectral_covariance(const SpectralForm& form,
                                                        int order,
                                                        const Sampling& sampling,
                                                        CovarianceKind kind);

/// The pose block (0, 0) of spectral_covariance() alone, d×d: what position metrics
/// need.
[[nodiscard]] DELOS_API CoordinateMatrix spectral_pose_covariance(
    const SpectralForm& form, int order, const Sampling& sampling, CovarianceKind kind);

/// spectral_pose_covariance() of kLanes poses side by side, several times as fast; up
/// to rounding the same. Each pose's numbers depend on its own alone.
/// @param S information, packed as model/lanes.h says
/// @param[out] P likewise; unspecified where directions are lost
/// @param[out] lost kLanes numbers: how many directions of the pose are unobservable;
/// −1:
///             none, but one is known so much worse than another that a formed S has
///             lost its digits, which spectral_form_of_rows() keeps
DELOS_API void spectral_pose_covariances(const CoordinateMatrix& L, int order,
                                         const Sampling& sampling, CovarianceKind kind,
                                         const double* S, double* P, int* lost);

/// ∂J/∂S for an objective with ∂J/∂P∞ = Y, by Daleckii–Krein run backwards:
///
///     ∂J/∂S = Σ_ij L U [Γ^ij ∘ (Uᵀ Lᵀ Y_ij L U)] Uᵀ Lᵀ,
///     Γ^ij_ab = (f_ij(λ_a) − f_ij(λ_b))/(λ_a − λ_b),  Γ^ij_aa = f_ij′(λ_a)
///
/// @param Y n×n, symmetric
/// @pre form.unobservable == 0
/// @returns d×d, symmetric
[[nodiscard]] DELOS_API CoordinateMatrix spectral_gradient(const SpectralForm& form,
                                                           int order,
                                                           const Sampling& sampling,
                                                           CovarianceKind kind,
                                                           const StateMatrix& Y);

}  // namespace delos
