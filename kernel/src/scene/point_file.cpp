#include "scene/point_file.h"

#include <algorithm>
#include <cctype>

#include "scene/numbers.h"

namespace delos {
namespace {

/// After so many malformed rows the file is evidently of another kind.
constexpr int kMostFindings = 20;

/// A part of a line and the column where it begins, from 1.
struct Cell {
  std::string_view text;
  int column;
};

Cell trimmed(std::string_view line, std::size_t begin, std::size_t end) {
  constexpr const char* kBlank = " \t\r";
  const std::string_view cell = line.substr(begin, end - begin);
  const std::size_t first = cell.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {{}, static_cast<int>(begin) + 1};
  const std::size_t last = cell.find_last_not_of(kBlank);
  return {cell.substr(first, last - first + 1), static_cast<int>(begin + first) + 1};
}

std::vector<Cell> split_at_commas(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = std::min(line.find(',', begin), line.size());
    cells.push_back(trimmed(line, begin, comma));
    if (comma == line.size()) return cells;
    begin = comma + 1;
  }
}

std::vector<Cell> split_at_blanks(std::string_view line) {
  constexpr const char* kBlank = " \t\r";
  std::vector<Cell> cells;
  for (std::size_t at = line.find_first_not_of(kBlank); at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    cells.push_back({line.substr(at, end - at), static_cast<int>(at) + 1});
    at = line.find_first_not_of(kBlank, end);
  }
  return cells;
}

bool is_header(const std::vector<Cell>& cells) {
  if (cells.size() != 3) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view text = cells[i].text;
    if (text.size() != 1 ||
        std::tolower(static_cast<unsigned char>(text[0])) != "xyz"[i])
      return false;
  }
  return true;
}

bool ends_with(std::string_view file, std::string_view suffix) {
  return file.size() > suffix.size() &&
         file.substr(file.size() - suffix.size()) == suffix;
}

/// A row's point; false, with a finding, where the row is malformed.
bool read_row(const std::vector<Cell>& cells, const char* form, Mark at,
              Findings& findings, Eigen::Vector3d& point) {
  if (cells.size() != 3) {
    at.column = cells[std::min<std::size_t>(cells.size() - 1, 3)].column;
    findings.error(at, {},
                   std::string("expected three numbers ") + form + ", found " +
                       std::to_string(cells.size()));
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const NumberText number = scan_number(cells[i].text);
    if (number.problem.empty() && number.length == cells[i].text.size() &&
        number.length > 0) {
      point[static_cast<Eigen::Index>(i)] = number.value;
      continue;
    }
    at.column = cells[i].column;
    findings.error(at, {},
                   !number.problem.empty()
                       ? number.problem
                       : '\'' + std::string(cells[i].text) +
                             "' isn't a number; rows are " + form + " in metres");
    return false;
  }
  return true;
}

}  // namespace

bool is_point_file(std::string_view file) {
  return ends_with(file, ".ptl") || ends_with(file, ".csv");
}

std::vector<Eigen::Vector3d> parse_points(std::string_view text, std::string_view file,
                                          int source, Findings& findings) {
  const bool csv = ends_with(file, ".csv");
  const char* form = csv ? "x,y,z" : "x y z";
  std::vector<Eigen::Vector3d> points;
  int bad_rows = 0;
  bool first_row = true;
  int line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    ++line_number;
    if (line_number == 1 && line.substr(0, 3) == "\xEF\xBB\xBF") line.remove_prefix(3);
    line = line.substr(0, line.find_first_of(";#"));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;

    const auto cells = csv ? split_at_commas(line) : split_at_blanks(line);
    const bool header = csv && first_row && is_header(cells);
    first_row = false;
    if (header) continue;
    Eigen::Vector3d point;
    if (read_row(cells, form, {source, line_number, 1}, findings, point)) {
      points.push_back(point);
    } else if (++bad_rows == kMostFindings) {
      findings.error({source, line_number + 1, 0}, {},
                     "too many malformed rows; the rest of the file wasn't read");
      break;
    }
  }
  return points;
}

}  // namespace delos
