// Random numbers of one run: the same on any thread and with any library.
#pragma once

#include <cmath>
#include <cstdint>

namespace delos {

/// What a run draws; each has a sequence of its own, so that all filters meet the same
/// targets and the same noise.
enum class Draw : std::uint64_t { motion, start, readings, beacons, errors };

/// SplitMix64 from a start that seed, run and purpose are mixed into. Source: Steele,
/// Lea, Flood (2014), OOPSLA '14, doi:10.1145/2660193.2660195.
class RunRandom {
 public:
  RunRandom(std::uint64_t seed, std::uint64_t run, Draw purpose)
      : state_(mix(mix(mix(seed) + run) + static_cast<std::uint64_t>(purpose))) {}

  /// In [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// N(0, 1), by Marsaglia's polar method.
  double normal() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    double u = 0, v = 0, s = 0;
    do {
      u = 2 * uniform() - 1;
      v = 2 * uniform() - 1;
      s = u * u + v * v;
    } while (s >= 1 || s == 0);
    const double scale = std::sqrt(-2 * std::log(s) / s);
    spare_ = v * scale;
    has_spare_ = true;
    return u * scale;
  }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t next() { return mix(state_ += 0x9e3779b97f4a7c15u); }

  std::uint64_t state_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace delos
