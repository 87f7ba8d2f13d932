// The acts of a study in their order, each of which can be undone.
#pragma once

#include <filesystem>
#include <vector>

#include "study/acts.h"

namespace delos {

/// Follows a study through its rounds and acts.
class Journal {
 public:
  /// @param folder where the scene's relative paths start
  Journal(std::filesystem::path folder, PluginRegistry& plugins);

  /// A round stands here: at its beginning, or at what it found.
  void arrive(StudyPosition position);

  /// Do an act. `undo` takes back the last act that isn't undone, of whatever round:
  /// the study stands as it did before, but keeps what searches have found since for
  /// variables that the act didn't move.
  /// @throws std::invalid_argument one sentence: it can't be done; nothing is done then
  void act(const StudyAct& act);

  [[nodiscard]] const StudyPosition& position() const { return position_; }

 private:
  struct Done {
    StudyPosition before, after;
    bool of_round;  ///< it holds for one round only
  };
  void undo();

  std::filesystem::path folder_;
  PluginRegistry& plugins_;
  StudyPosition position_;
  std::vector<Done> done_;  // and not undone
};

}  // namespace delos
