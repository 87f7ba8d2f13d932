// The candidates of a selection, one by one.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "delos/api.h"
#include "delos/scene/scene.h"

namespace delos {

/// Something that can be chosen.
struct Candidate {
  std::string name;
  double cost = 1;
  int spot = -1;  ///< candidates of one spot exclude each other; −1: of none
  bool kept = false, left_out = false;
};

/// A scene in which all candidates stand, and what is whose.
struct CandidateScene {
  Scene scene;  ///< copies are devices here; without their patterns
  std::vector<Candidate> candidates;
  /// The candidate of each device and of each lit beacon of each set, in order; −1: it
  /// is there whatever is chosen.
  std::vector<int> of_device;
  std::vector<std::string> copy_of;  ///< of each device: its pattern; empty: none
  std::vector<std::vector<int>> of_beacon;
};

/// Write out the candidates of a scene.
///
/// Names: a device's own; of copies PATTERN-i, or PATTERN-i-j with several facings, i
/// counting spots and j facings from 0; of beacons SET-i, SET-row-i, SET-column-i and
/// SET-panel-i-j.
/// @returns a sentence where something is chosen twice, a name means nothing, or a
///          surface has no point somewhere
/// @pre the scene came from load_scene(), or passed its checks
[[nodiscard]] DELOS_API std::variant<CandidateScene, std::string> write_out_candidates(
    const Scene& scene);

/// The scene with what was chosen alone, and without a selection. Sets of beacons of
/// which some are chosen become lists. Variables, constraints and groups of numbers
/// that name a pattern are about its chosen copies then, as far as these have such
/// numbers.
/// @param chosen indices of candidates
[[nodiscard]] DELOS_API Scene chosen_scene(const CandidateScene& all,
                                           std::span<const std::size_t> chosen);

}  // namespace delos
