// What simulated filters reach at places of a scene, beside what is predicted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delos/field/field.h"
#include "delos/optimize/crew.h"
#include "delos/scene/path_file.h"
#include "delos/simulation/simulate.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// A place to simulate at.
struct SimulatedPlace {
  std::string name;  ///< "best", "median", "worst"; empty: asked for
  TargetPose pose;
  Eigen::Vector3d rpy;  ///< its orientation, radians
};

/// The best, median and worst place of a field where every direction is observed.
[[nodiscard]] std::vector<SimulatedPlace> typical_places(const Field& field,
                                                         const Eigen::Vector3d& rpy);

/// What came of a place; no simulation where `problem` says why.
struct SimulationAnswer {
  SimulatedPlace place;
  std::optional<Simulation> simulation;
  std::string problem;
};

/// Simulate a scene at a place, or along a path that begins there.
/// @param crew processes that share the runs, of which this is rank 0; or null
/// @throws DeviceFault
/// @throws std::runtime_error another process fails
[[nodiscard]] SimulationAnswer answer_simulation(const LoadedScene& loaded,
                                                 const SimulatedPlace& place,
                                                 const SimulationOptions& options,
                                                 PluginRegistry& plugins,
                                                 Crew* crew = nullptr);

/// Rows of a path as the kernel has them.
[[nodiscard]] GivenPath given_path(const std::vector<PathRow>& rows);

/// σ of each state from a covariance, and what the measured ones are known to.
[[nodiscard]] StateVector deviations(const StateMatrix& P);
[[nodiscard]] StateVector deviation_errors(const SimulatedCovariance& c);

/// Roots of the means over a given path: of P∞ where the target was, of the squares of
/// errors, of the filter's own variances.
struct AlongPath {
  StateVector predicted, measured, filter;
  std::size_t blind = 0;  ///< instants without a finite P∞, which are left out
};
/// @returns nothing where no path was given, or P∞ is finite nowhere on it
[[nodiscard]] std::optional<AlongPath> along_path(const Simulation& simulation);

/// The contract's document (`simulate --json`).
[[nodiscard]] Json simulation_json(const std::vector<SimulationAnswer>& answers,
                                   const LoadedScene& loaded,
                                   const SimulationOptions& options);

/// Instants as rows: t, where, and of each state the mean error, the measured, the
/// filter's, the bound's and P∞'s σ; NEES and NIS.
[[nodiscard]] std::string instants_csv(const Simulation& simulation,
                                       const LoadedScene& loaded);

}  // namespace delos::session
