#include "steady/windows.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace delos {

ExposureWindows::ExposureWindows(const System& system,
                                 std::span<const UpdateSlot> slots)
    : system_(system), parts_(slots.size()), states_(system.motion.layout.size()) {
  for (const UpdateSlot& slot : slots) intervals_.push_back(slot.interval);
  for (std::size_t s = 0; s < slots.size(); ++s)
    for (const int device : slots[s].devices)
      add(s, system.devices[static_cast<std::size_t>(device)].exposure);
}

/// The slots that a window covers, back from its update.
std::vector<ExposureWindows::Part> ExposureWindows::parts_of(std::size_t slot,
                                                             double exposure) const {
  const std::size_t count = intervals_.size();
  std::vector<Part> parts;
  double left = exposure;
  for (std::size_t back = 0; back < count && left > 0; ++back) {
    const double interval = intervals_[(slot + count - back) % count];
    const double open = std::min(left, interval);
    left -= open;
    // Intervals are rounded, and no window is longer than the cycle.
    if (left <= 1e-9 * exposure || back + 1 == count) left = 0;
    parts.push_back({slot, 0, exposure, open, left > 0});
  }
  return parts;
}

void ExposureWindows::add(std::size_t slot, double exposure) {
  if (exposure == 0 || find(slot, exposure)) return;
  std::vector<Part> parts = parts_of(slot, exposure);
  const auto at = [&](std::size_t back) -> std::vector<Part>& {
    return parts_[(slot + parts_.size() - back) % parts_.size()];
  };
  const auto is_free = [&](int channel) {
    for (std::size_t back = 0; back < parts.size(); ++back)
      for (const Part& other : at(back))
        if (other.channel == channel) return false;
    return true;
  };
  int channel = 0;
  while (!is_free(channel)) ++channel;
  const StateLayout& layout = system_.motion.layout;
  states_ = std::max(states_, layout.size() + layout.coordinates() * (channel + 1));
  if (states_ > kMaxState)
    throw std::invalid_argument(
        "so many readings of different exposures are under way at once that their "
        "means take a state of " +
        std::to_string(states_) + " numbers; at most " + std::to_string(kMaxState) +
        " can be solved for; let more devices expose together, and equally long");
  for (std::size_t back = 0; back < parts.size(); ++back) {
    parts[back].channel = channel;
    at(back).push_back(parts[back]);
  }
}

const ExposureWindows::Part* ExposureWindows::find(std::size_t slot,
                                                   double exposure) const {
  for (const Part& part : parts_[slot])
    if (part.end == slot && part.exposure == exposure) return &part;
  return nullptr;
}

StateBlock ExposureWindows::block(std::size_t slot, int device) const {
  const StateLayout& layout = system_.motion.layout;
  const double exposure = system_.devices[static_cast<std::size_t>(device)].exposure;
  if (exposure == 0) return {0, information_size(system_)};
  const int d = layout.coordinates();
  return {layout.size() + d * find(slot, exposure)->channel, d};
}

MotionStep ExposureWindows::motion_within(double delta,
                                          std::span<const Part> open) const {
  const Eigen::Index n = system_.motion.layout.size(), N = states_;
  const Eigen::Index d = system_.motion.layout.coordinates();
  MotionModel with_integral = system_.motion;
  ++with_integral.layout.order;
  const MotionStep chain = discretize(with_integral, delta);  // of [I, x]
  StateMatrix E = StateMatrix::Zero(N, d + n);
  E.block(0, d, n, n).setIdentity();
  for (const Part& part : open)
    E.block(n + d * part.channel, 0, d, d).diagonal().setConstant(1 / part.exposure);
  MotionStep step{StateMatrix::Identity(N, N), E * chain.Q * E.transpose()};
  step.Q = (step.Q + step.Q.transpose()).eval() / 2;
  step.A.leftCols(n) = E * chain.A.rightCols(n);
  return step;
}

MotionStep ExposureWindows::approximate_motion(std::size_t slot) const {
  const Eigen::Index n = system_.motion.layout.size(), N = states_;
  const Eigen::Index d = system_.motion.layout.coordinates();
  const MotionStep chain = discretize(system_.motion, intervals_[slot]);
  StateMatrix E = StateMatrix::Zero(N, n);
  E.topRows(n).setIdentity();
  for (const Part& part : parts_[slot])
    if (part.end == slot) E.block(n + d * part.channel, 0, d, d).setIdentity();
  MotionStep step{StateMatrix::Zero(N, N), E * chain.Q * E.transpose()};
  step.A.leftCols(n) = E * chain.A;
  const CoordinateMatrix& q = std::get<ChainMotion>(system_.motion.dynamics).q;
  for (const Part& part : parts_[slot])
    if (part.end == slot)
      step.Q.block(n + d * part.channel, n + d * part.channel, d, d) +=
          q * motion_variance(system_.exposures, system_.motion.layout.order,
                              part.exposure);
  return step;
}

MotionStep ExposureWindows::motion(std::size_t slot) const {
  const double interval = intervals_[slot];
  const Eigen::Index n = system_.motion.layout.size(), N = states_;
  if (N == n) return discretize(system_.motion, interval);
  if (system_.exposures != ExposureModel::exact) return approximate_motion(slot);
  const Eigen::Index d = system_.motion.layout.coordinates();

  // What has begun goes on; the other channels are empty.
  const std::vector<Part>& parts = parts_[slot];
  StateMatrix keep = StateMatrix::Zero(N, N);
  keep.topLeftCorner(n, n).setIdentity();
  std::vector<double> ends = {0};  // seconds before the slot at which a piece ends
  for (const Part& part : parts) {
    if (part.begun) keep.diagonal().segment(n + d * part.channel, d).setOnes();
    if (part.open < interval) ends.push_back(part.open);
  }
  std::sort(ends.begin(), ends.end(), std::greater());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());

  MotionStep all{keep, StateMatrix::Zero(N, N)};
  double left = interval;
  for (const double end : ends) {
    std::vector<Part> open;
    for (const Part& part : parts)
      if (part.open > end) open.push_back(part);
    const MotionStep piece = motion_within(left - end, open);
    all.A = (piece.A * all.A).eval();
    all.Q = (piece.A * all.Q * piece.A.transpose()).eval() + piece.Q;
    left = end;
  }
  return all;
}

}  // namespace delos
