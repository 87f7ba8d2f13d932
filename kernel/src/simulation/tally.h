// Sums over runs, added up in the order of the runs.
#pragma once

#include <cstddef>
#include <vector>

#include "simulation/expectation.h"

namespace delos {

/// Sums of one instant.
struct InstantTally {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  StateVector error, square, filter;  ///< n
  double nees = 0, nis = 0;
  std::size_t nis_rows = 0, seen = 0;
  StateMatrix information;  ///< N×N, lower triangle
};

/// Sums of one look.
struct LookTally {
  StateMatrix sum, squares;  ///< of e eᵀ, and of its entries' squares
  StateMatrix filter;
};

/// Sums over some runs.
struct Tally {
  Tally(const Expectation& expected, std::size_t instants, int n, int states);
  void clear();
  void add(const Tally& more);

  /// Runs in all, and those that the sums below are of.
  std::size_t runs = 0, tracked = 0;
  std::size_t lost = 0, coasting = 0, dropped = 0;
  double longest_gap = 0;
  bool perfect = false;
  std::vector<InstantTally> instants;
  std::vector<LookTally> looks;
};

}  // namespace delos
