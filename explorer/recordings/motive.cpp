// CSV as OptiTrack's Motive exports it: a line of facts, a head of five or six lines
// (type, name, ID, parent, kind, axis), then frame, time and the columns of each body.
#include <algorithm>

#include "recordings/lines.h"

namespace delos::recordings {

std::optional<Recording> read_motive(const Lines& lines) {
  const std::size_t before = lines.findings.size();
  const auto facts = cells_of(lines.lines[0], ',');
  const auto fact = [&](std::string_view key) -> Cell {
    for (std::size_t i = 0; i + 1 < facts.size(); ++i)
      if (facts[i].text == key) return facts[i + 1];
    lines.error(0, 1, "lacks " + std::string(key));
    return {};
  };
  // Frames may have been left out on exporting: the rate of the capture isn't theirs.
  const Cell rate_cell = fact("Export Frame Rate"), unit_cell = fact("Length Units");
  const double rate = number_of(rate_cell.text).value_or(0);
  std::string unit_name(unit_cell.text);
  for (char& c : unit_name) c = static_cast<char>(c | ('A' <= c && c <= 'Z' ? 32 : 0));
  const auto unit = unit_of(unit_name, false);
  if (!(rate > 0))
    lines.error(0, rate_cell.column, "its Export Frame Rate isn't above 0");
  if (!unit)
    lines.error(0, unit_cell.column,
                "'" + std::string(unit_cell.text) + "' is no unit of length");

  constexpr std::size_t kHead = 12;
  std::size_t axes_line = 1, names_line = 0;
  for (; axes_line < std::min(kHead, lines.lines.size()); ++axes_line) {
    const auto cells = cells_of(lines.lines[axes_line], ',');
    if (cells.size() > 1 && cells[1].text == "Name") names_line = axes_line;
    if (cells[0].text == "Frame") break;
  }
  if (axes_line >= std::min(kHead, lines.lines.size()) || names_line == 0)
    lines.error(0, 1, "has no lines of names and axes, as Motive writes them");
  if (lines.findings.size() > before) return std::nullopt;
  const auto axes = cells_of(lines.lines[axes_line], ','),
             kinds = cells_of(lines.lines[axes_line - 1], ','),
             heads = cells_of(lines.lines[names_line], ',');
  std::vector<std::string> names;
  std::vector<std::size_t> first;
  for (std::size_t c = 2; c + 2 < std::min({axes.size(), kinds.size(), heads.size()});
       ++c) {
    if (kinds[c].text != "Position" || axes[c].text != "X") continue;
    if (axes[c + 1].text != "Y" || axes[c + 2].text != "Z") continue;
    names.emplace_back(heads[c].text);
    first.push_back(c);
  }
  if (names.empty()) {
    lines.error(axes_line, 1, "has no column of positions X, Y, Z");
    return std::nullopt;
  }

  const Frames frames = frames_of(lines, axes_line + 1, ',', first, *unit);
  if (lines.findings.size() > before) return std::nullopt;
  return evenly_spaced(lines, distinct(names), frames, 1 / rate);
}

}  // namespace delos::recordings
