#include "consensus.h"

#include <ostream>

#include "delos/text/format.h"
#include "search_report.h"
#include "summary.h"

namespace delos::cli {

void print_consensus(std::ostream& out, const session::StudyConsensus& found) {
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
