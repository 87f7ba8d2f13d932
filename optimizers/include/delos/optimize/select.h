// Certified choices: k of N candidates, and how far from the best possible they are.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "delos/plugin/registry.h"
#include "delos/scene/candidates.h"

namespace delos {

/// How far a selection is; values as SelectResult has them.
struct SelectProgress {
  double value = 0;  ///< of the best choice so far; +∞: none yet
  double lower_bound = 0;
  std::size_t nodes = 0;
  double ready = 1;  ///< of what must be known before the search: the part that is
};

/// How to select.
struct SelectOptions {
  double gap = 0.01;    ///< satisfied with a value so close to its bound, relative
  double seconds = 60;  ///< stop after about so long
  std::size_t samples = 1500;  ///< looked at, and certified over; 0: all
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: one a core
  /// A file that keeps the search, made where there is none; it goes on from there.
  std::filesystem::path study;
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(const SelectProgress&)> progress;
};

/// How a selection ended.
enum class SelectStop {
  proven,     ///< the gap that was asked for, or better
  time,       ///< the time is over; the gap is what it is
  cancelled,  ///< asked to stop; likewise
};
[[nodiscard]] const char* to_string(SelectStop stop);

/// What came of a selection.
struct SelectResult {
  CandidateScene all;               ///< every candidate
  std::vector<std::size_t> chosen;  ///< indices of candidates, ascending
  /// What is certified, for people: "root of the mean of eigmax² over 343 samples".
  std::string quantity;
  std::string unit;  ///< of the next two, SI; empty: mixed
  double value = 0;  ///< of what was chosen
  /// No choice that the rules allow has less. Where `blind` is `always_blind`, that is:
  /// none that leaves nothing else blind.
  double lower_bound = 0;
  double gap = 0;           ///< value/lower_bound − 1
  double variance_gap = 0;  ///< the same of the squares, which are what is convex
  double guess = 0;  ///< metres and radians, of the pose: it judges blind samples
  std::size_t samples = 0;
  std::size_t blind = 0;          ///< of them, that the choice leaves blind
  std::size_t always_blind = 0;   ///< of them, that are blind whatever is chosen
  std::vector<double> fractions;  ///< of the relaxation, one a candidate
  /// One flag a candidate: it is in every choice that is at least as good, or in none.
  std::vector<char> in_every, in_none;
  std::size_t nodes = 0;
  SelectStop stop = SelectStop::proven;
  double seconds = 0;
};

/// Choose by `selection.count` or `.budget`.
/// @throws std::invalid_argument one sentence: the scene has no selection by count or
///         budget
/// @throws std::invalid_argument one sentence: its objective has no convex variance
/// @throws std::invalid_argument one sentence: nothing fits
/// @throws std::invalid_argument one sentence: a sample isn't observable whatever is
///         chosen, not even with the guess
/// @throws std::invalid_argument one sentence: a field of the choice says something
///         else
/// @throws std::invalid_argument one sentence: a steady state didn't settle
/// @throws std::invalid_argument as candidate_information()
/// @throws std::runtime_error the study can't be written, is about something else, or
///         is damaged
[[nodiscard]] SelectResult select(const Scene& scene, PluginRegistry& plugins,
                                  const SelectOptions& options);

}  // namespace delos
