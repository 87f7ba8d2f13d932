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

/// The metric of a design minus the baseline's, on the design's samples and, as delos
/// compare does, under one fusion unless they demand different ones; where only one of
/// the two has a value it is Drawn::gained or Drawn::lost.
///
/// The summary: {metric, samples, finite, mean, min, max, better, gained, lost,
/// definition, pinned_definition}, the last null where it is the same; of which min and
/// max are {value, at}, null where no sample has both; `better` is the part of the
/// samples at which the design is better.
/// @param most as draw_field()
/// @throws std::invalid_argument as make_steady_solver(), or that the baseline doesn't
///         know the metric
[[nodiscard]] DrawnField draw_difference(const LoadedScene& loaded, Baseline& baseline,
                                         std::size_t most, const FieldOptions& options);

}  // namespace delos::session
