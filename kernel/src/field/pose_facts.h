// What a block of layers tells of a pose besides what is known of its state.
#pragma once

#include "delos/layers/layers.h"
#include "delos/steady/state_metric.h"

namespace delos {

/// @param with_footprint whether a metric reads it: devices are asked for it
[[nodiscard]] PoseFacts facts_of(const System& system, const LayerBlock& block,
                                 int lane, const TargetPose& pose, bool with_footprint);

}  // namespace delos
