// Local search for a cover with fewer candidates, by annealing.
#pragma once

#include <cstdint>
#include <random>

#include "cover/cover_selection.h"

namespace delos {

/// Simulated annealing of selections that have one candidate less than the best cover:
/// the energy is the number of sightings that samples lack, the step an exchange.
///
/// A step draws a sample from the missed ones and a candidate j from those that see it,
/// and takes the exchange for j that costs least with probability min(1, exp(−ΔE/T)).
/// The temperature falls geometrically; each time the next fall takes twice as long.
/// Source: Kirkpatrick, Gelatt, Vecchi (1983), Science 220, 671–680. For candidates of
/// equal cost: one is exchanged for one.
class CoverAnnealing {
 public:
  /// @param begin what it begins with, of this core
  CoverAnnealing(const CoverCore& core, CoverSelection begin, std::uint64_t seed);

  /// @returns whether all candidates cost the same
  [[nodiscard]] static bool suits(const CoverCore& core);

  /// Search on until about `work` list entries were read, or a cover costs `enough`.
  /// @param limit only covers that cost less are looked for
  void run(std::int64_t work, double limit, double enough);

  [[nodiscard]] const CoverSelection& selection() const { return selection_; }
  [[nodiscard]] std::int64_t moves() const { return moves_; }

 private:
  [[nodiscard]] double temperature();
  void step(double temperature);
  [[nodiscard]] int draw(std::size_t count);

  const CoverCore& core_;
  CoverSelection selection_;
  std::mt19937_64 random_;
  bool changed_ = true;                      ///< since losses were noted
  std::int64_t fall_begin_ = 0, fall_work_;  ///< list entries before and of this fall
  std::int64_t moves_ = 0, looked_ = 0;
};

}  // namespace delos
