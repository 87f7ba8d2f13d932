// What is known of the position at a point, as a body: an ellipsoid, or the directions
// in which it has no end.
#pragma once

#include <cstddef>

#include "delos/field/evaluate.h"
#include "delos/steady/fused_state.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// {sigma: [3], axes: rows of unit vectors}, standard deviations of the position along
/// their axes, metres; null where a direction is lost, or the state has no position in
/// space.
[[nodiscard]] Json ellipsoid_json(const System& system, const FusedState& state);

/// The lost directions of the state as far as they move the position: unit vectors in
/// the world.
[[nodiscard]] Json lost_json(const System& system, const FusedState& state);

/// Ellipsoids and lost directions on a lattice of `most` points or fewer over the
/// scene's samples: [{at, ellipsoid, lost}], those within solids left out.
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] Json lattice_json(const LoadedScene& loaded, std::size_t most,
                                const FieldOptions& options);

}  // namespace delos::session
