// The fewest candidates of a scene that see every sample.
#pragma once

#include <vector>

#include "delos/optimize/cover.h"
#include "delos/optimize/select.h"

namespace delos {

/// What came of looking for a cover.
struct SceneCover {
  CandidateScene all;               ///< every candidate
  std::vector<std::size_t> chosen;  ///< indices of candidates, ascending
  double cost = 0;                  ///< of what was chosen
  double lower_bound = 0;           ///< no cover is cheaper
  std::size_t samples = 0;          ///< places and orientations to be seen
  CoverStop stop = CoverStop::budget;
  double seconds = 0;
};

/// Choose by `selection.cover`: every sample outside solids, in each orientation of the
/// scene, is seen at least so often; what is always there counts too.
/// Of adaptive samples, a fine grid of their box.
/// @param options its seconds, seed, threads and cancel are used; progress tells how
///        many candidates were asked what they see, then costs as values
/// @throws std::invalid_argument one sentence: the scene has no such selection
/// @throws std::invalid_argument one sentence: there is no cover, or none was found
///         before the time was over or somebody cancelled
/// @throws std::invalid_argument some sentences: samples that too few candidates see
[[nodiscard]] SceneCover cover_scene(const Scene& scene, PluginRegistry& plugins,
                                     const SelectOptions& options);

}  // namespace delos
