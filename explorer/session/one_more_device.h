// Which device more would observe what is lost at a point.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delos/field/point.h"

namespace delos::session {

/// A copy of a device that is there, in another place.
struct OneMoreDevice {
  std::string like;    ///< what it is a copy of: type, parameters, rate, noise …
  std::string type;    ///< of that device
  Eigen::Vector3d at;  ///< metres; its z axis looks at the point
  double value = 0;    ///< the metric with it, finite: every direction is observed
};

/// What was tried, and the best of what would do.
struct Mending {
  std::vector<std::string> types;  ///< of the copies, each once
  double distance = 0;             ///< half the width of the box of places, metres
  std::optional<OneMoreDevice> best;
};

/// Evaluate the point anew with one device more: a copy of each kind that stands in the
/// world and observes points or poses, at the corners and the middles of the edges and
/// faces of a box around the point, as far away as the middle one of the devices is.
/// @param rpy the orientation of the report's pose, radians
/// @param metric which of several copies is best
/// @returns nothing where every direction is observed, or where no such device is there
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] std::optional<Mending> mend_by_one_device(const System& system,
                                                        const PointReport& report,
                                                        const Eigen::Vector3d& rpy,
                                                        const Metric& metric,
                                                        Solver solver);

/// "one more uwb_range like a at (2, 1, 2.2) m would mend it: eigmax 61 mm", or that
/// none of those tried would.
[[nodiscard]] std::string words_of(const Mending& mending, const Metric& metric);

}  // namespace delos::session
