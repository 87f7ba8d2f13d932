// A system that is d scalar chains.
#pragma once

#include "delos/riccati/spectral.h"
#include "delos/rig/system.h"
#include "delos/steady/steady_solver.h"

namespace delos {

/// Whether pose-level measurements of a chain, at one rate or all the time, are all
/// that the system has.
[[nodiscard]] bool is_reducible(const System& system);

/// The spectral reduction of one system: riccati/spectral.h.
struct ChainReduction {
  /// @pre is_reducible()
  explicit ChainReduction(const System& system);

  /// Of the sum of all information, or of the single readings where that has lost its
  /// digits and they are known.
  [[nodiscard]] SpectralForm form_of(const SteadyEquation& at) const;
  void solve(const SpectralForm& form, const SteadyRequest& request,
             FusedState& out) const;
  /// spectral_gradient() of the system's kind of covariance.
  [[nodiscard]] StateMatrix adjoint(const SpectralForm& form,
                                    const StateMatrix& Y) const;
  /// spectral_pose_covariances() of the system's kind of covariance.
  void pose_covariances(const LayerBlock& block, double* P, int* lost) const;

  CoordinateMatrix L;  ///< q = L Lᵀ
  int order;
  Sampling sampling;
  CovarianceKind kind;
};

}  // namespace delos
