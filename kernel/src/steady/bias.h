// What constant errors of calibration do to an estimate in the long run.
#pragma once

#include <optional>
#include <string>

#include "delos/model/state.h"
#include "delos/steady/equation.h"
#include "delos/steady/fused_state.h"
#include "observe/calibration.h"

namespace delos {

/// Empty where the bias of a system can be had; else why not.
[[nodiscard]] std::string bias_problem(const System& system);

/// S of all that an equation's only step measures, c×c, before it is solved.
/// @throws std::invalid_argument one sentence: rows without noise, beside which errors
///         of calibration have no weight
[[nodiscard]] StateMatrix information_of(const SteadyEquation& at);

/// The bias of a system's estimates, as a covariance B over all rigs of such errors.
///
/// Readings that are off by δz shift the estimate of a filter that doesn't know by e.
/// For a chain, where e stays (A e = e) and the gain is Π Hᵀ R⁻¹,
///
///     S e = G c,   B = S⁻¹ D S⁻¹,   D = Σ G C Gᵀ
///
/// of the pose alone. For any other motion e is the fixed point of the filter,
///
///     e = (I − Π S) A e + Π G c,   B = E D Eᵀ,   E = (I − (I − Π S) A)⁻¹ Π
///
/// which is the same for a chain. One a thread: its memory is kept.
class BiasSolver {
 public:
  /// @pre bias_problem() is empty
  explicit BiasSolver(const System& system);

  /// What a steady state must have for operator().
  void widen(SteadyRequest& request) const;

  /// Make the error of a state, its scatter so far, what System::error says.
  /// @param S information, c×c, of all devices and the prior
  void operator()(const TargetPose& pose, const StateMatrix& S, FusedState& state);
  /// The same of errors whose D is known.
  void apply(ErrorPart part, const StateMatrix& S, const StateMatrix& D,
             FusedState& state) const;

  /// B, d×d of the pose, or n×n.
  /// @param D c×c
  [[nodiscard]] StateMatrix covariance(const StateMatrix& S, const StateMatrix& D,
                                       const FusedState& state) const;

 private:
  const System& system_;
  std::optional<MotionStep> motion_;  ///< where the motion is no chain
  CalibrationScratch scratch_;
};

}  // namespace delos
