// Trajectories of the TUM RGB-D benchmark: t x y z qx qy qz qw, seconds and metres.
#include <cmath>

#include "recordings/lines.h"

namespace delos::recordings {

std::optional<Recording> read_tum(const Lines& lines) {
  Frames frames;
  const std::size_t before = lines.findings.size();
  for (std::size_t l = 0; l < lines.lines.size(); ++l) {
    if (lines.lines[l].empty() || lines.lines[l].front() == '#') continue;
    const std::vector<Cell> cells = cells_of(lines.lines[l], ' ');
    if (cells.empty()) continue;
    if (cells.size() != 8 && cells.size() != 4) {
      lines.error(l, 1,
                  "has " + std::to_string(cells.size()) +
                      " numbers; expected t x y z qx qy qz qw");
      return std::nullopt;
    }
    for (std::size_t c = 0; c < 4; ++c) {
      const auto value = number_of(cells[c].text);
      if (!value || (c == 0 && std::isnan(*value))) {
        lines.error(l, cells[c].column,
                    "'" + std::string(cells[c].text) + "' isn't a number");
        if (lines.findings.size() > before + 20) return std::nullopt;
      }
      (c == 0 ? frames.time : frames.values).push_back(value.value_or(0));
    }
    frames.line.push_back(l);
  }
  if (lines.findings.size() > before) return std::nullopt;
  return evenly_spaced(lines, {"target"}, frames, 0);
}

}  // namespace delos::recordings
