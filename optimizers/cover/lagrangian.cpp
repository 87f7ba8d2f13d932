#include "cover/lagrangian.h"

#include <algorithm>
#include <cmath>

#include "delos/model/infinity.h"

namespace delos {
namespace {

/// λ at first, and where it ends; steps without a better bound after which it halves;
/// how much of the last direction is kept. Chosen on the instances of bench_cover.
constexpr double kLongest = 0.5, kShortest = 1e-3, kMomentum = 0.95;
constexpr int kPatience = 200;
/// In large ones patience ends with this many list entries, but not before so many
/// steps: their time is over before λ has fallen otherwise.
constexpr std::int64_t kPatientWork = 400'000'000;
constexpr int kLeastPatience = 5;
/// The least relative gain for which u is let grow on.
constexpr double kWorthFilling = 1e-3;

}  // namespace

Lagrangian::Lagrangian(const CoverCore& core, std::vector<double> start)
    : core_(core),
      u_(std::move(start)),
      r_(core.candidates()),
      slope_(core.samples()),
      direction_(core.samples(), 0),
      length_(kLongest),
      patience_(static_cast<int>(std::clamp<std::int64_t>(
          kPatientWork / (static_cast<std::int64_t>(core.seen.items.size()) + 1),
          kLeastPatience, kPatience))) {
  int groups = 0;
  for (const int g : core.group) groups = std::max(groups, g + 1);
  least_.assign(groups, -1);
  if (!u_.empty()) return;
  filling_ = true;
  u_.assign(core.samples(), kInfinity);
  for (int j = 0; j < core.candidates(); ++j)
    for (const int i : core.seen[j])
      u_[i] = std::min(u_[i], core.cost[j] / static_cast<double>(core.seen[j].size()));
}

/// L(u), its slope d − Σ x_j over the least r_j, and r.
double Lagrangian::evaluate() {
  r_ = core_.cost;
  double value = 0;
  for (int i = 0; i < core_.samples(); ++i) {
    slope_[i] = core_.demand[i];
    if (u_[i] == 0) continue;
    value += core_.demand[i] * u_[i];
    for (const int j : core_.seers[i]) r_[j] -= u_[i];
  }
  const auto take = [&](int j) {
    value += r_[j];
    for (const int i : core_.seen[j]) slope_[i] -= 1;
  };
  std::fill(least_.begin(), least_.end(), -1);
  for (int j = 0; j < core_.candidates(); ++j) {
    if (r_[j] >= 0) continue;
    const int g = core_.group[j];
    if (g < 0)
      take(j);
    else if (least_[g] < 0 || r_[j] < r_[least_[g]])
      least_[g] = j;
  }
  for (const int j : least_)
    if (j >= 0) take(j);
  return value;
}

/// Shorter steps where they lead no higher.
void Lagrangian::adapt(double value) {
  if (value > bound_ + 1e-4 * std::abs(bound_)) idle_ = 0;
  if (++idle_ < patience_) return;
  idle_ = 0;
  length_ /= 2;
  settled_ = length_ < kShortest;
  u_ = best_u_;
  std::fill(direction_.begin(), direction_.end(), 0.0);
}

/// Where r ≥ 0 at u, so it is at
///
///   u_i min_{j ∋ i} c_j/Σ_{k ∈ S(j)} u_k ≥ u_i
///
/// since of no candidate the sum grows by more than the factor that it allows.
void Lagrangian::fill_up() {
  for (int i = 0; i < core_.samples(); ++i) {
    double room = kInfinity;
    for (const int j : core_.seers[i])
      room = std::min(room, core_.cost[j] / (core_.cost[j] - best_r_[j]));
    u_[i] = best_u_[i] * std::max(1.0, room);
  }
}

void Lagrangian::step(double target) {
  const double value = evaluate();
  if (filling_) {
    filling_ = value > bound_ + kWorthFilling * std::abs(value);
    bound_ = value;
    best_u_ = u_;
    best_r_ = r_;
    fill_up();
    return;
  }
  adapt(value);
  if (value > bound_) {
    bound_ = value;
    best_u_ = u_;
    best_r_ = r_;
  }
  double norm = 0;
  for (int i = 0; i < core_.samples(); ++i) {
    // What would leave u ≥ 0 leads nowhere.
    if (u_[i] == 0 && slope_[i] < 0) slope_[i] = 0;
    direction_[i] = slope_[i] + kMomentum * direction_[i];
    norm += direction_[i] * direction_[i];
  }
  if (norm == 0) {
    settled_ = true;
    return;
  }
  const double gap = std::isfinite(target) ? target - value : std::abs(value);
  const double step = length_ * std::max(gap, 1e-3 * std::abs(value)) / norm;
  for (int i = 0; i < core_.samples(); ++i)
    u_[i] = std::max(0.0, u_[i] + step * direction_[i]);
}

}  // namespace delos
