#include "session/design.h"

#include <utility>

namespace delos::session {

Design::Design(std::filesystem::path file, LoadedScene loaded)
    : file_(std::move(file)), loaded_(std::move(loaded)) {}

std::optional<Design> Design::open(const std::filesystem::path& file,
                                   PluginRegistry& plugins, Diagnostics& findings) {
  std::optional<LoadedScene> loaded = load(file, {}, plugins, findings);
  if (!loaded) return std::nullopt;
  return Design(file, std::move(*loaded));
}

bool Design::change(std::vector<Override> changes, const std::string& gesture,
                    PluginRegistry& plugins, Diagnostics& findings) {
  History history = history_;
  history.add(std::move(changes), gesture);
  return take(history, plugins, findings);
}

bool Design::undo(PluginRegistry& plugins) {
  History history = history_;
  Diagnostics ignored;  // it was in order then
  return history.undo() && take(history, plugins, ignored);
}

bool Design::redo(PluginRegistry& plugins) {
  History history = history_;
  Diagnostics ignored;
  return history.redo() && take(history, plugins, ignored);
}

bool Design::take(const History& history, PluginRegistry& plugins,
                  Diagnostics& findings) {
  std::optional<LoadedScene> loaded = with(history.changes(), plugins, findings);
  if (!loaded) return false;
  loaded_ = std::move(*loaded);
  history_ = history;
  if (history_.settled().size() > kMostSettled) settle(plugins);
  return true;
}

std::optional<LoadedScene> Design::with(const std::vector<Override>& changes,
                                        PluginRegistry& plugins,
                                        Diagnostics& findings) const {
  return text_ ? load_text(*text_, file_, changes, plugins, findings, &loaded_.system)
               : load(file_, changes, plugins, findings, {}, &loaded_.system);
}

/// Put settled changes into the text that the others begin from.
void Design::settle(PluginRegistry& plugins) {
  Diagnostics ignored;
  const auto base = with(history_.settled(), plugins, ignored);
  if (!base) return;  // alone they needn't be in order: they stay as they are
  text_ = write_scene(with_absolute_files(base->scene, file_.parent_path()));
  history_.forget_settled();
}

std::string Design::text() const {
  return write_scene(with_absolute_files(loaded_.scene, file_.parent_path()));
}

}  // namespace delos::session
