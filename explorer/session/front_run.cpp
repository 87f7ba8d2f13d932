#include "session/front_run.h"

#include <stdexcept>
#include <utility>

#include "session/tradeoff_answer.h"

namespace delos::session {

FrontRun::FrontRun(Scene scene, std::string constraint, std::vector<double> levels,
                   OptimizeOptions options, PluginRegistry& plugins)
    : scene_(std::move(scene)),
      constraint_(std::move(constraint)),
      levels_(std::move(levels)),
      options_(std::move(options)),
      plugins_(plugins) {
  (void)constraint_limit(scene_, constraint_);
  options_.cancel = &stop_;
}

VariableValues FrontRun::point(std::size_t index) const {
  const std::lock_guard lock(mutex_);
  if (index >= points_.size())
    throw std::invalid_argument("the front has no point " + std::to_string(index));
  return points_[index];
}

bool FrontRun::advance() {
  const std::vector<FrontPoint> points =
      search_front(scene_, plugins_, constraint_, levels_, options_,
                   [this](std::size_t done, std::size_t of) {
                     const std::lock_guard lock(mutex_);
                     done_ = done;
                     of_ = of;
                     tell();
                   });
  Json front = front_json(scene_, constraint_, points, plugins_);
  const std::lock_guard lock(mutex_);
  front_ = std::move(front);
  points_.clear();
  for (const FrontPoint& point : points)
    points_.push_back(values_of(point.scene, plugins_));
  tell();
  return !stop_;
}

Json FrontRun::json(const Heard&) const {
  const std::lock_guard lock(mutex_);
  Json json = head("front");
  json["done"] = done_;
  json["of"] = of_;
  json["front"] = front_;
  return json;
}

}  // namespace delos::session
