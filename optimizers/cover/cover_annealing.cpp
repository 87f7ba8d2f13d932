#include "cover/cover_annealing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace delos {
namespace {

/// Temperatures between which a fall goes, in sightings: chosen by trying ones from 0.3
/// to 2 on a room of 64 cameras. Above, little order comes about; below, little
/// changes.
constexpr double kHot = 0.7, kCold = 0.45;
/// One of so many steps draws from all samples, since exchanges that only hand a missed
/// sample on can go on without end.
constexpr int kElsewhere = 10;
/// List entries that the first fall reads.
constexpr std::int64_t kFirstFall = 500'000'000;

}  // namespace

CoverAnnealing::CoverAnnealing(const CoverCore& core, CoverSelection begin,
                               std::uint64_t seed)
    : core_(core),
      selection_(std::move(begin)),
      random_(seed),
      fall_work_(kFirstFall) {}

bool CoverAnnealing::suits(const CoverCore& core) {
  return std::all_of(core.cost.begin(), core.cost.end(),
                     [&](double cost) { return cost == core.cost.front(); });
}

/// A number from 0 to count − 1.
int CoverAnnealing::draw(std::size_t count) {
  return static_cast<int>((random_() >> 32) * count >> 32);
}

double CoverAnnealing::temperature() {
  const std::int64_t done = looked_ + selection_.work() - fall_begin_;
  if (done >= fall_work_) {
    fall_begin_ += done;
    fall_work_ *= 2;
    return kHot;
  }
  const double way = static_cast<double>(done) / static_cast<double>(fall_work_);
  return kHot * std::pow(kCold / kHot, way);
}

void CoverAnnealing::step(double temperature) {
  ++moves_;
  const auto& missed = selection_.missed();
  const int sample =
      draw(kElsewhere) == 0 ? draw(core_.samples()) : missed[draw(missed.size())];
  const auto seers = core_.seers[sample];
  const int j = seers[draw(seers.size())];
  ++looked_;
  if (selection_.has(j)) return;
  if (changed_) selection_.open_losses(std::numeric_limits<std::int64_t>::max());
  changed_ = false;
  // ΔE ≤ −T log u, with u uniform in (0, 1]: as likely as exp(−ΔE/T).
  const double u = 0x1p-53 * (static_cast<double>(random_() >> 11) + 1);
  const double worth = temperature * std::log(u) / core_.cost[j];
  if (selection_.gain(j) < worth) return;
  const auto exchange = selection_.exchange_for(j, worth);
  if (exchange.out < 0 || exchange.value < worth) return;
  // Among equal losses, chance decides who goes.
  selection_.take(exchange.out, 0);
  selection_.put(j, draw(1u << 31));
  changed_ = true;
}

void CoverAnnealing::run(std::int64_t work, double limit, double enough) {
  const std::int64_t end = looked_ + selection_.work() + work;
  constexpr int kStepsATemperature = 1000;
  while (looked_ + selection_.work() < end && selection_.best_cost() > enough) {
    limit = std::min(limit, selection_.best_cost());
    while (!selection_.selected().empty() && !(selection_.cost() < limit)) {
      selection_.take(selection_.least_loss(), 0);
      changed_ = true;
    }
    if (selection_.selected().empty()) return;
    const double now = temperature();
    for (int i = 0; i < kStepsATemperature && !selection_.missed().empty(); ++i)
      step(now);
    if (!selection_.missed().empty()) continue;
    selection_.note_cover();
    changed_ = true;
  }
}

}  // namespace delos
