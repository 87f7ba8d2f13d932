// What a block of layers tells of a pose besides what is known of its state.
#pragma once

#include "delos/layers/layers.h"
#include "delos/steady/state_metric.h"
#include "field/linearisation.h"

namespace delos {

/// @param with_footprint whether a metric reads it: devices are asked for it
/// @param normal of the surface that the pose is on, a unit vector in W: what a pixel
///        covers is a length along it then; zero: it is one across the sight line
[[nodiscard]] PoseFacts facts_of(
    const System& system, const LayerBlock& block, int lane, const TargetPose& pose,
    bool with_footprint, const Eigen::Vector3d& normal = Eigen::Vector3d::Zero());

/// Whether a metric reads PoseFacts::nonlinearity or unscented_ratio.
[[nodiscard]] bool reads_linearisation(const Metric& metric);

/// Add those two, of the error before an update; of a cycle before the worst one.
void add_linearisation(const FusedState& state, const TargetPose& pose,
                       LinearisationCheck& check, PoseFacts& facts);

}  // namespace delos
