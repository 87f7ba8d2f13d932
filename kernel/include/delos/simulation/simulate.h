// Holding P∞ against what filters reach on simulated readings.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/rig/system.h"
#include "delos/simulation/filter.h"

namespace delos {

/// Where a target is at given times.
struct GivenPath {
  std::vector<double> t;           ///< seconds, rising; two or more
  std::vector<Eigen::Vector3d> p;  ///< in W, metres
};

/// The part of the runs that one of several processes makes, all of which simulate the
/// same: each adds up the runs of all, to the bytes of one process alone.
struct RunParts {
  std::size_t index = 0, of = 1;
  /// What each part says, to all of them, in order of index; waits for the slowest.
  std::function<std::vector<std::string>(const std::string&)> exchange = {};
};

struct SimulationOptions {
  int runs = 1000;  ///< ≥ 2
  std::uint64_t seed = 1;
  FilterKind filter = FilterKind::extended;
  const TrackFilter* own_filter = nullptr;  ///< given: this one instead
  /// How long; 0: five times the filter's time constant, or the given path's length.
  double seconds = 0;
  /// Given: the target is there, in the pose's orientation, whatever the motion says.
  std::optional<GivenPath> path;
  int threads = 0;  ///< 0: as many as OpenMP gives
  std::function<void(std::size_t, std::size_t)> progress = {};  ///< runs done, in all
  /// Called now and then and at the end, from one thread, with the sums over the runs
  /// so far: given back in `resume` with all else the same, but perhaps more runs or
  /// other threads, they go on to the same bytes as if nothing had been.
  std::function<void(const std::string&)> save = {};
  std::string resume = {};
  RunParts parts = {};
  /// Of any part: all of them stop.
  const std::atomic<bool>* cancel = nullptr;
};

/// A mean over runs that is χ² over their number where the filter is right.
struct Consistency {
  double mean = 0;              ///< NaN where it isn't defined
  double expected = 0;          ///< its degrees of freedom
  double lower = 0, upper = 0;  ///< two-sided 95 % band
  [[nodiscard]] bool inside() const { return mean >= lower && mean <= upper; }
};

/// A covariance that is predicted, and what became of it.
struct SimulatedCovariance {
  std::string name;       ///< prior, posterior, average, worst prior, best posterior
  StateMatrix predicted;  ///< P∞, n×n
  StateMatrix measured;   ///< mean of e eᵀ over the runs
  StateMatrix error;      ///< its entries' standard errors, from their own scatter
  StateMatrix filter;     ///< mean of the filter's own P
  /// Of the posterior Cramér–Rao recursion; empty where rows without noise leave none.
  StateMatrix bound;
};

/// One instant of all runs.
struct SimulatedInstant {
  double t = 0;              ///< seconds from the start
  std::size_t slot = 0;      ///< of the cycle
  Eigen::Vector3d at;        ///< where the target is, in the mean, in W
  StateVector mean, square;  ///< of the error, and of its square
  StateVector filter;        ///< the filter's own variances, in the mean
  StateVector bound;         ///< variances; empty as above
  /// Along a given path: variances of P∞ there, +∞ where a state has none; else empty.
  StateVector predicted;
  Consistency nees, nis;
  double seen = 0;  ///< part of the runs that had a reading
};

/// What came of it.
struct Simulation {
  CovarianceKind kind = CovarianceKind::prior;   ///< whose errors `instants` are
  std::size_t runs = 0;                          ///< lost ones too
  std::vector<SimulatedCovariance> covariances;  ///< first that which the scene means
  std::vector<SimulatedInstant> instants;
  double step = 0;                      ///< mean seconds from one instant to the next
  double time_constant = 0;             ///< predicted, seconds
  bool settles = false;                 ///< runs began off P∞, to see them settle
  std::optional<double> settled_after;  ///< seconds, see simulate()
  double nees_inside = 0, nis_inside = 0;  ///< part of the settled instants in band
  /// Runs that end more than 10 σ of P∞ off in some state, such as those that follow a
  /// mirror image: they are in no mean but of a given path. Of fewer than two there is
  /// none.
  std::size_t lost = 0;
  std::size_t coasting = 0;  ///< runs with a gap longer than a cycle between readings
  double longest_gap = 0;    ///< seconds without a reading, of all runs
  std::size_t dropped = 0;   ///< readings that an estimate had out of view
  bool cancelled = false;    ///< fewer runs than asked for
};

/// Draw targets, read them by the scene's devices, filter the readings, and compare.
///
/// Targets move by the scene's motion; where that is a chain they pass the pose at rest
/// at the end, so that errors are those of that pose: with x_T given, and nothing known
/// of where it came from, the errors of a linear filter are what they are anyway. Other
/// motions start there. Devices report at their own instants, all together under
/// stacked fusion; continuous fusion is run by its rates' true instants. Devices on the
/// target draw the beacons of an update by their rule's shares.
///
/// A filter begins with errors of twice P∞'s standard deviations, or of P∞ where five
/// time constants take more than 5,000 instants. It has settled when the mean square of
/// the pose block stays within 10 % and three standard errors of P∞'s trace. Band and
/// errors are over independent runs, never over time.
/// Sources: Bar-Shalom, Li, Kirubarajan (2001), Estimation with applications to
/// tracking and navigation, §5.4 (NEES, NIS); Tichavský, Muravchik, Nehorai (1998),
/// IEEE TSP 46(5), 1386–1396, doi:10.1109/78.668800 (the bound).
/// @throws std::invalid_argument what can't be simulated, or has no P∞ there; as
///         make_steady_solver(); `resume` isn't of such runs, or of more of them
/// @throws DeviceFault
/// @throws std::runtime_error another part has failed
[[nodiscard]] DELOS_API Simulation simulate(const System& system,
                                            const TargetPose& about,
                                            const SimulationOptions& options);

}  // namespace delos
