#include "delos/simulation/track_readings.h"

#include <stdexcept>

#include "simulation/motion_steps.h"

namespace delos {

std::vector<TrackedInstant> track_readings(const System& system,
                                           const TrackStart& start,
                                           const std::vector<TimedReading>& readings,
                                           const TrackFilter& filter) {
  if (!system.motion.in_continuous_time())
    throw std::invalid_argument(
        "recorded readings come when they come, and a custom motion is of one update; "
        "use type: continuous");
  const StateLayout& layout = system.motion.layout;
  const int n = layout.size();
  const ReadingModel model(system, start.pose, n);
  TrackEstimate estimate;
  estimate.x = StateVector::Zero(n);
  estimate.R = start.pose.R;
  estimate.P = StateMatrix::Zero(n, n);
  for (int k = 0; k < n; ++k) {
    const double sigma = k < layout.coordinates() ? start.position : start.rate;
    estimate.P(k, k) = sigma * sigma;
  }
  std::vector<TrackedInstant> track;
  std::vector<TrackReading> together;
  for (std::size_t i = 0; i < readings.size();) {
    TrackedInstant at;
    at.t = readings[i].t;
    if (i > 0) at.gap = at.t - readings[i - 1].t;
    if (at.gap < 0) throw std::invalid_argument("readings aren't in order of time");
    if (i > 0) predict_state(layout, discretize(system.motion, at.gap), estimate);
    together.clear();
    for (; i < readings.size() && readings[i].t == at.t; ++i)
      together.push_back(readings[i].reading);
    at.innovation = filter.update(model, together, estimate);
    at.p = model.pose_of({0, n}, estimate.x, estimate.R).p;
    at.R = estimate.R;
    at.x = estimate.x;
    at.P = estimate.P;
    track.push_back(std::move(at));
  }
  return track;
}

}  // namespace delos
