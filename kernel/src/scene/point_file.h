// Rows of numbers in files, such as sample points: .ptl as Artemis writes them, and
// .csv.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/reader.h"

namespace delos {

/// True for the suffixes that are read: .ptl and .csv.
[[nodiscard]] bool is_point_file(std::string_view file);

/// What the rows of a file hold.
struct RowForm {
  std::vector<std::string> columns;  ///< as a header calls them, in order
  std::vector<std::size_t> lengths;  ///< how many of them a row may give, rising
};

/// Read the rows of a file.
///
/// .ptl: numbers between blanks; .csv: numbers between commas, with or without a
/// header. In both, ';' and '#' begin a comment, and empty lines are passed over.
/// @param file   its name, for the suffix and for messages
/// @param source its number in `findings`; every malformed row is a finding there.
[[nodiscard]] std::vector<std::vector<double>> parse_rows(std::string_view text,
                                                          std::string_view file,
                                                          const RowForm& form,
                                                          int source,
                                                          Findings& findings);

/// The file that a scene names at a place, its rows read; relative to the scene.
/// @param what "points": what a file without rows has none of
/// @returns nullopt with a finding, also where there are no rows
[[nodiscard]] std::optional<std::vector<std::vector<double>>> read_row_file(
    Reader& reader, const Place& at, const std::string& written, const RowForm& form,
    const char* what);

}  // namespace delos
