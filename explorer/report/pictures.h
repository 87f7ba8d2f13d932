// The maps of a report: which slices, and what their colours stand for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "delos/field/evaluate.h"
#include "report/map_figure.h"

namespace delos::report {

/// A field, and the slices of it that are shown: three levels of a volume, or the
/// plane.
struct View {
  Field field;
  std::vector<PictureOptions> slices;  ///< empty where there is nothing flat to show
};
[[nodiscard]] View view_of(Field field, bool larger_is_better);

/// Colours that hold all values of some fields; logarithmic where they span more than a
/// factor of 20.
[[nodiscard]] ColourRange common_range(const std::vector<const Field*>& fields,
                                       bool larger_is_better);

/// A change, ready to be drawn: where a sample is seen in only one of both fields it
/// takes the colour of the end.
struct Change {
  Field field;
  ColourRange colours;  ///< low = −high, which 98 % of the samples don't exceed
  std::size_t gained = 0, lost = 0;  ///< samples seen only after, only before
};
[[nodiscard]] Change change_between(const Field& before, const Field& after,
                                    bool larger_is_better);

/// Least, median, mean, 95 % and greatest of one field, or of two side by side.
[[nodiscard]] Html key_figures(const std::vector<const Field*>& fields,
                               const std::vector<std::string>& names,
                               bool larger_is_better);

/// All slices of a field with its devices.
[[nodiscard]] Html maps(const std::vector<View>& views,
                        const std::vector<Marker>& markers);

/// All slices of two fields side by side, with their change.
[[nodiscard]] Html maps(const std::vector<View>& before, const std::vector<View>& after,
                        const std::vector<Marker>& were, const std::vector<Marker>& are,
                        bool larger_is_better);

}  // namespace delos::report
