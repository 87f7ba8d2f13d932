// What the readers of all formats share: lines, cells, numbers, times.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/recording.h"

namespace delos::recordings {

/// A file while it is read.
struct Lines {
  std::string file;
  std::vector<std::string_view> lines;  ///< without their ends
  Diagnostics& findings;

  /// @param line from 0
  void error(std::size_t line, int column, std::string problem) const;
  void warning(std::size_t line, std::string problem) const;
};

/// One field of a line.
struct Cell {
  std::string_view text;  ///< trimmed
  int column = 0;         ///< from 1
};

/// @param separators any one of them ends a cell; blanks: runs of them
[[nodiscard]] std::vector<Cell> cells_of(std::string_view line, char separator);

/// A number with a point, of the whole cell; NaN where it is empty or "nan".
/// @returns nullopt where it is neither
[[nodiscard]] std::optional<double> number_of(std::string_view text);

/// How many metres, or seconds, one of a unit is; nullopt: no such unit.
[[nodiscard]] std::optional<double> unit_of(std::string_view name, bool of_time);

/// Frames and when they were taken, in the order of the file.
struct Frames {
  std::vector<std::size_t> line;  ///< of each, from 0
  std::vector<double> time;       ///< seconds
  std::vector<double> values;     ///< three a track, metres, frame after frame
};

/// A line a frame, of its number, its time in seconds and the columns of the tracks;
/// cells that are cut off at a line's end are gaps. Gives up after some twenty
/// findings.
/// @param begin the first frame's line
/// @param first column of each track's x, beside which y and z stand
/// @param unit metres in one of the file's
[[nodiscard]] Frames frames_of(const Lines& lines, std::size_t begin, char separator,
                               const std::vector<std::size_t>& first, double unit);

/// Evenly spaced frames: the period is the times' median step, and what is missing in
/// between becomes a gap.
/// @param period that the file says, else 0
/// @returns nullopt with findings: times that don't grow, or aren't evenly spaced, or
///          contradict the period
[[nodiscard]] std::optional<Recording> evenly_spaced(
    const Lines& lines, const std::vector<std::string>& names, const Frames& frames,
    double period);

/// Some files name a marker twice: the second is "head#2".
[[nodiscard]] std::vector<std::string> distinct(std::vector<std::string> names);

/// How many metres the lengths are of a file that doesn't say; with a finding where
/// nobody said.
[[nodiscard]] std::optional<double> unit_said(const std::string& file,
                                              const ReadOptions& options,
                                              Diagnostics& findings);

[[nodiscard]] std::optional<Recording> read_bvh(const Lines& lines,
                                                const ReadOptions& options);
[[nodiscard]] std::optional<Recording> read_csv(const Lines& lines,
                                                const ReadOptions& options);
[[nodiscard]] std::optional<Recording> read_motive(const Lines& lines);
[[nodiscard]] std::optional<Recording> read_trc(const Lines& lines);
[[nodiscard]] std::optional<Recording> read_tum(const Lines& lines);
/// @param bytes of the whole file
[[nodiscard]] std::optional<Recording> read_c3d(std::string_view bytes,
                                                const std::string& file,
                                                const ReadOptions& options,
                                                Diagnostics& findings);

}  // namespace delos::recordings
