// The equation of P∞ at one pose.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "delos/api.h"
#include "delos/model/metric.h"
#include "delos/riccati/riccati.h"
#include "delos/riccati/spectral.h"
#include "delos/rig/system.h"

namespace delos {

/// What is wanted of a steady state; more may be there.
struct SteadyRequest {
  bool prior = true, posterior = true;
  bool whole_state = true;  ///< false: their pose blocks are enough
  bool time_constant = false;
};

/// What metrics read of a system's steady state.
[[nodiscard]] DELOS_API SteadyRequest request_for(const System& system,
                                                  std::span<const Metric> metrics);

/// The equation of P∞ at one pose, and what its solution is made of. Made once a thread
/// by SteadySolver::equation(), so that solving allocates nothing.
struct DELOS_API SteadyEquation {
  /// A cycle: the motion up to an instant, and what is measured then. Devices that
  /// expose read states behind those of the motion: see steady/windows.h. Information
  /// is 0 outside the blocks on its diagonal that devices read.
  std::vector<CycleStep> steps;
  int columns = 0;                   ///< c, information_size()
  StateBlock block;                  ///< that devices read, where all read the same
  std::vector<SteadyState> states;   ///< of each step, where solved so
  std::optional<SpectralForm> form;  ///< where reduced to scalar chains
  /// Of each step's information, the readings that it is of: rows of R^(−1/2) H, n
  /// numbers each, one after another; and what all have besides, for each coordinate of
  /// the pose. Empty: not known.
  std::vector<std::vector<double>> readings = {};
  double besides = 0;

  /// Nothing is measured any more.
  void clear();
  /// A step measures so much more of a block.
  /// @param S c×c, packed as model/lanes.h says, its elements `stride` numbers apart
  void add(std::size_t step, const StateBlock& read, const double* S, int stride = 1);
  void add(std::size_t step, const double* S) { add(step, block, S); }
  /// A step measures a row without noise.
  /// @param row c numbers or more
  void add_perfect(std::size_t step, const StateBlock& read, const StateVector& row);
  void add_perfect(std::size_t step, const StateVector& row) {
    add_perfect(step, block, row);
  }
  /// A step's information has a reading with so much information.
  /// @param row c numbers
  void add_reading(std::size_t step, const StateBlock& read,
                   const Eigen::Ref<const Eigen::RowVectorXd>& row, double information);
  void add_reading(std::size_t step, const Eigen::Ref<const Eigen::RowVectorXd>& row,
                   double information) {
    add_reading(step, block, row, information);
  }
  /// Have each step measure its readings one by one instead of their sum. Allocates.
  /// @param pose the states that `besides` is about
  /// @returns false where no readings are known
  bool take_readings(const StateBlock& pose);
};

}  // namespace delos
