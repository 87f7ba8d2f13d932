// A scene while it is changed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "session/history.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// A scene file and what was changed since, each change as `--set` would make it.
class Design {
 public:
  /// Changes that settle before they become a part of the text that changes begin from,
  /// so that neither memory nor the time of a change grows with those made.
  static constexpr std::size_t kMostSettled = 200;

  /// @returns nullopt where the findings hold an error
  /// @throws as load()
  [[nodiscard]] static std::optional<Design> open(const std::filesystem::path& file,
                                                  PluginRegistry& plugins,
                                                  Diagnostics& findings);

  /// Change values together, as one step or a part of one. What follows a variable of
  /// the scene follows the change, as in a study.
  /// @param gesture as History::add()
  /// @returns false, with findings, where the scene would not be in order: it stays as
  ///          it was
  /// @throws as load(); it stays as it was
  bool change(std::vector<Override> changes, const std::string& gesture,
              PluginRegistry& plugins, Diagnostics& findings);
  /// @returns false where there is nothing to undo
  bool undo(PluginRegistry& plugins);
  bool redo(PluginRegistry& plugins);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const LoadedScene& loaded() const { return loaded_; }
  [[nodiscard]] const History& history() const { return history_; }
  /// Grows whenever what stands around the devices is another: surroundings().
  [[nodiscard]] std::size_t surroundings() const { return surroundings_; }
  /// The scene as text that reads the same in any folder of this machine.
  [[nodiscard]] std::string text() const;

 private:
  Design(std::filesystem::path file, LoadedScene loaded);
  bool take(const History& history, PluginRegistry& plugins, Diagnostics& findings);
  [[nodiscard]] std::optional<LoadedScene> with(const std::vector<Override>& changes,
                                                PluginRegistry& plugins,
                                                Diagnostics& findings) const;
  void settle(PluginRegistry& plugins);
  void keep_up_with(const History& history);

  /// A scene on the way, so that a change needn't begin from the file.
  struct Checkpoint {
    std::size_t steps;  ///< History::steps() of it
    std::string text;
  };
  /// Steps that are read again at a change.
  static constexpr std::size_t kMostReplayed = 64;

  std::filesystem::path file_;
  /// What the changes begin from, once some have settled; else the file.
  std::optional<std::string> text_;
  LoadedScene loaded_;
  History history_;
  std::size_t surroundings_ = 0;
  std::optional<Checkpoint> checkpoint_;
};

}  // namespace delos::session
