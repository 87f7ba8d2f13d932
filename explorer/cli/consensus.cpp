#include "consensus.h"

#include <map>
#include <ostream>
#include <stdexcept>

#include "delos/text/format.h"
#include "search_report.h"
#include "summary.h"

namespace delos::cli {

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

void print_consensus(std::ostream& out, const StudyConsensus& found) {
  const std::string unit = objective_unit(found.scene);
  const auto& layouts = found.consensus.layouts;
  out << counted(layouts.size(), "distinct layout") << " of "
      << counted(found.starts, "start") << ", by " << objective_text(found.scene)
      << " on the samples of the search\n";
  for (const ConsensusLayout& l : layouts)
    out << "  "
        << cell(format_quantity(objective_shown(found.scene, l.objective), unit), 12)
        << format_quantity(l.distance, "m") << " from the best\n";
  if (layouts.size() < 2) {
    out << "One layout says nothing of what is settled: begin with more --starts.\n";
    return;
  }
  out << "In them, and how much a device varies relative to random designs\n";
  for (const ConsensusDevice& d : found.consensus.devices) {
    const std::string part = format_quantity(100 * d.part_of_chance, "1", 2) + " %";
    out << "  " << cell(d.name, 18) << cell(to_string(d.settled), 9) << cell(part, 8)
        << "moves by " << format_quantity(d.shift, "m") << ", turns by "
        << format_quantity(d.turn, "rad") << "\n";
  }
}

}  // namespace delos::cli
