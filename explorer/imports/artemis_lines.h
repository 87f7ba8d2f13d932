// Input files of Artemis as lines of words.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "imports/value.h"

namespace delos::imports {

/// A line that says something: its words, and where it stands.
struct ArtemisLine {
  std::vector<std::string> words;  ///< at least one
  int number = 0;                  ///< from 1
};

/// What ';' begins is a comment.
[[nodiscard]] std::vector<ArtemisLine> artemis_lines(std::string_view text);

/// The numbers of a line from word `first` on, exactly `count`.
/// @returns nullopt where it has others
[[nodiscard]] std::optional<std::vector<double>> numbers_of(const ArtemisLine& line,
                                                            std::size_t first,
                                                            std::size_t count);

/// What stands before the measurements.
struct ArtemisHead {
  std::string motion, sample;  ///< as scenes write them
  std::vector<std::string> facts;
  double unit = 1;       ///< of its lengths, metres
  std::size_t next = 0;  ///< the line that follows
};

/// @param folder of the scene, which files of points are named from
/// @pre is_artemis()
[[nodiscard]] std::optional<ArtemisHead> artemis_head(
    const std::vector<ArtemisLine>& lines, const std::filesystem::path& file,
    const std::filesystem::path& folder, Source& source);

/// What a line's "GUI" asks for: a control of a number.
struct ArtemisControl {
  std::string kind, name;    ///< "slider", "S1_Noise"
  std::string lower, upper;  ///< as written; empty: no range
};

/// A number of a measurement, with its control.
struct ArtemisNumber {
  double value = 0;
  bool relative = false;
  std::optional<ArtemisControl> control;
};

/// One measurement as its lines say it.
struct ArtemisMeasurement {
  std::string type, role;  ///< role: "master", "slave" or empty
  std::string group;       ///< empty: none
  int line = 0;
  std::optional<ArtemisNumber> position[3], angle[3], r, dt;
  std::optional<std::vector<double>> left, up, look;
  std::string filename;  ///< of an .int file
};

/// The measurements that lines say, from one on.
[[nodiscard]] std::vector<ArtemisMeasurement> artemis_measurements(
    const std::vector<ArtemisLine>& lines, std::size_t from, Source& source);

}  // namespace delos::imports
