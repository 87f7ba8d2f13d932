// Parts of a track, each with a motion of its own: still, walking, reaching.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "motion/motion_fit.h"

namespace delos::motion {

/// A part of a track.
struct Segment {
  double from = 0, to = 0;  ///< seconds after the first frame
  MotionFit fit;
};

/// Cut a track where that pays: a cut at the place that makes the description shortest,
/// then the parts likewise, and at last those joined again that are better as one. The
/// length of a description is BIC: −2 log L, log n for each number that is fitted, and
/// log n for the place of each cut.
///
/// Source: binary segmentation, A. J. Scott, M. Knott, Biometrics 30(3), 507–512, 1974;
/// BIC for changes, Y.-C. Yao, Statistics and Probability Letters 6(3), 181–189, 1988.
/// @returns one part or more, in order; or why none can be fitted
/// @cost some 30 fits a cut
[[nodiscard]] std::variant<std::vector<Segment>, std::string> fit_segments(
    const recordings::Track& track, double period, const FitQuestion& question);

/// A block for a scene, YAML: `motions`, a name a part.
[[nodiscard]] std::string motions_block(const std::vector<Segment>& segments,
                                        const std::string& source);

}  // namespace delos::motion
