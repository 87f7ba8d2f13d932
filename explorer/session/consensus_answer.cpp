#include "session/consensus_answer.h"

#include <map>
#include <stdexcept>

#include "session/search_answer.h"

namespace delos::session {

std::vector<RankedDesign> best_of_starts(const Study& study, int round) {
  if (round < 0) round = static_cast<int>(study.summary().rounds.size());
  std::map<int, RankedDesign> best;
  for (StudyEvaluation& e : study.evaluations(round)) {
    if (e.width > 0 || !e.feasible) continue;
    const auto known = best.find(e.key.start);
    if (known != best.end() && known->second.objective <= e.objective) continue;
    best[e.key.start] = {std::move(e.x), e.objective};
  }
  std::vector<RankedDesign> all;
  for (auto& [start, design] : best) all.push_back(std::move(design));
  return all;
}

StudyConsensus study_consensus(const Study& study, PluginRegistry& plugins, int round,
                               std::size_t most) {
  const std::vector<RankedDesign> designs = best_of_starts(study, round);
  if (designs.empty())
    throw std::invalid_argument(
        "no start has a design that keeps all constraints yet; resume the study first");
  StudyConsensus found{study.searched_scene(round), designs.size(), {}};
  found.consensus =
      consensus(found.scene, plugins, designs, most, study.summary().plan.seed);
  return found;
}

Json consensus_json(const StudyConsensus& found) {
  Json layouts = Json::array(), devices = Json::object();
  for (const ConsensusLayout& l : found.consensus.layouts)
    layouts.push_back({{"objective", number(objective_shown(found.scene, l.objective))},
                       {"distance", number(l.distance)}});
  for (const ConsensusDevice& d : found.consensus.devices)
    devices[d.name] = {{"pose", to_string(d.settled)},
                       {"at", numbers(d.at)},
                       {"shift", number(d.shift)},
                       {"turn", number(d.turn)},
                       {"part_of_chance", number(d.part_of_chance)}};
  return {
      {"scene", found.scene.name},
      {"objective",
       {{"name", objective_text(found.scene)}, {"unit", objective_unit(found.scene)}}},
      {"starts", found.starts},
      {"layouts", layouts},
      {"devices", devices}};
}

}  // namespace delos::session
