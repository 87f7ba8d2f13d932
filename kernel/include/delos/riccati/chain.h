// The scalar integrator chain: its steady-state covariance in closed form.
//
// Everything that a pose-only field needs of the Riccati equation is here: after the
// spectral reduction (spectral.h) only d scalar problems are left.
#pragma once

#include <Eigen/Core>

#include "delos/api.h"
#include "delos/model/covariance_kind.h"
#include "delos/model/exposure_model.h"

namespace delos {

/// k×k covariance or derivative of a scalar chain, k ≤ 3, stored inline.
using ChainMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

/// Steady-state covariance of the chain of one coordinate, driven by unit white noise.
///
/// The chain of order k with q = 1, measured every dt with variance 1/λ, or, for
/// `continuous_chain`, measured continuously with information rate λ. Computed from
/// sums of positive terms only, so that no digits are lost at any ratio ρ = dt^(2k−1) λ
/// of process to measurement noise.
struct ChainSolution {
  ChainMatrix covariance;  ///< k×k: f_ij(λ)
  ChainMatrix
      derivative;  ///< k×k: f_ij′(λ), filled only by the *_with_derivative calls
};

/// @param order  k, 1 to 3
/// @param dt     update period, seconds, > 0
/// @param lambda information of one update, > 0
/// @returns the covariance; `derivative` is left empty (0×0).
/// @cost  a few square roots; k = 3 adds a cube root and two Halley steps. No heap.
/// Source: k = 1, 2: Kalata (1984), doi:10.1109/TAES.1984.310438, rewritten without
///         cancellation; k = 3: spectral factorisation in the bilinear variable,
///         chain_terms.h.
[[nodiscard]] DELOS_API ChainSolution discrete_chain(int order, double dt,
                                                     double lambda,
                                                     CovarianceKind kind);

/// Like discrete_chain(), with f′(λ).
[[nodiscard]] DELOS_API ChainSolution discrete_chain_with_derivative(
    int order, double dt, double lambda, CovarianceKind kind);

/// The variance f_00 alone of discrete_chain(): what position metrics need.
[[nodiscard]] DELOS_API double discrete_chain_variance(int order, double dt,
                                                       double lambda,
                                                       CovarianceKind kind);

/// The chain whose readings are its mean over the `exposure` seconds that end at each
/// update, the instant that the covariance is of; 0: discrete_chain() to the last bit.
/// @param exposure τ, seconds, 0 ≤ τ ≤ dt
/// Relative errors are some 1e-16 for each update that the filter remembers.
/// @cost a doubling of k×k matrices, typically 5 to 12 times. No heap.
/// Source: riccati/exposed_chain.h
[[nodiscard]] DELOS_API ChainSolution exposed_chain(int order, double dt,
                                                    double exposure, double lambda,
                                                    CovarianceKind kind);

/// Like exposed_chain(), with f′(λ).
[[nodiscard]] DELOS_API ChainSolution exposed_chain_with_derivative(
    int order, double dt, double exposure, double lambda, CovarianceKind kind);

/// Steady state under continuous measurement: f_00 = λ^(−1/2), √2 λ^(−3/4), 2 λ^(−5/6).
/// @param rate information per second, λ, > 0
[[nodiscard]] DELOS_API ChainSolution continuous_chain(int order, double rate);

/// Like continuous_chain(), with f′(λ).
[[nodiscard]] DELOS_API ChainSolution continuous_chain_with_derivative(int order,
                                                                       double rate);

/// Time constant of the slowest closed-loop pole of A − KH, seconds: −dt/ln ρ(A − KH).
[[nodiscard]] DELOS_API double discrete_chain_time_constant(int order, double dt,
                                                            double lambda);
/// The same of exposed_chain().
[[nodiscard]] DELOS_API double exposed_chain_time_constant(
    int order, double dt, double exposure, double lambda,
    ExposureModel model = ExposureModel::exact);
/// The same under continuous measurement: −1/max Re(pole).
[[nodiscard]] DELOS_API double continuous_chain_time_constant(int order, double rate);

}  // namespace delos
