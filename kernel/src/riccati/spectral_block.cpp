// Pose covariances of many poses side by side: every step is a loop over kLanes poses
// without branches, which the compiler turns into vector instructions.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "delos/model/wide.h"
#include "delos/riccati/spectral.h"
#include "model/epsilon.h"
#include "model/jacobi.h"
#include "riccati/directions.h"
#include "riccati/dispatch.h"
#include "riccati/exposed_chain.h"

namespace delos {
namespace {

using riccati::Square;

/// M = LᵀSL on its way to Λ, and V = L on its way to L U.
template <int kSize>
struct Lanes {
  alignas(64) double M[kSize * (kSize + 1) / 2][kLanes];
  alignas(64) double V[kSize][kSize][kLanes];  ///< [row][column]
  alignas(64) double floor[kLanes];            ///< entries below it count as zero

  double* m(int i, int j) { return M[packed_index(std::max(i, j), std::min(i, j))]; }
};

template <int kSize>
void form(const CoordinateMatrix& L, const double* S, Lanes<kSize>& at) {
  double SL[kSize][kLanes];  // one column of S·L
  for (int j = 0; j < kSize; ++j) {
    for (int i = 0; i < kSize; ++i) {
      std::fill_n(SL[i], kLanes, 0.0);
      std::fill_n(at.V[i][j], kLanes, L(i, j));
      for (int k = j; k < kSize; ++k) {  // L is lower triangular
        const double* s = S + packed_index(std::max(i, k), std::min(i, k)) * kLanes;
        for (int l = 0; l < kLanes; ++l) SL[i][l] += s[l] * L(k, j);
      }
    }
    for (int i = 0; i <= j; ++i) {
      double* m = at.m(i, j);
      std::fill_n(m, kLanes, 0.0);
      for (int k = i; k < kSize; ++k) {
        for (int l = 0; l < kLanes; ++l) m[l] += L(k, i) * SL[k][l];
      }
    }
  }
  std::fill_n(at.floor, kLanes, 0.0);
  for (int i = 0; i < kSize; ++i) {
    const double* m = at.m(i, i);
    for (int l = 0; l < kLanes; ++l) {
      at.floor[l] = std::max(at.floor[l], kEps * kEps * std::abs(m[l]));
    }
  }
}

/// jacobi_rotate() of all lanes.
/// @returns whether any rotated
template <int p, int q, int kSize>
bool rotate(Lanes<kSize>& at) {
  double *mpp = at.m(p, p), *mqq = at.m(q, q), *mpq = at.m(p, q);
  double c[kLanes], s[kLanes], turned[kLanes];
  for (int l = 0; l < kLanes; ++l) {
    const double x = mpq[l], mp = mpp[l], mq = mqq[l];
    const bool needed =
        (x * x > kEps * kEps * std::abs(mp * mq)) & (std::abs(x) > at.floor[l]);
    const double h = mq - mp, y = 2 * x;
    const double u = h + std::copysign(std::sqrt(h * h + y * y), h);
    const double t = needed ? y / u : 0.0;
    c[l] = 1 / std::sqrt(1 + t * t);
    s[l] = t * c[l];
    mpp[l] = mp - t * x;
    mqq[l] = mq + t * x;
    mpq[l] = needed ? 0.0 : x;
    turned[l] = needed ? 1.0 : 0.0;
  }
  if (std::none_of(turned, turned + kLanes, [](double t) { return t > 0; }))
    return false;
  const auto turn = [&](double* a, double* b) {
    for (int l = 0; l < kLanes; ++l) {
      const double old = a[l];
      a[l] = c[l] * old - s[l] * b[l];
      b[l] = s[l] * old + c[l] * b[l];
    }
  };
  for (int i = 0; i < kSize; ++i) {
    if (i != p && i != q) turn(at.m(i, p), at.m(i, q));
    turn(at.V[i][p], at.V[i][q]);
  }
  return true;
}

/// @returns whether none of the lanes' matrices needs its factor
template <int kSize>
bool range_factors(const Lanes<kSize>& at, double* factor) {
  constexpr double kUp = 1 / (kEps * kEps);
  bool usual = true;
  for (int l = 0; l < kLanes; ++l) {
    factor[l] = range_factor(kUp * at.floor[l]);
    usual &= factor[l] == 1;
  }
  return usual;
}

template <int kSize>
void diagonalize(Lanes<kSize>& at) {
  constexpr static auto kOrder = rotation_order<kSize>();
  double factor[kLanes];
  const bool usual = range_factors(at, factor);
  for (int l = 0; l < kLanes && !usual; ++l) {
    for (auto& entry : at.M) entry[l] *= factor[l];
    at.floor[l] *= factor[l];
  }
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    const int rotations = [&]<std::size_t... i>(std::index_sequence<i...>) {
      return (0 + ... + rotate<kOrder[i].first, kOrder[i].second>(at));
    }
    (std::make_index_sequence<kOrder.size()>{});
    if (rotations == 0) break;
  }
  for (int i = 0; i < kSize && !usual; ++i) {
    for (int l = 0; l < kLanes; ++l) at.m(i, i)[l] /= factor[l];
  }
}

// P_p = Σ_a f(λ_a) v_a v_aᵀ with v_a the columns of L U.
template <int kSize, int kOrder>
void covariances(const CoordinateMatrix& L, const Sampling& sampling,
                 CovarianceKind kind, const double* S, double* P, int* lost) {
  Lanes<kSize> at;
  form(L, S, at);
  diagonalize(at);

  double largest[kLanes] = {}, least[kLanes];
  std::fill_n(least, kLanes, std::numeric_limits<double>::infinity());
  for (int a = 0; a < kSize; ++a) {
    const double* lambda = at.m(a, a);
    for (int l = 0; l < kLanes; ++l) {
      largest[l] = std::max(largest[l], lambda[l]);
      least[l] = std::min(least[l], lambda[l]);
    }
  }
  std::fill_n(lost, kLanes, 0);
  std::fill_n(P, kSize * (kSize + 1) / 2 * kLanes, 0.0);
  for (int a = 0; a < kSize; ++a) {
    const double* lambda = at.m(a, a);
    double f[kLanes];
    if (sampling.exposure > 0 || sampling.lag > 0) {
      for (int l = 0; l < kLanes; ++l) {
        f[l] = riccati::any_chain_values<kOrder, false>(sampling, lambda[l], kind)
                   .value[0];
      }
    } else {
      for (int l = 0; l < kLanes; ++l) {
        f[l] = riccati::chain_values<kOrder, false>(sampling, lambda[l], kind).value[0];
      }
    }
    for (int l = 0; l < kLanes; ++l) {
      // "not above" also takes S = 0, and a matrix of NaNs.
      if (!(lambda[l] > riccati::kLeastEigenvalue<kSize> * largest[l])) ++lost[l];
    }
    for (int i = 0; i < kSize; ++i) {
      for (int j = 0; j <= i; ++j) {
        const double *vi = at.V[i][a], *vj = at.V[j][a];
        double* out = P + packed_index(i, j) * kLanes;
        for (int l = 0; l < kLanes; ++l) out[l] += f[l] * vi[l] * vj[l];
      }
    }
  }
  for (int l = 0; l < kLanes; ++l) {
    const bool few = least[l] < SpectralForm::kFewDigits * largest[l];
    if (few & (lost[l] == 0)) lost[l] = -1;
  }
}

}  // namespace

void spectral_pose_covariances(const CoordinateMatrix& L, int order,
                               const Sampling& sampling, CovarianceKind kind,
                               const double* S, double* P, int* lost) {
  riccati::with_coordinates(L.rows(), [&]<int kSize>() {
    riccati::with_order(order, [&]<int kOrder>() {
      in_wide_vectors(
          [&] { covariances<kSize, kOrder>(L, sampling, kind, S, P, lost); });
    });
  });
}

}  // namespace delos
