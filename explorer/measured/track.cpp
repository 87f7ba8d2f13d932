#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "measured/comparison.h"
#include "measured/predicted.h"

namespace delos::measured {
namespace {

/// Sums of one device's differences.
struct Differences {
  std::vector<double> t, left;
  double variance = 0;
};

DeviceComparison summed(const PlacedDevice& placed, const Differences& of) {
  DeviceComparison all;
  all.name = placed.name;
  all.scene_rate = 1 / placed.period;
  all.readings = of.t.size();
  if (of.t.size() >= 2) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < of.t.size(); ++i)
      steps.push_back(of.t[i] - of.t[i - 1]);
    std::nth_element(steps.begin(),
                     steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                     steps.end());
    const double median = steps[steps.size() / 2];
    all.rate = median > 0 ? 1 / median : 0;
  }
  const auto n = static_cast<double>(of.left.size());
  if (of.left.size() < 2) {
    all.bias = all.scatter = all.predicted = all.correlation =
        std::numeric_limits<double>::quiet_NaN();
    return all;
  }
  for (const double e : of.left) all.bias += e / n;
  double squares = 0, neighbours = 0;
  for (std::size_t i = 0; i < of.left.size(); ++i) {
    const double e = of.left[i] - all.bias;
    squares += e * e;
    if (i > 0) neighbours += e * (of.left[i - 1] - all.bias);
  }
  all.scatter = std::sqrt(squares / (n - 1));
  all.predicted = std::sqrt(of.variance / n);
  all.correlation = squares > 0 ? neighbours / squares : 0;
  return all;
}

/// What is left of each reading at the truth.
void add_differences(const System& system, const TargetPose& about,
                     const Readings& readings, std::vector<Differences>& all) {
  const int n = system.motion.layout.size();
  PredictedReading predicted;
  for (std::size_t i = 0; i < readings.all.size(); ++i) {
    const TrackReading& reading = readings.all[i].reading;
    Differences& of = all[static_cast<std::size_t>(reading.device)];
    of.t.push_back(readings.all[i].t);
    if (readings.truth.empty() || !readings.truth[i].allFinite()) continue;
    const TargetPose pose{about.R, readings.truth[i]};
    const ReadingModel model(system, pose, n);
    if (!model.predict(reading, StateVector::Zero(n), pose.R, predicted)) continue;
    if (predicted.z.size() != reading.z.size()) continue;
    of.left.push_back(model.difference(reading.device, reading.z, predicted.z)(0));
    of.variance += predicted.R(0, 0);
  }
}

TrackComparison compared(const System& system, const std::vector<TrackedInstant>& track,
                         const std::vector<Eigen::Vector3d>& truth,
                         const Eigen::Vector3d& rpy) {
  const int d = system.motion.layout.positions();
  const auto n = static_cast<double>(track.size());
  TrackComparison all;
  all.bias = all.filter = Eigen::Vector3d::Zero();
  Eigen::Vector3d squares = Eigen::Vector3d::Zero(), sigma = squares;
  for (std::size_t i = 0; i < track.size(); ++i) {
    const Eigen::Vector3d e = track[i].p - truth[i];
    all.bias += e / n;
    squares += e.cwiseAbs2();
    all.filter.head(d) += track[i].P.diagonal().head(d) / n;
    const StateMatrix P = track[i].P.topLeftCorner(d, d);
    const StateVector off = e.head(d);
    all.nees += off.dot(P.ldlt().solve(off)) / n;
  }
  for (const Eigen::Vector3d& s : predicted_at(system, truth, rpy))
    sigma += s.cwiseAbs2() / n;
  all.scatter = (squares / n - all.bias.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
  all.predicted = sigma.cwiseSqrt();
  all.filter = all.filter.cwiseSqrt().eval();
  all.nees_expected = d;
  return all;
}

}  // namespace

std::variant<ReadingsComparison, std::string> compare_readings(
    const System& system, const Eigen::Vector3d& at, const Eigen::Vector3d& rpy,
    const Readings& readings, const TrackFilter& filter, double skip, bool debias) {
  const TargetPose about{rotation_from_rpy(rpy), at};
  std::vector<Differences> differences(system.devices.size());
  add_differences(system, about, readings, differences);
  ReadingsComparison all;
  for (std::size_t d = 0; d < differences.size(); ++d)
    all.devices.push_back(summed(system.devices[d], differences[d]));

  std::vector<TimedReading> taken = readings.all;
  for (TimedReading& timed : taken) {
    const DeviceComparison& of =
        all.devices[static_cast<std::size_t>(timed.reading.device)];
    if (debias && std::isfinite(of.bias)) timed.reading.z(0) -= of.bias;
  }
  // As wide as all that is known: the readings pull it in.
  TrackStart start{about, 10, 10};
  const bool known = !readings.truth.empty() && readings.truth.front().allFinite();
  if (known) start = {{about.R, readings.truth.front()}, 1, 1};
  const std::vector<TrackedInstant> track =
      track_readings(system, start, taken, filter);
  all.instants = track.size();

  std::vector<TrackedInstant> settled;
  std::vector<Eigen::Vector3d> truth;
  std::size_t next = 0;
  double rows = 0;
  for (const TrackedInstant& now : track) {
    // The truth of the last of its readings.
    while (next + 1 < taken.size() && taken[next + 1].t <= now.t) ++next;
    all.longest_gap = std::max(all.longest_gap, now.gap);
    all.dropped += static_cast<std::size_t>(now.innovation.dropped);
    if (now.t - track.front().t < skip) continue;
    all.nis += now.innovation.nis;
    rows += now.innovation.rows;
    if (readings.truth.empty() || !readings.truth[next].allFinite()) continue;
    settled.push_back(now);
    truth.push_back(readings.truth[next]);
  }
  all.with_truth = settled.size();
  if (rows == 0) return std::string("no reading is left after the seconds to skip");
  all.nis /= rows;
  if (settled.size() >= 2 && system.motion.layout.positions() > 0)
    all.track = compared(system, settled, truth, rpy);
  return all;
}

}  // namespace delos::measured
