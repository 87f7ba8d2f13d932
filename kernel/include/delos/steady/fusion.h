// From the information of several devices to one steady-state covariance.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/layers/layers.h"
#include "delos/riccati/riccati.h"
#include "delos/riccati/spectral.h"
#include "delos/rig/schedule.h"

namespace delos {

/// Which solver finds the steady state.
enum class Solver {
  automatic,    ///< the fastest exact one
  spectral,     ///< pose-level measurements of a chain, one rate or continuous
  doubling,     ///< everything but artemis fusion
  eigenvector,  ///< the papers' method; stacked and artemis fusion, no perfect rows
};

[[nodiscard]] DELOS_API const char* to_string(Solver solver);

/// Steady state of a whole system at one pose.
struct FusedState {
  RiccatiStatus status = RiccatiStatus::converged;
  StateMatrix
      prior;  ///< n×n; periodic: the mean over time, by the
              ///< trapezoid rule, which errs upwards; sequential: mean over turns
  StateMatrix posterior;     ///< n×n; likewise
  StateMatrix unobservable;  ///< n×m, orthonormal columns
  double time_constant =
      0;  ///< of the slowest closed-loop pole, seconds; filled on request
  StateMatrix worst_prior;     ///< periodic and sequential: the largest by pose trace
  StateMatrix best_posterior;  ///< periodic and sequential: the smallest by pose trace
};

/// Solves the steady-state equation of one system at any pose.
///
/// Holds what doesn't change from pose to pose. Reentrant with a Scratch a thread.
/// Poses with perfect rows are solved by the general path whatever the solver.
class DELOS_API FusionSolver {
 public:
  /// @throws std::invalid_argument the forced solver can't do this system, or its rates
  /// have
  ///         no short cycle; the sentence says what would.
  FusionSolver(const System& system, Solver solver);

  /// Memory of one thread, made once, so that solving allocates nothing.
  struct Scratch {
    std::vector<CycleStep> cycle;
    std::vector<SteadyState> states;
    MotionStep step;
    Measurement measurement;
    std::vector<StateMatrix> exact;  ///< perfect rows of each device
  };
  [[nodiscard]] Scratch make_scratch() const;

  /// The solver that answers where no row is perfect.
  [[nodiscard]] Solver solver() const { return solver_; }
  /// True where lane() of the block can be reduced to scalar chains.
  [[nodiscard]] bool spectral(const LayerBlock& block, int lane) const;

  /// Covariances of the pose at all lanes, as spectral_pose_covariances(): good for
  /// those that are spectral(block, lane).
  /// @pre solver() == Solver::spectral
  void pose_covariances(const LayerBlock& block, CovarianceKind kind, double* P,
                        int* lost) const;

  /// Steady state of a lane.
  /// @param pose the lane's pose, read again only where rows are perfect
  void solve(const LayerBlock& block, int lane, const TargetPose& pose,
             bool with_time_constant, Scratch& scratch, FusedState& out) const;

  /// Steady state from weighted whitened rows, m×d: spectral_form_of_rows(). Keeps
  /// twice the digits of a lane.
  /// @pre solver() == Solver::spectral, no row is perfect
  void solve_rows(const Eigen::Ref<const Eigen::MatrixXd>& rows,
                  bool with_time_constant, FusedState& out) const;

  /// riccati_residual() of a lane's prior; NaN where rows are perfect.
  /// @pre stacked fusion, state.status == converged
  [[nodiscard]] double residual(const LayerBlock& block, int lane,
                                const FusedState& state) const;

 private:
  void solve_spectral(const SpectralForm& form, bool with_time_constant,
                      FusedState& out) const;
  void solve_general(const LayerBlock& block, int lane, bool with_time_constant,
                     Scratch& scratch, FusedState& out) const;
  void solve_continuous_exact(const Measurement& measurement, bool with_time_constant,
                              FusedState& out) const;
  void solve_over_cycle(bool with_time_constant, Scratch& scratch,
                        FusedState& out) const;

  System system_;
  Solver solver_;
  int columns_;
  Sampling sampling_;
  CoordinateMatrix L_;
  MotionStep step_;  ///< one update, or the continuous form
  std::vector<UpdateSlot> slots_;
  std::vector<double> intervals_;  ///< seconds that lead to each slot
  std::vector<CycleStep>
      cycle_;  ///< motion of each slot, or of each device for artemis
};

}  // namespace delos
