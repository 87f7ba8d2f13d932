// A scene's field, however it is sampled.
#pragma once

#include "command.h"
#include "session/written_field.h"

namespace delos::cli {

using session::drawable;
using session::Evaluation;
using session::is_scene;
using session::planned_samples;
using session::write_evaluation;

/// Evaluate a scene on its own samples, with progress on stderr and a clean end at
/// Ctrl-C.
/// @throws Failure as unsolvable()
[[nodiscard]] Evaluation evaluate_scene(const LoadedScene& loaded,
                                        const SceneOptions& options,
                                        const Interrupt& interrupt);

}  // namespace delos::cli
