#include "delos/rig/schedule.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace delos {
namespace {

struct Fraction {
  std::int64_t numerator, denominator;
};

/// The fraction nearest to x by continued fractions, within 1e-9 relative.
std::optional<Fraction> as_fraction(double x) {
  std::int64_t p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  double rest = x;
  for (int i = 0; i < 24; ++i) {
    const double whole = std::floor(rest);
    if (whole > 1e6) return std::nullopt;
    const auto a = static_cast<std::int64_t>(whole);
    const std::int64_t p = a * p1 + p0, q = a * q1 + q0;
    p0 = p1, q0 = q1, p1 = p, q1 = q;
    if (q > 1'000'000) return std::nullopt;
    const double value = static_cast<double>(p) / static_cast<double>(q);
    if (std::abs(value - x) <= 1e-9 * x) return Fraction{p, q};
    rest = 1 / (rest - whole);
  }
  return std::nullopt;
}

/// Least common multiple; nullopt above a bound that no short cycle reaches.
std::optional<std::int64_t> short_lcm(std::int64_t a, std::int64_t b) {
  constexpr std::int64_t kBound = std::int64_t{1} << 52;
  const std::int64_t factor = b / std::gcd(a, b);
  if (a > kBound / factor) return std::nullopt;
  return a * factor;
}

std::string too_long() {
  std::string text = "fusion: the devices' rates repeat only after more than ";
  text += std::to_string(kMaxCycle);
  return text += " updates; use rates in simple ratios, or fusion: continuous";
}

std::variant<std::vector<UpdateSlot>, std::string> periodic(const System& system) {
  // Count time in ticks: the first device's period over the common denominator.
  const double unit = system.devices.front().period;
  std::int64_t ticks_per_unit = 1;
  std::vector<Fraction> ratio;
  for (const PlacedDevice& d : system.devices) {
    const std::optional<Fraction> f = as_fraction(d.period / unit);
    if (!f) return too_long();
    ratio.push_back(*f);
    const auto ticks = short_lcm(ticks_per_unit, f->denominator);
    if (!ticks || *ticks > 1'000'000'000) return too_long();
    ticks_per_unit = *ticks;
  }
  std::vector<std::int64_t> period;
  std::int64_t cycle = 1;
  for (const Fraction& f : ratio) {
    period.push_back(f.numerator * (ticks_per_unit / f.denominator));
    const auto common = short_lcm(cycle, period.back());
    if (!common) return too_long();
    cycle = *common;
    if (cycle / *std::min_element(period.begin(), period.end()) > kMaxCycle) {
      return too_long();
    }
  }
  const double tick = unit / static_cast<double>(ticks_per_unit);
  const double length = tick * static_cast<double>(cycle);

  // Instants closer than a billionth of the cycle are one: phases are real numbers.
  std::vector<std::pair<double, int>> events;
  for (std::size_t i = 0; i < period.size(); ++i) {
    const std::int64_t count = cycle / period[i];
    if (static_cast<std::int64_t>(events.size()) + count > 64 * kMaxCycle) {
      return too_long();
    }
    for (std::int64_t j = 0; j < count; ++j) {
      double t = tick * static_cast<double>(j * period[i]) + system.devices[i].phase;
      t -= length * std::floor(t / length);
      if (length - t <= 1e-9 * length) t = 0;
      events.emplace_back(t, static_cast<int>(i));
    }
  }
  std::sort(events.begin(), events.end());
  std::vector<UpdateSlot> slots;
  std::vector<double> instants;
  for (const auto& [t, device] : events) {
    if (slots.empty() || t - instants.back() > 1e-9 * length) {
      slots.emplace_back();
      instants.push_back(t);
    }
    slots.back().devices.push_back(device);
  }
  if (slots.size() > static_cast<std::size_t>(kMaxCycle)) return too_long();
  for (std::size_t s = 0; s < slots.size(); ++s) {
    std::sort(slots[s].devices.begin(), slots[s].devices.end());
    slots[s].interval =
        s > 0 ? instants[s] - instants[s - 1] : instants[0] + length - instants.back();
  }
  return slots;
}

}  // namespace

std::variant<std::vector<UpdateSlot>, std::string> update_cycle(const System& system) {
  if (system.fusion != Fusion::sequential) return periodic(system);
  if (system.devices.size() > static_cast<std::size_t>(kMaxCycle)) return too_long();
  std::vector<UpdateSlot> slots;
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    slots.push_back({system.devices[i].period, {static_cast<int>(i)}});
  }
  return slots;
}

}  // namespace delos
