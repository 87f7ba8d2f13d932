// Track Row Column, of Motion Analysis and OpenSim: five lines of head, then frame
// number, time and x, y, z of each marker, with tabs or commas.
#include <algorithm>

#include "recordings/lines.h"

namespace delos::recordings {

std::optional<Recording> read_trc(const Lines& lines) {
  constexpr std::size_t kHead = 5;
  if (lines.lines.size() < kHead || !lines.lines[0].starts_with("PathFileType")) {
    lines.error(0, 1,
                "doesn't begin as a TRC file does, with PathFileType and five "
                "lines of head");
    return std::nullopt;
  }
  const std::size_t before = lines.findings.size();
  const char separator =
      lines.lines[0].find('\t') != std::string_view::npos ? '\t' : ',';
  const auto keys = cells_of(lines.lines[1], separator),
             facts = cells_of(lines.lines[2], separator);
  const auto fact = [&](std::string_view key) -> Cell {
    for (std::size_t i = 0; i < std::min(keys.size(), facts.size()); ++i)
      if (keys[i].text == key) return facts[i];
    lines.error(1, 1, "lacks " + std::string(key));
    return {};
  };
  const Cell rate_cell = fact("DataRate"), unit_cell = fact("Units");
  const double rate = number_of(rate_cell.text).value_or(0);
  const auto unit = unit_of(unit_cell.text, false);
  if (!(rate > 0)) lines.error(2, rate_cell.column, "its DataRate isn't above 0");
  if (!unit)
    lines.error(2, unit_cell.column,
                "'" + std::string(unit_cell.text) + "' is no unit of length");
  std::vector<std::string> names;
  std::vector<std::size_t> first;
  const auto heads = cells_of(lines.lines[3], separator);
  for (std::size_t c = 2; c < heads.size(); ++c) {
    if (heads[c].text.empty()) continue;
    names.emplace_back(heads[c].text);
    first.push_back(c);
  }
  if (names.empty()) lines.error(3, 1, "names no marker");
  if (lines.findings.size() > before) return std::nullopt;

  const Frames frames = frames_of(lines, kHead, separator, first, *unit);
  if (lines.findings.size() > before) return std::nullopt;
  for (std::size_t i = 0; i < std::min(keys.size(), facts.size()); ++i) {
    if (keys[i].text != "NumFrames") continue;
    const double said = number_of(facts[i].text).value_or(0);
    if (said != static_cast<double>(frames.time.size()))
      lines.warning(2, "has " + std::to_string(frames.time.size()) +
                           " frames, but its NumFrames says " +
                           std::string(facts[i].text) + "; was it copied whole?");
  }
  return evenly_spaced(lines, distinct(names), frames, 1 / rate);
}

}  // namespace delos::recordings
