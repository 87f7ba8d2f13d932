#include "study/journal.h"

#include <stdexcept>
#include <utility>

#include "delos/scene/number.h"

namespace delos {
namespace {

/// A number of a scene, null where it has none of this name.
double* number(Scene& scene, const std::string& path, PluginRegistry& plugins) {
  const auto found = find_number(scene, path, plugins);
  const auto* number = std::get_if<SceneNumber>(&found);
  return number ? number->value : nullptr;
}

}  // namespace

Journal::Journal(std::filesystem::path folder, PluginRegistry& plugins)
    : folder_(std::move(folder)), plugins_(plugins) {}

void Journal::arrive(StudyPosition position) {
  position_ = std::move(position);
  // What a round was given is spent with it.
  std::erase_if(done_, [](const Done& done) { return done.of_round; });
}

void Journal::act(const StudyAct& act) {
  if (act.verb == "undo") return undo();
  StudyPosition after = after_act(position_, act, folder_, plugins_);
  done_.push_back({std::move(position_), after, act.verb == "extend"});
  position_ = std::move(after);
}

// Later acts are undone already: but for the values that searches found, the study
// stands as it did after the act.
void Journal::undo() {
  if (done_.empty()) throw std::invalid_argument("there is no act to undo");
  Done last = std::move(done_.back());
  done_.pop_back();
  StudyPosition& back = last.before;
  for (const VariableEntry& v : back.scene.variables) {
    const double* now = number(position_.scene, v.path, plugins_);
    const double* after = number(last.after.scene, v.path, plugins_);
    double* value = number(back.scene, v.path, plugins_);
    if (!now || !after || *after != *value) continue;
    *value = *now;
    for (const Follower& f : v.followers)
      *number(back.scene, f.path, plugins_) = f.factor * *now + f.offset;
  }
  if (!last.of_round) back.evaluations = position_.evaluations;
  position_ = std::move(back);
}

}  // namespace delos
