#include "session/design.h"

#include <utility>

#include "delos/scene/followers.h"

namespace delos::session {
namespace {

bool same_surroundings(const Scene& a, const Scene& b) {
  return a.occluders == b.occluders && a.clutter == b.clutter &&
         a.regions == b.regions && a.beacons == b.beacons && a.surfaces == b.surfaces;
}

}  // namespace

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
  const History before = history_;
  const Scene scene = loaded_.scene;
  const auto taken = [&] {
    History history = before;
    history.add(changes, gesture);
    return take(history, plugins, findings);
  };
  if (!taken()) return false;
  const std::vector<Override> more = following(scene, loaded_.scene, plugins);
  if (more.empty()) return true;
  changes.insert(changes.end(), more.begin(), more.end());
  if (taken()) return true;
  Diagnostics ignored;  // it was in order then
  take(before, plugins, ignored);
  return false;
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
  keep_up_with(history);
  std::optional<LoadedScene> loaded =
      checkpoint_
          ? load({file_, checkpoint_->text, history.changes_after(checkpoint_->steps)},
                 plugins, findings, {}, &loaded_.system)
          : with(history.changes(), plugins, findings);
  if (!loaded) return false;
  if (!same_surroundings(loaded_.scene, loaded->scene)) ++surroundings_;
  loaded_ = std::move(*loaded);
  history_ = history;
  if (history_.settled().size() > kMostSettled) settle(plugins);
  return true;
}

/// A checkpoint that isn't on the way to a history any more goes; where a step begins
/// that is far from the last one, what there is now becomes one.
void Design::keep_up_with(const History& history) {
  if (checkpoint_ && (history.steps() < checkpoint_->steps ||
                      history.settled_steps() > checkpoint_->steps))
    checkpoint_.reset();
  const std::size_t from = checkpoint_ ? checkpoint_->steps : history_.settled_steps();
  if (history.steps() > history_.steps() && history_.steps() - from >= kMostReplayed)
    checkpoint_ = {history_.steps(), text()};
}

std::optional<LoadedScene> Design::with(const std::vector<Override>& changes,
                                        PluginRegistry& plugins,
                                        Diagnostics& findings) const {
  return load({file_, text_, changes}, plugins, findings, {}, &loaded_.system);
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
