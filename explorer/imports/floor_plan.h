// Floor plans as rooms: the largest outline is a room, what lies in it stands from
// floor to ceiling.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "imports/rig.h"

namespace delos::imports {

/// A closed line, its last point not repeated.
struct Outline {
  std::string name;  ///< may be empty
  std::vector<Eigen::Vector2d> corners;
  double height = 0;  ///< 0: the plan doesn't say it
};

/// A map of geographic points, or of a floor: RFC 7946.
[[nodiscard]] bool is_geojson(const Value& root);
[[nodiscard]] std::vector<Outline> geojson_outlines(const Value& root,
                                                    const ImportOptions& options,
                                                    Rig& rig, Source& source);

/// A drawing; its polygons, rectangles and straight closed paths.
[[nodiscard]] bool is_svg(const Value& root);
[[nodiscard]] std::vector<Outline> svg_outlines(const Value& root,
                                                const ImportOptions& options, Rig& rig,
                                                Source& source);

/// Outlines as a room with what stands in it, four anchors in its corners, and samples
/// at breast height.
void furnish(Rig& rig, std::vector<Outline> outlines, const ImportOptions& options,
             Source& source);

}  // namespace delos::imports
