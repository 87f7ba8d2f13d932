// The pictures of a report that need no script.
#pragma once

#include <utility>
#include <vector>

#include "output/colour_range.h"
#include "report/shown.h"

namespace delos::report {

/// The room from a corner, then maps of a field: three levels of a volume, or a plane;
/// none of what isn't flat.
[[nodiscard]] std::vector<Still> stills_of(const Shown& shown);

/// The room as it is in the end, then each map before, after and as the change, to one
/// scale.
/// @pre both on the same samples
[[nodiscard]] std::vector<Still> stills_of(const Shown& before, const Shown& after);

/// Colours that hold all values of some fields; logarithmic where they span more than a
/// factor of 20.
[[nodiscard]] ColourRange common_range(const std::vector<const Field*>& fields,
                                       bool larger_is_better);

/// A change, ready to be drawn: where a sample is seen in only one of both fields it
/// takes the colour of the end.
struct Change {
  Field field;
  double end =
      0;  ///< colours run from −end to end: 98 % of the samples don't exceed it
  std::size_t gained = 0, lost = 0;  ///< samples seen only after, only before
};
[[nodiscard]] Change change_between(const Field& before, const Field& after,
                                    bool larger_is_better);

}  // namespace delos::report
