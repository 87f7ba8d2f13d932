#include "session/selection_run.h"

#include <stdexcept>
#include <utility>

#include "delos/optimize/cover_scene.h"
#include "session/scene_changes.h"
#include "session/search_answer.h"
#include "session/select_answer.h"

namespace delos::session {

SelectionRun::SelectionRun(Scene scene, SelectOptions options, bool kept,
                           PluginRegistry& plugins)
    : scene_(std::move(scene)),
      options_(std::move(options)),
      kept_(kept),
      plugins_(plugins),
      begun_(std::chrono::steady_clock::now()),
      unit_(scene_.selection.cover ? "1" : objective_unit(scene_)) {
  options_.cancel = &stop_;
  options_.progress = [this](const SelectProgress& at) { hear(at); };
}

SelectionRun::~SelectionRun() {
  std::error_code ignored;
  if (!kept_) std::filesystem::remove(options_.study, ignored);
}

std::vector<Override> SelectionRun::changes() const {
  const std::lock_guard lock(mutex_);
  if (!chosen_) throw std::invalid_argument("nothing is chosen yet");
  return changes_between(scene_, *chosen_);
}

bool SelectionRun::advance() {
  if (scene_.selection.cover) {
    const SceneCover cover = cover_scene(scene_, plugins_, options_);
    take(cover_json(cover), cover.all, cover.chosen);
  } else {
    const SelectResult result = select(scene_, plugins_, options_);
    take(select_json(result), result.all, result.chosen);
  }
  return !stop_;
}

void SelectionRun::hear(const SelectProgress& at) {
  const std::chrono::duration<double> now = std::chrono::steady_clock::now() - begun_;
  const std::lock_guard lock(mutex_);
  ready_ = at.ready;
  const bool told = !curve_.empty() && curve_.back().value == at.value &&
                    curve_.back().bound == at.lower_bound;
  if (at.ready < 1 || told) return tell();
  curve_.push_back({now.count(), at.value, at.lower_bound, at.nodes});
  // Every second point goes, never the last.
  if (curve_.size() > kMostPoints) {
    std::vector<Point> half;
    for (std::size_t i = curve_.size() % 2 == 0; i < curve_.size(); i += 2)
      half.push_back(curve_[i]);
    curve_ = std::move(half);
  }
  tell();
}

void SelectionRun::take(Json result, const CandidateScene& all,
                        const std::vector<std::size_t>& chosen) {
  Scene scene = chosen_scene(all, chosen);
  const std::lock_guard lock(mutex_);
  result_ = std::move(result);
  chosen_ = std::move(scene);
  tell();
}

Json SelectionRun::json(const Heard&) const {
  const std::lock_guard lock(mutex_);
  Json json = head("selection");
  json["study"] = kept_ ? Json(options_.study.filename().string()) : Json();
  json["unit"] = unit_;
  json["ready"] = number(ready_);
  json["curve"] = Json::array();
  for (const Point& point : curve_)
    json["curve"].push_back({{"seconds", point.seconds},
                             {"value", number(point.value)},
                             {"bound", number(point.bound)},
                             {"nodes", point.nodes}});
  json["result"] = result_;
  return json;
}

}  // namespace delos::session
