// How a design differs from one that was kept to compare with.
#pragma once

#include <optional>

#include "session/drawn_field.h"

namespace delos::session {

/// A design as it was, and its field, so that it isn't worked out at every change of
/// the other one.
struct Baseline {
  LoadedScene loaded;
  std::optional<Field> field;  ///< over the samples of the last comparison
};

/// How a metric changes from one field to another over the same samples, times a
/// factor; where only one of them has a value it is Drawn::gained or Drawn::lost.
///
/// The summary: {metric, samples, finite, mean, min, max, better, gained, lost}, of
/// which min and max are {value, at}, null where no sample has both; `better` is the
/// part of the samples at which the second is better.
/// @param factor > 0
[[nodiscard]] DrawnField drawn_change(const Field& before, const Field& after,
                                      double factor = 1);

/// The metric of a design minus the baseline's, on the design's samples and, as delos
/// compare does, under one fusion unless they demand different ones, as drawn_change().
/// The summary has {definition, pinned_definition} too, the last null where it is the
/// same.
/// @param most as draw_field()
/// @throws std::invalid_argument as make_steady_solver(), or that the baseline doesn't
///         know the metric
[[nodiscard]] DrawnField draw_difference(const LoadedScene& loaded, Baseline& baseline,
                                         std::size_t most, const FieldOptions& options);

/// The same on other samples.
[[nodiscard]] DrawnField draw_difference_on(const LoadedScene& loaded,
                                            Baseline& baseline, const Samples& samples,
                                            const FieldOptions& options);

}  // namespace delos::session
