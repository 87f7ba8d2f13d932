// The exact spectral reduction: forms and covariances.
#include "delos/riccati/spectral.h"

#include "model/jacobi.h"
#include "riccati/directions.h"
#include "riccati/dispatch.h"
#include "riccati/exposed_chain.h"

namespace delos {
namespace {

using riccati::any_chain_values;
using riccati::fixed;
using riccati::Square;

template <int kSize>
SpectralForm reduce(const CoordinateMatrix& L, const CoordinateMatrix& S) {
  const auto factor = fixed<kSize>(L);
  const Square<kSize> M = factor.transpose() * (fixed<kSize>(S) * factor).eval();
  const auto eigen = jacobi_eigen<kSize>(M);

  SpectralForm form;
  form.lambda = eigen.lambda;
  form.LU = factor * eigen.U;
  const double least = riccati::kLeastEigenvalue<kSize> * eigen.lambda[kSize - 1];
  // "not above" also takes S = 0, and a matrix of NaNs.
  while (form.unobservable < kSize && !(form.lambda[form.unobservable] > least))
    form.lambda[form.unobservable++] = 0;
  return form;
}

/// Σ_a f(λ_a) v_a v_aᵀ for every block; P is K×K blocks of d×d, symmetric like their
/// blocks, of which only the upper triangles are summed.
template <int kSize, int kOrder>
StateMatrix covariance(const SpectralForm& form, const Sampling& sampling,
                       CovarianceKind kind) {
  constexpr int kState = kSize * kOrder, kEntries = kSize * (kSize + 1) / 2;
  const Square<kSize> V = riccati::observed_directions<kSize>(form);
  riccati::ChainTerms<kOrder> f[kSize] = {};  // lost directions add nothing
  double outer[kSize][kEntries];
  for (int a = 0; a < kSize; ++a) {
    if (a >= form.unobservable)
      f[a] = any_chain_values<kOrder, false>(sampling, form.lambda[a], kind);
    for (int c = 0, entry = 0; c < kSize; ++c)
      for (int r = 0; r <= c; ++r) outer[a][entry++] = V(r, a) * V(c, a);
  }
  StateMatrix P(kState, kState);
  Eigen::Map<Square<kState>> out(P.data());
  for (int i = 0, term = 0; i < kOrder; ++i) {
    for (int j = i; j < kOrder; ++j, ++term) {
      double sum[kEntries] = {};
      for (int a = 0; a < kSize; ++a)
        for (int entry = 0; entry < kEntries; ++entry)
          sum[entry] += f[a].value[term] * outer[a][entry];
      for (int c = 0, entry = 0; c < kSize; ++c) {
        for (int r = 0; r <= c; ++r, ++entry) {
          out(i * kSize + r, j * kSize + c) = out(i * kSize + c, j * kSize + r) =
              sum[entry];
          out(j * kSize + r, i * kSize + c) = out(j * kSize + c, i * kSize + r) =
              sum[entry];
        }
      }
    }
  }
  return P;
}

template <int kSize, int kOrder>
CoordinateMatrix pose_covariance(const SpectralForm& form, const Sampling& sampling,
                                 CovarianceKind kind) {
  const Square<kSize> V = riccati::observed_directions<kSize>(form);
  Square<kSize> P = Square<kSize>::Zero();
  for (int a = form.unobservable; a < kSize; ++a) {
    const double f =
        any_chain_values<kOrder, false>(sampling, form.lambda[a], kind).value[0];
    P += f * V.col(a) * V.col(a).transpose();
  }
  return P;
}

}  // namespace

SpectralForm spectral_form(const CoordinateMatrix& L, const CoordinateMatrix& S) {
  return riccati::with_coordinates(S.rows(),
                                   [&]<int kSize>() { return reduce<kSize>(L, S); });
}

StateMatrix spectral_covariance(const SpectralForm& form, int order,
                                const Sampling& sampling, CovarianceKind kind) {
  return riccati::with_coordinates(form.LU.rows(), [&]<int kSize>() {
    return riccati::with_order(order, [&]<int kOrder>() {
      return covariance<kSize, kOrder>(form, sampling, kind);
    });
  });
}

CoordinateMatrix spectral_pose_covariance(const SpectralForm& form, int order,
                                          const Sampling& sampling,
                                          CovarianceKind kind) {
  return riccati::with_coordinates(form.LU.rows(), [&]<int kSize>() {
    return riccati::with_order(order, [&]<int kOrder>() {
      return pose_covariance<kSize, kOrder>(form, sampling, kind);
    });
  });
}

}  // namespace delos
