#include "evaluation.h"

#include "progress.h"

namespace delos::cli {

Evaluation evaluate_scene(const LoadedScene& loaded, const SceneOptions& options,
                          const Interrupt& interrupt) {
  Progress progress(loaded.scene.name);
  try {
    return session::evaluate_scene(loaded, field_options(options, interrupt, progress));
  } catch (const std::invalid_argument& error) {
    throw unsolvable(options, error);
  }
}

}  // namespace delos::cli
