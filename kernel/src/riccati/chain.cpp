// The scalar chain behind its public signatures: see chain_terms.h for the formulas.
#include "delos/riccati/chain.h"

#include <algorithm>
#include <complex>
#include <cstdlib>

#include "riccati/chain_terms.h"
#include "riccati/exposed_chain.h"
#include "riccati/linear.h"

namespace delos {
namespace {

using riccati::any_chain_values;
using riccati::butterworth_radius;
using riccati::chain_values;

template <int kOrder>
ChainMatrix unpack(const double* upper) {
  ChainMatrix m(kOrder, kOrder);
  for (int i = 0; i < kOrder; ++i)
    for (int j = i; j < kOrder; ++j) m(i, j) = m(j, i) = *upper++;
  return m;
}

template <int kOrder, bool kSlopes>
ChainSolution solve(const Sampling& sampling, double lambda, CovarianceKind kind) {
  const auto f = any_chain_values<kOrder, kSlopes>(sampling, lambda, kind);
  ChainSolution solution;
  solution.covariance = unpack<kOrder>(f.value);
  if constexpr (kSlopes) solution.derivative = unpack<kOrder>(f.slope);
  return solution;
}

template <bool kSlopes>
ChainSolution solve(int order, const Sampling& sampling, double lambda,
                    CovarianceKind kind) {
  if (order == 1) return solve<1, kSlopes>(sampling, lambda, kind);
  if (order == 2) return solve<2, kSlopes>(sampling, lambda, kind);
  if (order == 3) return solve<3, kSlopes>(sampling, lambda, kind);
  std::abort();
}

/// −ln|z| of z = (1 + s)/(1 − s): atanh keeps the digits of poles close to the unit
/// circle.
double decay(std::complex<double> s) {
  return std::atanh(std::min(1.0, -2 * s.real() / (1 + std::norm(s))));
}

/// Slowest decay per update of a chain of order 2, whose factor in the bilinear
/// variable is 1 + 2√u s + 2v s² (v and u of chain_terms_2).
double slowest_decay_2(double e) {
  const double v = std::sqrt(1.0 / 12 + e), u = 1.0 / 3 + v;
  const std::complex<double> split = std::sqrt(std::complex<double>(1.0 / 3 - v));
  const std::complex<double> far = -(std::sqrt(u) + split) / (2 * v);
  const std::complex<double> near =
      1.0 / (2 * v * far);  // the product of both is 1/(2v)
  return std::min(decay(far), decay(near));
}

/// The same of order 3: the roots of 1 + w s + (w²/2 − 1) s² + a s³ as eigenvalues of
/// its companion matrix, in the variable ∛a s whose polynomial has coefficients near
/// one.
double slowest_decay_3(double e) {
  const double a = std::sqrt(e + 2.0 / 15), t = std::cbrt(a);
  const double w = riccati::chain_root_3(a);
  Eigen::Matrix3d companion;
  companion << -(w * w / 2 - 1) / (t * t), -w / t, -1, 1, 0, 0, 0, 1, 0;
  const auto roots = riccati::eigenvalues(companion);
  return std::min({decay(roots[0] / t), decay(roots[1] / t), decay(roots[2] / t)});
}

}  // namespace

ChainSolution discrete_chain(int order, double dt, double lambda, CovarianceKind kind) {
  return solve<false>(order, {false, dt}, lambda, kind);
}

ChainSolution discrete_chain_with_derivative(int order, double dt, double lambda,
                                             CovarianceKind kind) {
  return solve<true>(order, {false, dt}, lambda, kind);
}

double discrete_chain_variance(int order, double dt, double lambda,
                               CovarianceKind kind) {
  const Sampling sampling{false, dt};
  if (order == 1) return chain_values<1, false>(sampling, lambda, kind).value[0];
  if (order == 2) return chain_values<2, false>(sampling, lambda, kind).value[0];
  if (order == 3) return chain_values<3, false>(sampling, lambda, kind).value[0];
  std::abort();
}

ChainSolution exposed_chain(int order, double dt, double exposure, double lambda,
                            CovarianceKind kind) {
  return solve<false>(order, {false, dt, exposure}, lambda, kind);
}

ChainSolution exposed_chain_with_derivative(int order, double dt, double exposure,
                                            double lambda, CovarianceKind kind) {
  return solve<true>(order, {false, dt, exposure}, lambda, kind);
}

ChainSolution continuous_chain(int order, double rate) {
  return solve<false>(order, {true, 0}, rate, CovarianceKind::prior);
}

ChainSolution continuous_chain_with_derivative(int order, double rate) {
  return solve<true>(order, {true, 0}, rate, CovarianceKind::prior);
}

double discrete_chain_time_constant(int order, double dt, double lambda) {
  const double rho = riccati::power(dt, 2 * order - 1) * lambda;
  if (order == 1) {
    // The pole is 1/(1 + λP).
    return dt / std::log1p(lambda * discrete_chain_variance(1, dt, lambda,
                                                            CovarianceKind::prior));
  }
  if (order == 2) return dt / slowest_decay_2(riccati::kChainScale<2> / rho);
  if (order == 3) return dt / slowest_decay_3(riccati::kChainScale<3> / rho);
  std::abort();
}

double continuous_chain_time_constant(int order, double rate) {
  // The Butterworth poles closest to the imaginary axis: −ω, ω e^(±3πi/4), ω
  // e^(±2πi/3).
  if (order == 1) return 1 / butterworth_radius<1>(rate);
  if (order == 2) return std::sqrt(2.0) / butterworth_radius<2>(rate);
  if (order == 3) return 2 / butterworth_radius<3>(rate);
  std::abort();
}

}  // namespace delos
