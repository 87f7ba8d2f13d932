// Steady-state covariance of any linear system, and of any cycle of updates.
#pragma once

#include <span>

#include "delos/api.h"
#include "delos/model/motion.h"
#include "delos/model/state.h"

namespace delos {

/// How a steady-state solve ended. A field is expected to meet all of these, so they
/// are values, not exceptions.
enum class RiccatiStatus {
  converged,        ///< the covariances are those of the stabilising solution
  unobservable,     ///< some directions have no finite variance; the others are finite
  iteration_limit,  ///< neither settled nor diverged; the last iterate
};

/// What the measurements of one instant say about the state.
///
/// `information` sums Hᵀ R⁻¹ H. Rows that are measured perfectly (a singular R) have no
/// finite information: they stand in `exact`, one row of H each. So nearly perfect ones
/// that their information would swallow the digits of all other's stand in `rows`: they
/// are worked in one after another and keep all digits, at a cost that grows with their
/// number.
struct Measurement {
  StateMatrix information;  ///< S, n×n, symmetric ≥ 0, inverse squared state units
  StateMatrix exact;  ///< c×n, rows measured without noise; 0×n where there are none
  /// m×n, rows of R^(−1/2) H that aren't in `information`; 0×0 where there are none
  Eigen::MatrixXd rows = {};
};

/// One part of a cycle: the motion up to an instant, and what is measured then.
struct CycleStep {
  MotionStep motion;
  Measurement measurement;
};

/// Steady state at one instant.
struct SteadyState {
  RiccatiStatus status = RiccatiStatus::converged;
  StateMatrix prior;      ///< P∞, n×n; projected off the unobservable directions
  StateMatrix posterior;  ///< Π∞, n×n; likewise
  StateMatrix
      unobservable;   ///< n×m, orthonormal columns: directions of infinite variance
  int doublings = 0;  ///< j, after which 2ʲ cycles are accounted for
};

/// Steady-state covariances of the Kalman filter, by structure-preserving doubling.
///
///     P = A Π Aᵀ + Q,   Π = (P⁻¹ + S)⁻¹, then conditioned on the other rows
///
/// Directions that no measurement reaches and that do not decay by themselves are split
/// off first (`unobservable`); what is left has a unique stabilising solution.
/// @pre matrices of one size n in [1, kMaxState]; aborts if not.
/// @returns a SteadyState with its status; never throws on numbers.
/// @cost O(n³) a doubling, typically 5 to 12; no heap; reentrant.
/// Source: Chu, Fan, Lin, Wang (2004), Int. J. Control 77(8), 767–788,
///         doi:10.1080/00207170410001714988 (doubling); Särkkä, García-Fernández
///         (2021), IEEE TAC 66(1), 299–306, doi:10.1109/TAC.2020.2976316 (composition
///         without R⁻¹).
[[nodiscard]] DELOS_API SteadyState solve_doubling(const MotionStep& motion,
                                                   const Measurement& measurement);

/// The same fixed point over a whole cycle of different steps: the steady state at the
/// end of each step, in the order of `cycle`, written to `states`.
/// @pre states.size() == cycle.size() ≥ 1
/// @cost one copy of the cycle on the heap, and solve_doubling() of the composed cycle
DELOS_API void solve_cycle(std::span<const CycleStep> cycle,
                           std::span<SteadyState> states);

/// Steady state under continuous measurement: F P + P Fᵀ + Q − P S P = 0, with F and Q
/// of continuous_form() and S the information rate. Prior and posterior are the same.
/// @param rate information and rows of a rate, 1/s; none is exact
[[nodiscard]] DELOS_API SteadyState solve_continuous(const MotionStep& continuous,
                                                     const Measurement& rate);

/// The papers' own solution, the reference that the others are compared with:
/// eigenvectors of the 2n×2n symplectic matrix Ψ with the largest |eigenvalue|, P∞ = B
/// C⁻¹. Allocates; singular A and exact rows are outside its reach. So are slow
/// filters, whose Ψ is nearly defective: the status is iteration_limit where P does not
/// solve its equation.
/// @param steps one: the usual Ψ. Several: the sum of their Ψ, Table 3.3 of the
///        dissertation ("artemis" fusion), in which P∞ is no longer a Kalman
///        covariance.
/// Source: Allen (2007), §3.5.1, Eqs. 28–30.
[[nodiscard]] DELOS_API SteadyState solve_eigenvector(std::span<const CycleStep> steps);

/// ‖A (P⁻¹ + S)⁻¹ Aᵀ + Q − P‖ / ‖P‖, Frobenius: how well P solves its own equation.
[[nodiscard]] DELOS_API double riccati_residual(const MotionStep& motion,
                                                const Measurement& measurement,
                                                const StateMatrix& prior);

/// Spectral radius of the closed loop (I − K H) A over a whole cycle (of one step,
/// mostly); below 1 where the filter forgets its past.
/// @param states of solve_cycle() for the same cycle
[[nodiscard]] DELOS_API double closed_loop_radius(std::span<const CycleStep> cycle,
                                                  std::span<const SteadyState> states);

/// The same by the gain instead of Π P⁻¹: of states that nearly depend on each other,
/// such as a position and its mean over a moment.
/// @param cycle with its measurements
[[nodiscard]] DELOS_API double closed_loop_radius_by_gain(
    std::span<const CycleStep> cycle, std::span<const SteadyState> states);

/// Largest real part of the poles of dx/dt = (F − P S) x, 1/s; below 0 where it
/// forgets.
[[nodiscard]] DELOS_API double continuous_closed_loop_rate(const MotionStep& continuous,
                                                           const Measurement& rate,
                                                           const StateMatrix& P);

/// ∂J/∂S of the general solution, for an objective with ∂J/∂P∞ = Y (prior) or ∂J/∂Π∞ =
/// Y (posterior): one Stein equation X = Fᵀ X F + Y with F = A − K H.
/// Exact rows stay as they are.
/// @pre state.status == converged
/// @returns n×n, symmetric.
[[nodiscard]] DELOS_API StateMatrix riccati_gradient(const MotionStep& motion,
                                                     const Measurement& measurement,
                                                     const SteadyState& state,
                                                     const StateMatrix& Y,
                                                     bool posterior);

}  // namespace delos
