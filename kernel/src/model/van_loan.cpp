#include "model/van_loan.h"

#include <algorithm>
#include <cmath>

namespace delos {
namespace {

/// Halvings of dt until the series below is short, ‖A‖ h ≤ 1/4 by rows and columns.
int halvings(const StateMatrix& A, double dt) {
  const auto entries = A.cwiseAbs();
  const double size =
      4 * dt *
      std::max(entries.colwise().sum().maxCoeff(), entries.rowwise().sum().maxCoeff());
  if (!(size > 1)) return 0;
  int exponent = 0;
  std::frexp(size, &exponent);
  return exponent;
}

/// Both blocks over a short time, by their series:
///
///     Φ = Σ_k F_k,  F₀ = I,   F_k = F_{k−1} A h/k
///     Q = Σ_k T_k,  T₀ = Q h, T_k = (A T_{k−1} + (A T_{k−1})ᵀ) h/(k+1)
MotionStep series(const StateMatrix& A, const StateMatrix& Q, double h) {
  constexpr int kTerms = 16;  // (2 ‖A‖ h)^16/17! < 1e-19
  StateMatrix F = StateMatrix::Identity(A.rows(), A.cols()), T = h * Q;
  MotionStep sum{F, T};
  for (int k = 1; k <= kTerms; ++k) {
    F = (h / k * F.lazyProduct(A)).eval();
    const StateMatrix AT = A.lazyProduct(T);
    T = h / (k + 1) * (AT + AT.transpose());
    sum.A += F;
    sum.Q += T;
  }
  return sum;
}

}  // namespace

MotionStep van_loan(const StateMatrix& A, const StateMatrix& Q, double dt) {
  const int doublings = halvings(A, dt);
  MotionStep step = series(A, Q, std::ldexp(dt, -doublings));
  for (int j = 0; j < doublings; ++j) {
    const StateMatrix spread = step.A.lazyProduct(step.Q);
    step.Q += spread.lazyProduct(step.A.transpose()).eval();
    step.Q = ((step.Q + step.Q.transpose()) / 2).eval();
    step.A = step.A.lazyProduct(step.A).eval();
  }
  return step;
}

}  // namespace delos
