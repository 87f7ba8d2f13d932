// The directions of a spectral form that carry finite variance.
#pragma once

#include <Eigen/Core>
#include <limits>

#include "delos/riccati/spectral.h"

namespace delos::riccati {

template <int kSize>
using Square = Eigen::Matrix<double, kSize, kSize>;

/// A view of a d×d coordinate matrix as one of fixed size; inline storage is
/// contiguous.
template <int kSize>
Eigen::Map<const Square<kSize>> fixed(const CoordinateMatrix& m) {
  return Eigen::Map<const Square<kSize>>(m.data());
}

/// Eigenvalues up to this part of the largest count as lost: below it, they are the
/// rounding of the sum that formed S, not information.
template <int kSize>
inline constexpr double kLeastEigenvalue =
    16 * kSize* std::numeric_limits<double>::epsilon();

/// The columns of L U, with those behind the lost ones projected orthogonally to the
/// lost.
///
/// The covariance is Σ_a f(λ_a) v_a v_aᵀ over columns v_a with f = ∞ for the lost.
/// Along any w ⊥ lost, wᵀ P w is the sum over the rest: what is returned sums to
/// exactly that.
template <int kSize>
Square<kSize> observed_directions(const SpectralForm& form) {
  Square<kSize> V = fixed<kSize>(form.LU);
  for (int a = 0; a < form.unobservable; ++a) {
    // Modified Gram–Schmidt; the lost columns of an ill-conditioned L may be nearly
    // parallel, for which twice is enough.
    for (int pass = 0; pass < 2; ++pass)
      for (int b = 0; b < a; ++b) V.col(a) -= V.col(b) * V.col(b).dot(V.col(a));
    V.col(a).normalize();
  }
  for (int a = form.unobservable; a < kSize; ++a)
    for (int b = 0; b < form.unobservable; ++b)
      V.col(a) -= V.col(b) * V.col(b).dot(V.col(a));
  return V;
}

}  // namespace delos::riccati
