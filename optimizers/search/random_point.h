// Points of the unit cube by a seed.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace delos {

/// Uniform numbers in [0, 1) that depend on the seed and the index alone. Not
/// std::uniform_real_distribution, whose numbers differ between libraries.
class UnitNumbers {
 public:
  UnitNumbers(std::uint64_t seed, int index) {
    std::seed_seq sequence{static_cast<std::uint32_t>(seed),
                           static_cast<std::uint32_t>(seed >> 32),
                           static_cast<std::uint32_t>(index)};
    random_.seed(sequence);
  }
  double operator()() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 random_;
};

}  // namespace delos
