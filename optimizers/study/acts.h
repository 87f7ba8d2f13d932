// What people do to a study, as changes of its scene.
#pragma once

#include <string>
#include <vector>

#include "delos/optimize/study.h"

namespace delos {

/// Where a study stands: its scene, and which of its variables don't change.
struct StudyPosition {
  Scene scene;
  std::vector<std::string> locked;  ///< paths
  int evaluations = 0;              ///< that the next round was given; 0: as planned
};

/// The position after an act other than undo.
/// @param folder where the scene's relative paths start
/// @throws std::invalid_argument one sentence: it can't be done
[[nodiscard]] StudyPosition after_act(StudyPosition position, const StudyAct& act,
                                      const std::filesystem::path& folder,
                                      PluginRegistry& plugins);

/// Take the locked variables out of a scene.
void remove_locked(Scene& scene, const std::vector<std::string>& locked);

[[nodiscard]] std::string text_of(const std::vector<std::string>& lines);
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

}  // namespace delos
