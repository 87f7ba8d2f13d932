#include "delos/rigid_body/tracker.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <utility>

#include "delos/rigid_body/align.h"
#include "delos/rigid_body/matching.h"
#include "delos/rigid_body/window.h"

namespace delos::rigid_body {
namespace {

/// Of what is triangulated, root mean square in pixels over that of the noise: of two
/// sightings one number of four is left, 2 σ²·χ²₁/4.
constexpr double kMostMissed = 3;

}  // namespace

BodyTracker::BodyTracker(std::vector<Camera> cameras, std::vector<Eigen::Vector3d> body,
                         const TrackerOptions& options)
    : cameras_(std::move(cameras)),
      body_(std::move(body)),
      options_(options),
      filter_(options.noise) {}

std::optional<BodyPose> BodyTracker::predicted(double lag) const {
  if (!last_) return std::nullopt;
  if (frames_ < 2) return last_->pose;
  return moved(filter_.next(dt_), lag, last_->pose);
}

std::optional<MeasuredPose> BodyTracker::pose_of(
    const std::vector<std::vector<Sighting>>& seen, TrackedFrame& frame) const {
  std::vector<std::size_t> marker;
  std::vector<Eigen::Vector3d> b, w;
  for (std::size_t i = 0; i < body_.size(); ++i) {
    if (seen[i].size() < 2) continue;
    const auto p = triangulated(cameras_, seen[i], kMostMissed * options_.sigma);
    if (!p) continue;
    marker.push_back(i);
    b.push_back(body_[i]);
    w.push_back(*p);
  }
  const auto alignment = aligned_rejecting(b, w, options_.tolerance);
  if (!alignment) return std::nullopt;
  std::vector<MarkerImage> images;
  for (const std::size_t k : alignment->kept)
    for (const Sighting& s : seen[marker[k]]) images.push_back({marker[k], s});
  frame.markers = alignment->kept.size();
  return refined(alignment->pose, body_, cameras_, images, options_.sigma);
}

std::optional<MeasuredPose> BodyTracker::look_in_windows(double dt,
                                                         const Images& images,
                                                         TrackedFrame& frame) const {
  if (!last_ || frames_ < 2) return std::nullopt;
  const MeasuredPose predicted = predicted_pose(filter_, dt, *last_);
  std::vector<std::vector<Sighting>> seen(body_.size());
  double area = 0;
  for (std::size_t c = 0; c < cameras_.size(); ++c) {
    // An image is of the marker whose window it is nearest to.
    std::vector<std::pair<double, std::size_t>> nearest(images[c].size(),
                                                        {options_.gate, body_.size()});
    for (std::size_t i = 0; i < body_.size(); ++i) {
      const auto window =
          search_window(cameras_[c], predicted, body_[i], options_.sigma);
      if (!window) continue;
      area += std::numbers::pi * options_.gate *
              std::sqrt(window->covariance.determinant()) / cameras_[c].size.prod();
      std::optional<std::size_t> best;
      double least = options_.gate;
      for (std::size_t k = 0; k < images[c].size(); ++k) {
        const double distance = window->distance(images[c][k]);
        if (distance >= least || distance >= nearest[k].first) continue;
        least = distance;
        best = k;
      }
      if (!best) continue;
      if (const std::size_t other = nearest[*best].second; other < body_.size())
        std::erase_if(seen[other], [c](const Sighting& s) { return s.camera == c; });
      nearest[*best] = {least, i};
      seen[i].push_back({c, images[c][*best]});
    }
  }
  frame.window_area = area / static_cast<double>(cameras_.size());
  return pose_of(seen, frame);
}

std::optional<MeasuredPose> BodyTracker::look_all_over(const Images& images,
                                                       TrackedFrame& frame) const {
  std::vector<Eigen::Vector3d> cloud;
  std::vector<std::vector<Sighting>> of;
  for (std::size_t c = 0; c < cameras_.size(); ++c)
    for (std::size_t d = c + 1; d < cameras_.size(); ++d)
      for (const Eigen::Vector2d& one : images[c])
        for (const Eigen::Vector2d& other : images[d]) {
          std::vector<Sighting> pair = {{c, one}, {d, other}};
          const auto p = triangulated(cameras_, pair, kMostMissed * options_.sigma);
          if (!p) continue;
          cloud.push_back(*p);
          of.push_back(std::move(pair));
        }
  const Matches matches = matched(body_, cloud, options_.tolerance);
  if (matches.empty()) return std::nullopt;
  std::vector<std::vector<Sighting>> seen(body_.size());
  for (std::size_t i = 0; i < body_.size(); ++i)
    if (matches[i]) seen[i] = of[*matches[i]];
  return pose_of(seen, frame);
}

TrackedFrame BodyTracker::frame(double dt, const Images& images) {
  TrackedFrame found;
  found.measured = look_in_windows(dt, images, found);
  found.by_windows = found.measured.has_value();
  if (!found.measured) found.measured = look_all_over(images, found);
  dt_ = dt;
  if (!found.measured) {
    found.markers = 0;
    if (++coasting_ > options_.coast || frames_ < 2) {
      last_.reset();
      frames_ = 0;
      filter_ = BodyFilter(options_.noise);
    } else {
      last_ = predicted_pose(filter_, dt, *last_);
      filter_.coast(dt);
    }
    return found;
  }
  if (last_) {
    filter_.frame(dt, virtual_points(last_->pose, options_.arm),
                  virtual_points(found.measured->pose, options_.arm));
    frames_ += frames_ == 0 ? 2 : 1;
  }
  coasting_ = 0;
  last_ = found.measured;
  return found;
}

}  // namespace delos::rigid_body
