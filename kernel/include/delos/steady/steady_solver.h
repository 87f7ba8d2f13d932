// From what the devices know at a pose to one steady-state covariance, and back.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/layers/layers.h"
#include "delos/steady/equation.h"
#include "delos/steady/fused_state.h"
#include "delos/steady/solver.h"

namespace delos {

struct ChainReduction;
struct UpdateSlot;

/// S ↦ P∞ of a system, by its fusion. Holds what doesn't change from pose to pose.
/// Reentrant with an equation a thread.
class DELOS_API SteadySolver {
 public:
  virtual ~SteadySolver();

  /// The solver that answers where no row is perfect. Those poses are solved by the
  /// general path whatever the solver.
  [[nodiscard]] Solver solver() const { return solver_; }
  /// Null where the solver isn't spectral.
  [[nodiscard]] const ChainReduction* reduction() const { return reduction_.get(); }

  /// Whether SteadyEquation::readings are of use: where a sum of their information may
  /// lose their digits.
  [[nodiscard]] bool reads_rows() const;

  /// The equation of a pose where nothing is measured.
  [[nodiscard]] SteadyEquation equation() const;

  /// What the devices know at one lane of a block.
  /// @param pose the lane's, read again only where rows are perfect
  void read(const LayerBlock& block, int lane, const TargetPose& pose,
            SteadyEquation& at) const;

  /// Steady state of an equation, and what is left of it when it is used: System::lag.
  /// @param[in,out] at its states or its form are what adjoint() needs
  void solve(SteadyEquation& at, const SteadyRequest& request, FusedState& out) const;

 protected:
  SteadySolver(const System& system, Solver solver);
  /// One step more: the motion that leads to it, and who reports then.
  void add_step(const MotionStep& motion, std::span<const int> devices);
  /// A step a slot, each with what its readings are the means of.
  /// @throws std::invalid_argument more readings are under way at once than a state
  ///         holds; the sentence says so
  void add_slots(std::span<const UpdateSlot> slots);
  /// Steady state at the updates of what the chain reduction can't solve.
  virtual void find(SteadyEquation& at, const SteadyRequest& request,
                    FusedState& out) const = 0;

  System system_;
  std::optional<MotionStep> later_;  ///< the motion over the lag, where there is one

 private:
  /// Solve by the chain reduction; false where that isn't possible.
  bool reduce(SteadyEquation& at, const SteadyRequest& request, FusedState& out) const;
  /// P(t + lag) = Φ P Φᵀ + Q(lag)
  void carry(FusedState& out) const;

  Solver solver_;
  std::unique_ptr<const ChainReduction> reduction_;
  std::vector<CycleStep> steps_;
  struct Report {
    std::size_t step;
    StateBlock read;
  };
  std::vector<std::vector<Report>> reports_;  // of each device
};

/// A solver whose P∞ has slopes. P∞ is matrix-convex and decreasing in S.
class DELOS_API SmoothSteadySolver : public SteadySolver {
 public:
  /// ∂⟨Y, P∞⟩/∂S, c×c, symmetric, with P∞ the prior or posterior as the system says.
  /// Rows without noise stay as they are.
  /// @param at solved, and converged
  /// @param Y d×d, of the pose block, or n×n; symmetric
  [[nodiscard]] StateMatrix adjoint(const SteadyEquation& at,
                                    const StateMatrix& Y) const;

 protected:
  SmoothSteadySolver(const System& system, Solver solver)
      : SteadySolver(system, solver) {}
  /// adjoint() of P∞ at the updates, which reduction() may have solved.
  [[nodiscard]] virtual StateMatrix find_adjoint(const SteadyEquation& at,
                                                 const StateMatrix& Y) const = 0;
};

/// The solver of a system's fusion.
/// @throws UnsuitableSolver the solver can't do this system
/// @throws std::invalid_argument the rates have no short cycle, the fusion knows no
///         exposure or no lag, or too many overlap; the sentence says what would help
[[nodiscard]] DELOS_API std::unique_ptr<const SteadySolver> make_steady_solver(
    const System& system, Solver solver = Solver::automatic);

/// Empty where P∞ of the system has slopes here; else a sentence that says why not.
[[nodiscard]] DELOS_API std::string adjoint_problem(const System& system);

/// @pre adjoint_problem() is empty
[[nodiscard]] DELOS_API std::unique_ptr<const SmoothSteadySolver>
make_smooth_steady_solver(const System& system);

}  // namespace delos
