// What the best layouts of a study have in common.
#pragma once

#include "delos/optimize/layout.h"
#include "delos/optimize/study.h"
#include "session/json.h"

namespace delos::session {

/// The best design of every start of a round.
/// @param round −1: the last one
[[nodiscard]] std::vector<RankedDesign> best_of_starts(const Study& study, int round);

/// Where the best layouts agree, and what they are worth.
struct StudyConsensus {
  Scene scene;         ///< of the round
  std::size_t starts;  ///< that have a design which keeps all constraints
  Consensus consensus;
};

/// @throws std::invalid_argument no start has such a design yet
[[nodiscard]] StudyConsensus study_consensus(const Study& study,
                                             PluginRegistry& plugins, int round,
                                             std::size_t most);

[[nodiscard]] Json consensus_json(const StudyConsensus& found);

}  // namespace delos::session
