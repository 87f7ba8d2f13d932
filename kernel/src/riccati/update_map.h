// Filter updates as maps of covariances that compose.
//
// One update, or any number of them in a row, takes the posterior Π to
//
//     Π′ = H + A Π (I + G Π)⁻¹ Aᵀ
//
// A: how errors that the updates leave alone carry over; G: what the updates together
// say about the state before them; H: the covariance after them if that state was
// known. Source: Särkkä, García-Fernández (2021), IEEE TAC 66(1), 299–306,
//         doi:10.1109/TAC.2020.2976316, in terms of S = Hᵀ R⁻¹ H.
#pragma once

#include <Eigen/LU>

#include "delos/riccati/riccati.h"
#include "riccati/linear.h"

namespace delos::riccati {

template <class Matrix>
struct BasicUpdateMap {
  Matrix A, G, H;
};
using UpdateMap = BasicUpdateMap<StateMatrix>;

/// Motion, then measurement.
/// @param[out] regular false where an exact row sees a direction that this step's noise
///             does not drive: the map then has no finite G, and must not be used.
UpdateMap one_update(const MotionStep& motion, const Measurement& measurement,
                     bool& regular);

/// `first`, then `second`. With W = I + H₁ G₂:
///     A = A₂ W⁻¹ A₁,  G = G₁ + A₁ᵀ G₂ W⁻¹ A₁,  H = H₂ + A₂ W⁻¹ H₁ A₂ᵀ
template <class Matrix>
BasicUpdateMap<Matrix> compose(const BasicUpdateMap<Matrix>& first,
                               const BasicUpdateMap<Matrix>& second) {
  const Eigen::Index n = first.A.rows();
  const Eigen::PartialPivLU<Matrix> W(Matrix::Identity(n, n) + first.H * second.G);
  const Matrix carried = W.solve(first.A), left = W.solve(first.H);
  const Matrix seen = second.G * carried, pushed = second.A * left;
  BasicUpdateMap<Matrix> both;
  both.A.noalias() = second.A * carried;
  both.G.noalias() = first.A.transpose() * seen;
  both.H.noalias() = pushed * second.A.transpose();
  both.G = (first.G + (both.G + both.G.transpose()) / 2).eval();
  both.H = (second.H + (both.H + both.H.transpose()) / 2).eval();
  return both;
}

/// What conditions a covariance on exact rows C, which may depend on each other:
/// L = H Cᵀ M⁺ with M = C H Cᵀ.
struct ExactGain {
  StateMatrix L;
  PseudoInverse M;
};
ExactGain exact_gain(const StateMatrix& H, const StateMatrix& C);

/// P = A Π Aᵀ + Q.
StateMatrix predict(const MotionStep& motion, const StateMatrix& posterior);

/// ∏ (I − k h) over rows that are worked in one after another: the share of an error
/// that they leave. @param before the covariance before the first
StateMatrix kept_by_rows(const StateMatrix& before, const Eigen::MatrixXd& rows);

/// I − K H, the share of an error before an update that it leaves: (I + P S)⁻¹, then
/// ∏ (I − k h) and I − L E for the other rows.
StateMatrix kept(const StateMatrix& prior, const Measurement& measurement);

/// Π = (P⁻¹ + S)⁻¹, then conditioned on the other rows. P may be singular.
StateMatrix update(const StateMatrix& prior, const Measurement& measurement);

}  // namespace delos::riccati
