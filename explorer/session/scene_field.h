// A scene's field, however it is sampled.
#pragma once

#include <memory>

#include "delos/field/adaptive.h"
#include "delos/field/verify.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// A field, and the octree behind it where its samples are adaptive.
struct Evaluation {
  Field field;
  std::shared_ptr<const AdaptiveField> octree;  ///< null where they aren't
};

/// The adaptive set of a scene, or null.
[[nodiscard]] const AdaptiveSampling* adaptive_sampling(const Scene& scene);

/// Evaluate a scene on its own samples.
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] Evaluation evaluate_scene(const LoadedScene& loaded,
                                        const FieldOptions& options);

/// The contract's document (`field --json`) without warnings and specifications.
[[nodiscard]] Json field_answer(const LoadedScene& loaded, const Field& field);

/// Its `verification`.
[[nodiscard]] Json verification_json(const Verification& verification);

}  // namespace delos::session
