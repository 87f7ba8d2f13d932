// Which points of a cloud are a body's markers, by the distances between them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "delos/rigid_body/filter.h"

namespace delos::rigid_body {

/// Marker i of a body is point `of[i]` of a cloud, or missing.
using Matches = std::vector<std::optional<std::size_t>>;

/// The most markers that can be found in a cloud so that all distances between them are
/// the body's within `tolerance`, and no mirror image of it. Of equally many the
/// one whose distances fit best. By depth first, markers in their order, leaving off
/// where no more can be found than were: the problem is NP-complete, and small.
/// @param may where given, whether a point may be a marker: may[i][k] for marker i and
///        point k, such as those in its search window
/// @returns empty where fewer than three are found
/// @throws std::length_error more than 1e7 pairs were tried: too large a cloud for so
///         large a tolerance
[[nodiscard]] Matches matched(std::span<const Eigen::Vector3d> body,
                              std::span<const Eigen::Vector3d> cloud, double tolerance,
                              const std::vector<std::vector<bool>>& may = {});

}  // namespace delos::rigid_body
