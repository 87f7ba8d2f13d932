// What a selection could be: for every count, candidate by candidate, sample by sample.
#pragma once

#include <string>
#include <vector>

#include "delos/field/field.h"
#include "delos/optimize/select.h"

namespace delos {

/// The best choice of one count, and its bound.
struct CountPoint {
  int count = 0;
  std::vector<std::size_t> chosen;
  double value = 0, lower_bound = 0;  ///< as SelectResult
  std::size_t blind = 0;              ///< likewise
};

/// Accuracy against count: no design is below the band of bounds.
struct CountCurve {
  CandidateScene all;
  std::string quantity, unit;  ///< as SelectResult
  double guess = 0;            ///< likewise
  std::vector<CountPoint> points;
};

/// @param options its seconds are for each count
/// @param progress called with each point
/// @throws std::invalid_argument as select(), or counts that aren't in order or fewer
///         than the candidates that are kept
[[nodiscard]] CountCurve count_curve(
    const Scene& scene, PluginRegistry& plugins, const SelectOptions& options, int from,
    int to, const std::function<void(const CountPoint&)>& progress = {});

/// One candidate that goes.
struct Removal {
  std::size_t candidate = 0;
  int left = 0;                       ///< how many are chosen then
  double value = 0, lower_bound = 0;  ///< then, and of any choice of as many
  std::size_t blind = 0;              ///< samples that are blind then
};

/// The order in which to do without candidates.
struct RemovalOrder {
  CandidateScene all;
  std::string quantity, unit;
  double guess = 0;               ///< as SelectResult
  double all_chosen = 0;          ///< value where nothing is left out
  std::vector<Removal> removals;  ///< the first one first
};

/// Starting with all candidates, at each step the one goes that is missed least (so
/// that the fewest directions are blind, and then by the value), until as many are left
/// as the scene's count, or as fit into its budget.
/// @throws std::invalid_argument as select()
[[nodiscard]] RemovalOrder removal_order(const Scene& scene, PluginRegistry& plugins,
                                         const SelectOptions& options);

/// The least that any choice allowed could reach at each sample by itself: a field of
/// lower bounds, in the metric of the objective's first term. No choice need reach it
/// everywhere. Blind where no choice was found that isn't.
/// @throws std::invalid_argument as select()
[[nodiscard]] Field selection_envelope(const Scene& scene, PluginRegistry& plugins,
                                       const SelectOptions& options);

}  // namespace delos
