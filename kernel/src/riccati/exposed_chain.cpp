// The exposed chain: its steady state by doubling, its slope and its slowest pole.
#include "riccati/exposed_chain.h"

#include <algorithm>
#include <cmath>

#include "delos/model/infinity.h"
#include "delos/riccati/chain.h"
#include "riccati/dispatch.h"
#include "riccati/linear.h"
#include "riccati/update_map.h"

namespace delos {
namespace riccati {
namespace {

template <int k>
using ChainSquare = Eigen::Matrix<double, k, k>;
template <int k>
using ChainColumn = Eigen::Matrix<double, k, 1>;

constexpr double factorial_of(int n) { return n <= 1 ? 1 : n * factorial_of(n - 1); }

/// What a reading makes of a covariance before it.
template <int k>
struct ReadChain {
  ChainColumn<k> covaried;  // with what is read, without v
  double variance;          // of what is read, times λ, and 1 of v
  ChainSquare<k> keep;      // I − K h
  ChainSquare<k> after;
};

template <int k>
struct ExposedChain {
  double length;  // the unit of time, seconds
  double lambda;  // in that unit
  ChainSquare<k> A, Q;
  ChainColumn<k> h, N;
  double R;  // of η

  ExposedChain(const Sampling& sampling, double information);

  /// With C = P hᵀ + N, m = 1 + λ (h P hᵀ + 2 h N + R_η) and K = λ C/m, in Joseph's
  /// form,
  ///
  ///     Π = (I − K h) P (I − K h)ᵀ − (I − K h) N Kᵀ − K Nᵀ (I − K h)ᵀ
  ///         + K (R_η + 1/λ) Kᵀ
  [[nodiscard]] ReadChain<k> read(const ChainSquare<k>& P) const {
    ReadChain<k> out;
    const ChainColumn<k> Ph = P * h;
    out.covaried = Ph + N;
    out.variance = 1 + lambda * std::max(0.0, h.dot(Ph) + 2 * h.dot(N) + R);
    const ChainColumn<k> g = out.covaried / out.variance, K = lambda * g;
    out.keep = ChainSquare<k>::Identity() - K * h.transpose();
    const ChainSquare<k> crossed = out.keep * N * K.transpose();
    const ChainSquare<k> after = out.keep * P * out.keep.transpose() - crossed -
                                 crossed.transpose() +
                                 (lambda * lambda * R + lambda) * g * g.transpose();
    out.after = (after + after.transpose()) / 2;
    return out;
  }

  /// The posterior that an update leaves as it is.
  ///
  /// One update takes Π to H + A_s Π (I + G Π)⁻¹ A_sᵀ (update_map.h), where the state
  /// before was known and P = Q: A_s = (I − K h) A, G = Aᵀ hᵀ h A λ/m, and H the Π of
  /// that.
  [[nodiscard]] ChainSquare<k> steady_posterior() const {
    const ReadChain<k> first = read(Q);
    const ChainColumn<k> seen = A.transpose() * h;
    BasicUpdateMap<ChainSquare<k>> map{
        first.keep * A, seen * seen.transpose() * (lambda / first.variance),
        first.after};
    constexpr int kMaxDoublings = 64;
    for (int doublings = 0; doublings < kMaxDoublings; ++doublings) {
      const ChainColumn<k> before = map.H.diagonal();
      map = compose(map, map);
      const auto added = (map.H.diagonal() - before).array();
      const double carried = map.A.cwiseAbs().maxCoeff();
      if ((added <= 1e-16 * before.array()).all() && carried <= 1e-8) break;
      if (!std::isfinite(carried)) break;
    }
    return map.H;
  }

  [[nodiscard]] ChainSquare<k> prior(const ChainSquare<k>& posterior) const {
    const ChainSquare<k> P = A * posterior * A.transpose() + Q;
    return (P + P.transpose()) / 2;
  }
};

template <int k>
ExposedChain<k>::ExposedChain(const Sampling& sampling, double information)
    : length(
          std::max(sampling.dt, 1 / butterworth_radius<k>(information / sampling.dt))),
      lambda(information * power(length, 2 * k - 1)),
      A(ChainSquare<k>::Zero()) {
  const double dt = sampling.dt / length, tau = sampling.exposure / length;
  for (int i = 0; i < k; ++i) {
    for (int j = 0; j < k; ++j) {
      const int p = 2 * k - 1 - i - j;
      if (j >= i) A(i, j) = power(dt, j - i) / factorial_of(j - i);
      Q(i, j) = power(dt, p) / (p * factorial_of(k - 1 - i) * factorial_of(k - 1 - j));
    }
    h(i) = power(-tau, i) / factorial_of(i + 1);
    N(i) = (k % 2 ? -1 : 1) * power(tau, 2 * k - 1 - i) / factorial_of(2 * k - i);
  }
  R = power(tau, 2 * k - 1) / ((2 * k + 1) * factorial_of(k) * factorial_of(k));
  if (sampling.model == ExposureModel::exact) return;
  h = ChainColumn<k>::UnitX();
  N.setZero();
  R = motion_variance(sampling.model, k, sampling.exposure) / power(length, 2 * k - 1);
}

/// X = Σ_t Fᵗ Y (Fᵗ)ᵀ, by doubling.
template <int k>
ChainSquare<k> summed(ChainSquare<k> F, ChainSquare<k> X) {
  constexpr int kMaxDoublings = 64;
  for (int i = 0; i < kMaxDoublings; ++i) {
    const ChainSquare<k> more = F * X * F.transpose();
    X += more;
    if (!(more.norm() > 1e-17 * X.norm())) break;
    F = (F * F).eval();
  }
  return (X + X.transpose()) / 2;
}

template <int k>
double slowest_pole(const ExposedChain<k>& chain) {
  const ChainSquare<k> keep = chain.read(chain.prior(chain.steady_posterior())).keep;
  return eigenvalues(StateMatrix(keep * chain.A)).cwiseAbs().maxCoeff();
}

}  // namespace

template <int kOrder, bool kSlopes>
ChainTerms<kOrder> exposed_values(const Sampling& sampling, double lambda,
                                  CovarianceKind kind) {
  constexpr int kTop = 2 * kOrder - 1;
  ChainTerms<kOrder> f{};
  if (!(lambda > 0)) {
    std::fill_n(f.value, kOrder * (kOrder + 1) / 2, kInfinity);
    return f;
  }
  const bool of_prior = kind == CovarianceKind::prior;
  const ExposedChain<kOrder> chain(sampling, lambda);
  const ChainSquare<kOrder> posterior = chain.steady_posterior();
  const ChainSquare<kOrder> P = chain.prior(posterior);
  // ∂Π/∂λ = F ∂Π/∂λ Fᵀ − g gᵀ with F = (I − K h) A and g = K/λ: the best gain moves
  // nothing.
  ChainSquare<kOrder> slope = ChainSquare<kOrder>::Zero();
  if constexpr (kSlopes) {
    const ReadChain<kOrder> read = chain.read(P);
    const ChainColumn<kOrder> g = read.covaried / read.variance;
    slope = -summed<kOrder>(read.keep * chain.A, g * g.transpose());
    if (of_prior) slope = (chain.A * slope * chain.A.transpose()).eval();
  }
  const ChainSquare<kOrder>& value = of_prior ? P : posterior;
  const double of_lambda = power(chain.length, kTop);
  for (int i = 0, entry = 0; i < kOrder; ++i) {
    for (int j = i; j < kOrder; ++j, ++entry) {
      const double scale = power(chain.length, kTop - i - j);
      f.value[entry] = value(i, j) * scale;
      f.slope[entry] = slope(i, j) * scale * of_lambda;
    }
  }
  return f;
}

template ChainTerms<1> exposed_values<1, false>(const Sampling&, double,
                                                CovarianceKind);
template ChainTerms<2> exposed_values<2, false>(const Sampling&, double,
                                                CovarianceKind);
template ChainTerms<3> exposed_values<3, false>(const Sampling&, double,
                                                CovarianceKind);
template ChainTerms<1> exposed_values<1, true>(const Sampling&, double, CovarianceKind);
template ChainTerms<2> exposed_values<2, true>(const Sampling&, double, CovarianceKind);
template ChainTerms<3> exposed_values<3, true>(const Sampling&, double, CovarianceKind);

}  // namespace riccati

double exposed_chain_time_constant(int order, double dt, double exposure, double lambda,
                                   ExposureModel model) {
  if (exposure == 0) return discrete_chain_time_constant(order, dt, lambda);
  return riccati::with_order(order, [&]<int k>() {
    const riccati::ExposedChain<k> chain({false, dt, exposure, model}, lambda);
    return -dt / std::log(riccati::slowest_pole(chain));
  });
}

}  // namespace delos
