// All that can be said of one point.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delos/field/point.h"
#include "delos/observe/beacon_use.h"
#include "session/json.h"
#include "session/loaded_scene.h"
#include "session/one_more_device.h"

namespace delos::session {

struct PointAnswer {
  PointReport report;
  Eigen::Vector3d rpy;             ///< the target's orientation, radians
  std::optional<Mending> mending;  ///< where directions are lost
  std::vector<SeenBeacon> sightings;
};

/// Evaluate a target at a place in the world.
/// @param at metres; @param rpy radians
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] PointAnswer answer_point(const LoadedScene& loaded,
                                       const Eigen::Vector3d& at,
                                       const Eigen::Vector3d& rpy, Solver solver);

/// A covariance with infinite rows and columns of states that reach into a lost
/// direction, which have no finite one.
/// @param unobservable n×m, a column a direction
[[nodiscard]] StateMatrix with_infinities(StateMatrix P,
                                          const StateMatrix& unobservable);

/// What is lost there, why, and what would mend it: a line each.
[[nodiscard]] std::vector<std::string> lost_words(const PointAnswer& answer,
                                                  const LoadedScene& loaded);

/// The contract's document (`point --json`).
[[nodiscard]] Json point_json(const PointAnswer& answer, const LoadedScene& loaded);

}  // namespace delos::session
