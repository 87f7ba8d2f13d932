// The fewest, or cheapest, devices that together see every sample: set multi-cover.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace delos {

/// What is decided about a candidate beforehand.
enum class Membership : char { free, in, out };

/// Choose candidates j so that Σ_{j sees i} x_j ≥ demand_i for all samples i, at most
/// one of each group, with the least Σ cost_j x_j.
struct CoverProblem {
  int samples = 0;
  /// Candidate j sees seen[start[j]] … seen[start[j + 1] − 1], in rising order; so
  /// there is one start more than candidates.
  std::vector<std::int64_t> start = {0};
  std::vector<std::int32_t> seen;
  std::vector<double> cost;       ///< of each candidate, > 0; 1 each: the fewest
  std::vector<int> demand;        ///< how many must see each sample, ≥ 0
  std::vector<Membership> fixed;  ///< of each candidate; empty: all free
  /// Of each candidate; at most one of a group ≥ 0 is chosen, −1: in none. Empty: none.
  std::vector<int> group;

  [[nodiscard]] int candidates() const { return static_cast<int>(start.size()) - 1; }
};

/// How far a cover is.
struct CoverProgress {
  double cost = std::numeric_limits<double>::infinity();  ///< best so far; ∞: none yet
  double bound = 0;                                       ///< no cover is cheaper
};

/// How to look for a cover.
struct CoverOptions {
  std::uint64_t seed = 1;
  double seconds = 30;  ///< at most about so long
  int rounds = 0;       ///< at most so many of search and bound; 0: by the clock alone
  int threads = 0;      ///< 0: one a core
  std::optional<double> stop_at;  ///< a cost that is good enough
  const std::atomic<bool>* cancel = nullptr;
  /// Called from the calling thread when either number has moved.
  std::function<void(const CoverProgress&)> progress;
};

/// How it ended.
enum class CoverStop {
  proven,      ///< no cover is cheaper
  target,      ///< as good as was asked for
  budget,      ///< time or rounds are spent
  cancelled,   ///< asked to stop
  infeasible,  ///< proven: groups leave no cover
};
[[nodiscard]] const char* to_string(CoverStop stop);

/// A cover and how good it is.
struct CoverAnswer {
  std::vector<int> chosen;  ///< rising, with those fixed in; empty: none was found
  double cost = std::numeric_limits<double>::infinity();
  double lower_bound = 0;  ///< no cover is cheaper
  CoverStop stop = CoverStop::budget;
  /// What reductions left to search.
  int samples_left = 0, candidates_left = 0;
  std::int64_t moves = 0;  ///< of the local search
  double seconds = 0;

  [[nodiscard]] bool found() const { return cost < 1e300; }
  [[nodiscard]] bool proven() const { return stop == CoverStop::proven; }
};

/// Thrown where samples can't be covered.
struct Uncoverable : std::invalid_argument {
  Uncoverable(const std::string& text, std::vector<int> which)
      : std::invalid_argument(text), samples(std::move(which)) {}
  std::vector<int> samples;
};

/// Samples that even all candidates together, of each group one, see too few times.
/// @throws std::invalid_argument as solve_cover(), but not for such samples
[[nodiscard]] std::vector<int> uncoverable(const CoverProblem& problem);

/// Whether these candidates keep all demands, groups and what is fixed.
[[nodiscard]] bool is_cover(const CoverProblem& problem,
                            const std::vector<int>& candidates);

/// Look for the cheapest cover and for a bound on it, by turns, until they meet.
///
/// Reductions, greedy and a local search that weighs samples which stay unseen; bounds
/// by Lagrangian relaxation, rounded up where all costs are whole; small remainders are
/// enumerated. However short the time, the greedy cover and a bound are found. The same
/// answer for any number of threads, unless the clock ends it. Sources:
/// docs/selection.md.
/// @throws std::invalid_argument nothing to see; lists that don't fit together; a cost
///         that isn't positive; two of a group fixed in
/// @throws Uncoverable samples that can't be covered
[[nodiscard]] CoverAnswer solve_cover(const CoverProblem& problem,
                                      const CoverOptions& options);

}  // namespace delos
