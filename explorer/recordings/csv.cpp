// Plain CSV: a head with names and units, a line a frame.
#include <algorithm>
#include <cmath>

#include "recordings/lines.h"

namespace delos::recordings {
namespace {

/// "hand.x [mm]" is x of "hand", in units of a millimetre.
struct Column {
  std::string track;
  char what = ' ';  // t, x, y or z; a blank: nothing that is read
  double unit = 1;  // metres or seconds
};

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

std::optional<Column> column_of(const Lines& lines, std::size_t line,
                                const Cell& cell) {
  std::string_view name = cell.text, unit;
  const std::size_t open = name.find_first_of("[(");
  if (open != std::string_view::npos) {
    unit = name.substr(open + 1);
    unit = unit.substr(0, unit.find_first_of("])"));
    name = name.substr(0, open);
  }
  while (!name.empty() && name.back() == ' ') name.remove_suffix(1);
  Column column;
  const std::string word = lower(name);
  if (word == "t" || word == "time" || word == "timestamp") {
    column.what = 't';
  } else if (!word.empty() && word.find_last_of("xyz") == word.size() - 1) {
    const bool alone = word.size() == 1;
    const char before = alone ? '.' : word[word.size() - 2];
    if (before == '.' || before == '_' || before == ':' || before == ' ') {
      column.what = word.back();
      if (!alone) column.track = std::string(name.substr(0, name.size() - 2));
    }
  }
  if (column.what == ' ' || unit.empty()) return column;
  const auto factor = unit_of(unit, column.what == 't');
  if (!factor) {
    lines.error(
        line, cell.column,
        "'" + std::string(unit) + "' is no unit of " +
            (column.what == 't' ? "time, such as s or ms" : "length, such as m or mm"));
    return std::nullopt;
  }
  column.unit = *factor;
  return column;
}

}  // namespace

std::optional<Recording> read_csv(const Lines& lines, const ReadOptions& options) {
  std::size_t head = 0;
  while (head < lines.lines.size() &&
         (lines.lines[head].empty() || lines.lines[head].front() == '#'))
    ++head;
  if (head == lines.lines.size()) {
    lines.error(0, 0,
                "is empty; its first line names columns, such as t [s],x [m],y "
                "[m],z [m]");
    return std::nullopt;
  }
  const std::string_view first = lines.lines[head];
  const char separator = first.find('\t') != std::string_view::npos  ? '\t'
                         : first.find(';') != std::string_view::npos ? ';'
                                                                     : ',';
  std::vector<Column> columns;
  std::size_t before = lines.findings.size();
  for (const Cell& cell : cells_of(first, separator)) {
    const auto column = column_of(lines, head, cell);
    columns.push_back(column.value_or(Column{}));
  }
  std::vector<std::string> names;
  std::vector<std::array<std::size_t, 3>> axes;
  std::size_t time = columns.size();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].what == 't') time = c;
    if (columns[c].what != 'x') continue;
    std::array<std::size_t, 3> at{c, columns.size(), columns.size()};
    for (std::size_t o = 0; o < columns.size(); ++o)
      if (columns[o].track == columns[c].track && columns[o].what > 'x')
        at[static_cast<std::size_t>(columns[o].what - 'x')] = o;
    if (at[1] == columns.size() || at[2] == columns.size()) {
      lines.error(head, 1, "has x of '" + columns[c].track + "' without its y and z");
      continue;
    }
    names.push_back(columns[c].track.empty() ? "target" : columns[c].track);
    axes.push_back(at);
  }
  if (names.empty() && lines.findings.size() == before)
    lines.error(head, 1,
                "names no x, y and z; name columns such as t [s],x [m],y [m],z [m] or "
                "hand.x [mm]");
  if (time == columns.size() && options.rate <= 0)
    lines.error(head, 1, "has no time; name a column t [s], or give --rate");
  if (lines.findings.size() > before) return std::nullopt;

  Frames frames;
  for (std::size_t l = head + 1; l < lines.lines.size(); ++l) {
    if (lines.lines[l].empty() || lines.lines[l].front() == '#') continue;
    const std::vector<Cell> cells = cells_of(lines.lines[l], separator);
    if (cells.size() != columns.size()) {
      lines.error(l, 1,
                  "has " + std::to_string(cells.size()) + " cells, the head has " +
                      std::to_string(columns.size()));
      return std::nullopt;
    }
    const auto value = [&](std::size_t c) {
      const auto number = number_of(cells[c].text);
      if (!number)
        lines.error(l, cells[c].column,
                    "'" + std::string(cells[c].text) + "' isn't a number");
      return number.value_or(0) * columns[c].unit;
    };
    const double when = time < columns.size()
                            ? value(time)
                            : static_cast<double>(frames.time.size()) / options.rate;
    if (std::isnan(when)) lines.error(l, cells[time].column, "has no time");
    frames.line.push_back(l);
    frames.time.push_back(when);
    for (const auto& at : axes)
      for (const std::size_t c : at) frames.values.push_back(value(c));
    if (lines.findings.size() > before + 20) break;
  }
  if (lines.findings.size() > before) return std::nullopt;
  const bool checked = options.rate > 0;
  return evenly_spaced(lines, names, frames, checked ? 1 / options.rate : 0);
}

}  // namespace delos::recordings
