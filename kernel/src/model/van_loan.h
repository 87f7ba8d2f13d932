// A linear model in continuous time over a time dt.
#pragma once

#include "delos/model/motion.h"

namespace delos {

/// The step of dx/dt = A x + w, w white of spectral density Q, over dt:
///
///     Φ = exp(A dt),  Q_dt = ∫₀^dt exp(A s) Q exp(A s)ᵀ ds
///
/// the blocks of the exponential of [−A, Q; 0, Aᵀ] dt. Scaled and squared: the series
/// of both blocks over h = dt/2ʲ, then j times Φ(2h) = Φ², Q(2h) = Φ Q Φᵀ + Q, which
/// adds what is ≥ 0 and so keeps its digits where A dt is large.
///
/// Source: Van Loan (1978), IEEE Trans. Automatic Control 23(3), 395–404,
///         doi:10.1109/TAC.1978.1101743; scaling and squaring of the integral: §III.
/// @param A, Q n×n; Q symmetric ≥ 0
/// @param dt seconds, > 0
/// @cost O(n³) a doubling; no heap. Infinite where exp(A dt) is.
[[nodiscard]] MotionStep van_loan(const StateMatrix& A, const StateMatrix& Q,
                                  double dt);

}  // namespace delos
