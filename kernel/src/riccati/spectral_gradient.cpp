// The adjoint of the spectral reduction.
#include <cmath>

#include "delos/riccati/spectral.h"
#include "riccati/directions.h"
#include "riccati/dispatch.h"
#include "riccati/exposed_chain.h"

namespace delos {
namespace {

using riccati::any_chain_values;
using riccati::Square;

/// Below this relative distance of two eigenvalues the divided difference is f′ at
/// their midpoint. f behaves as a sum of powers λ^−p with p < 2, for which the midpoint
/// is wrong by f‴δ²λ²/(24 f′) < δ²/2 relative, and the quotient by about 2ε/δ: both are
/// some 1e-10 at δ = 1e-5, where they meet.
constexpr double kNearlyEqual = 1e-5;

template <int kSize, int kOrder>
CoordinateMatrix gradient(const SpectralForm& form, const Sampling& sampling,
                          CovarianceKind kind, const StateMatrix& Y) {
  if (form.unobservable != 0) std::abort();
  const auto& lambda = form.lambda;
  riccati::ChainTerms<kOrder> f[kSize];
  for (int a = 0; a < kSize; ++a)
    f[a] = any_chain_values<kOrder, true>(sampling, lambda[a], kind);

  // G = Σ_ij Γ^ij ∘ Z_ij with Z_ij = (LU)ᵀ Y_ij (LU). Γ^ij = Γ^ji, so pairs are taken
  // once.
  const auto LU = riccati::fixed<kSize>(form.LU);
  Square<kSize> Z[kOrder * (kOrder + 1) / 2];
  for (int i = 0, entry = 0; i < kOrder; ++i) {
    for (int j = i; j < kOrder; ++j, ++entry) {
      const Square<kSize> block = Y.block<kSize, kSize>(i * kSize, j * kSize);
      Z[entry] = LU.transpose() * block * LU;
      if (i != j) Z[entry] += Z[entry].transpose().eval();
    }
  }
  Square<kSize> G = Square<kSize>::Zero();
  for (int a = 0; a < kSize; ++a) {
    for (int b = 0; b <= a; ++b) {
      const double gap = lambda[a] - lambda[b], middle = lambda[b] + gap / 2;
      const bool near = std::abs(gap) <= kNearlyEqual * middle;
      riccati::ChainTerms<kOrder> mid = f[a];
      if (near && a != b) mid = any_chain_values<kOrder, true>(sampling, middle, kind);
      for (int entry = 0; entry < kOrder * (kOrder + 1) / 2; ++entry) {
        const double quotient =
            near ? mid.slope[entry] : (f[a].value[entry] - f[b].value[entry]) / gap;
        G(a, b) += quotient * (Z[entry](a, b) + Z[entry](b, a)) / 2;
      }
      G(b, a) = G(a, b);
    }
  }
  const Square<kSize> J = LU * G * LU.transpose();
  return (J + J.transpose()) / 2;
}

}  // namespace

CoordinateMatrix spectral_gradient(const SpectralForm& form, int order,
                                   const Sampling& sampling, CovarianceKind kind,
                                   const StateMatrix& Y) {
  return riccati::with_coordinates(form.LU.rows(), [&]<int kSize>() {
    return riccati::with_order(order, [&]<int kOrder>() {
      return gradient<kSize, kOrder>(form, sampling, kind, Y);
    });
  });
}

}  // namespace delos
