// Lists of sample points in files: .ptl as Artemis writes them, and .csv.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "scene/findings.h"

namespace delos {

/// True for the suffixes that are read: .ptl and .csv.
[[nodiscard]] bool is_point_file(std::string_view file);

/// Read the rows of a file, x y z in metres each.
///
/// .ptl: numbers between blanks; .csv: numbers between commas, with or without the
/// header x,y,z. In both, ';' and '#' begin a comment, and empty lines are passed over.
/// @param file   its name, for the suffix and for messages
/// @param source its number in `findings`; every malformed row is a finding there.
[[nodiscard]] std::vector<Eigen::Vector3d> parse_points(std::string_view text,
                                                        std::string_view file,
                                                        int source, Findings& findings);

}  // namespace delos
