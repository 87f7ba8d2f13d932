#include "scene/point_file.h"

#include <algorithm>
#include <cctype>

#include "delos/text/numbers.h"
#include "document/file_text.h"

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

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

bool is_header(const std::vector<Cell>& cells, const RowForm& form) {
  return cells.size() <= form.columns.size() &&
         std::equal(cells.begin(), cells.end(), form.columns.begin(),
                    [](const Cell& cell, const std::string& column) {
                      return lower_case(cell.text) == column;
                    });
}

bool ends_with(std::string_view file, std::string_view suffix) {
  return file.size() > suffix.size() &&
         file.substr(file.size() - suffix.size()) == suffix;
}

/// "x,y,z", the first columns of a form.
std::string columns_text(const RowForm& form, std::size_t count, const char* between) {
  std::string text = form.columns[0];
  for (std::size_t i = 1; i < count; ++i) text += between + form.columns[i];
  return text;
}

/// "three numbers x,y,z", or "3 numbers x,y,z or 6 numbers x,y,z,nx,ny,nz".
std::string expected(const RowForm& form, const char* between) {
  if (form.lengths == std::vector<std::size_t>{3})
    return "three numbers " + columns_text(form, 3, between);
  std::string text;
  for (const std::size_t n : form.lengths)
    text += (text.empty() ? "" : " or ") + std::to_string(n) + " numbers " +
            columns_text(form, n, between);
  return text;
}

/// What to do where commas seem to stand for decimal points: quoted numbers and blanks
/// within cells, or commas where blanks separate.
std::string about_decimal_commas(const std::vector<Cell>& cells, const char* between) {
  const bool csv = *between == ',';
  for (const Cell& cell : cells)
    if (cell.text.find_first_of(csv ? "\" \t" : ",") != std::string_view::npos)
      return std::string("; separate numbers by '") + between +
             "' and write decimals with a point";
  return "";
}

/// A row's numbers; empty, with a finding, where the row is malformed.
/// @param semicolon whether one ended the row, which other programs separate by
std::vector<double> read_row(const std::vector<Cell>& cells, const RowForm& form,
                             const char* between, bool semicolon, Mark at,
                             Findings& findings) {
  const auto& lengths = form.lengths;
  if (std::find(lengths.begin(), lengths.end(), cells.size()) == lengths.end()) {
    at.column = cells[std::min(cells.size() - 1, lengths.back())].column;
    findings.error(
        at, {},
        "expected " + expected(form, between) + ", found " +
            std::to_string(cells.size()) +
            (semicolon ? "; ';' begins a comment: separate numbers by '" +
                             std::string(between) + "' and write decimals with a point"
                       : about_decimal_commas(cells, between)));
    return {};
  }
  std::vector<double> row;
  for (const Cell& cell : cells) {
    const NumberText number = scan_number(cell.text);
    if (number.problem.empty() && number.length == cell.text.size() &&
        number.length > 0) {
      row.push_back(number.value);
      continue;
    }
    at.column = cell.column;
    findings.error(
        at, {},
        !number.problem.empty()
            ? number.problem
            : '\'' + std::string(cell.text) + "' isn't a number; rows are " +
                  columns_text(form, lengths.front(), between) + " in metres" +
                  (*between == ',' ? "" : about_decimal_commas({cell}, between)));
    return {};
  }
  return row;
}

}  // namespace

bool is_point_file(std::string_view file) {
  return ends_with(file, ".ptl") || ends_with(file, ".csv");
}

std::vector<std::vector<double>> parse_rows(std::string_view text,
                                            std::string_view file, const RowForm& form,
                                            int source, Findings& findings) {
  const bool csv = ends_with(file, ".csv");
  std::vector<std::vector<double>> rows;
  int bad_rows = 0;
  bool first_row = true;
  int line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    ++line_number;
    if (line_number == 1 && line.substr(0, 3) == "\xEF\xBB\xBF") line.remove_prefix(3);
    const std::size_t comment = std::min(line.find_first_of(";#"), line.size());
    const bool semicolon = line.substr(comment).starts_with(';');
    line = line.substr(0, comment);
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;

    const auto cells = csv ? split_at_commas(line) : split_at_blanks(line);
    const bool header = csv && first_row && is_header(cells, form);
    first_row = false;
    if (header) continue;
    auto row = read_row(cells, form, csv ? "," : " ", semicolon,
                        {source, line_number, 1}, findings);
    if (!row.empty()) {
      rows.push_back(std::move(row));
    } else if (++bad_rows == kMostFindings) {
      findings.error({source, line_number + 1, 0}, {},
                     "too many malformed rows; the rest of the file wasn't read");
      break;
    }
  }
  return rows;
}

std::optional<std::vector<std::vector<double>>> read_row_file(
    Reader& reader, const Place& at, const std::string& written, const RowForm& form,
    const char* what) {
  if (!is_point_file(written)) {
    reader.error(at, '\'' + written + "' is neither a .ptl nor a .csv file");
    return std::nullopt;
  }
  const std::filesystem::path path = reader.folder / written;
  std::string why;
  const std::optional<std::string> text = file_text(path, why);
  if (!text) {
    reader.error(at, "there is no readable file '" + path.string() + "': " + why);
    return std::nullopt;
  }
  // Every other byte of what is written in ASCII is 0.
  if (text->starts_with("\xFF\xFE") || text->starts_with("\xFE\xFF") ||
      text->substr(0, 2).find('\0') != std::string::npos) {
    reader.error(at, "the file '" + path.string() + "' is UTF-16; save it as UTF-8");
    return std::nullopt;
  }
  const std::size_t before = reader.findings.errors();
  const int source = reader.findings.add_source(path.string());
  auto rows = parse_rows(*text, written, form, source, reader.findings);
  if (reader.findings.errors() != before) return std::nullopt;
  if (rows.empty()) {
    reader.error(at, "the file '" + path.string() + "' has no " + what);
    return std::nullopt;
  }
  return rows;
}

}  // namespace delos
