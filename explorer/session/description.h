// A design as a page shows it.
#pragma once

#include "session/design.h"
#include "session/json.h"

namespace delos::session {

/// What there is, where it stands and what may be changed:
///
///   {revision, undo, redo, name, surroundings, metric: {name, unit, larger_is_better},
///   metrics,
///    definition, fusion, box: {min, max} of the samples, room: {min, max} of devices
///    too, devices: [{name, type, rate, mount, group, surface, coordinates, at, facing,
///               value, pose: {p, R}, params: {name: value}, outline}],
///    types: {type: parameter_table()}}
///
/// `facing` is the scene's key, "" where it has none, `value` its numbers; a pose is
/// that in the world, of what stands there; an outline is view_outline().
[[nodiscard]] Json description(const Design& design, std::size_t revision,
                               PluginRegistry& plugins);
/// The same of what has no history.
[[nodiscard]] Json description(const LoadedScene& loaded, PluginRegistry& plugins);

/// What devices see by or are hidden by:
///
///   {occluders: [{name, path, size, R, vertices: [x, y, z, …], triangles: [i, j, k,
///   …],
///                 carried, room}],
///    regions: the same without the last two, surfaces: [line of points, …],
///    beacons: [[x, y, z], …]}
///
/// Occluders are placed in the world, carried ones in the target's frame. A path is ""
/// where a hand can't change it; a size, along the axes of R, is null but for boxes.
[[nodiscard]] Json surroundings(const Scene& scene);

/// Around all samples, metres.
[[nodiscard]] Eigen::AlignedBox3d sample_box(const Scene& scene);

/// Around all samples and devices' places in the world, metres.
[[nodiscard]] Eigen::AlignedBox3d room_box(const LoadedScene& loaded);

}  // namespace delos::session
