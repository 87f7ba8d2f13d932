// A scene's own metrics: the keys of `metrics`.
#pragma once

#include <vector>

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

/// @param states_known false where the motion has findings, so that nobody knows which
///                     names formulas have
/// @returns false where there is a finding, so that a name may be missing
bool read_metrics(Reader& reader, const Place& at, bool states_known, Scene& out);

[[nodiscard]] Node write_metrics(const std::vector<MetricEntry>& metrics);

[[nodiscard]] Shape metric_shape();

}  // namespace delos
