// Fronts of the best designs, as the contract's documents (`tradeoff --json`).
#pragma once

#include <string>
#include <vector>

#include "delos/optimize/tradeoff.h"
#include "session/json.h"

namespace delos::session {

/// The SI unit of a constraint's limit. @pre there is one of the name
[[nodiscard]] std::string limit_unit(const Scene& scene, const std::string& constraint);

/// The objective against a constraint's limit. @pre one point or more
[[nodiscard]] Json front_json(const Scene& scene, const std::string& constraint,
                              const std::vector<FrontPoint>& points,
                              PluginRegistry& plugins);

/// The objective against the number of devices, and the cheapest that keeps all.
[[nodiscard]] Json counts_json(const Scene& scene,
                               const std::vector<DeviceCountPoint>& points,
                               PluginRegistry& plugins);

}  // namespace delos::session
