// A search by all processes of a crew.
#pragma once

#include "crew/bytes.h"
#include "delos/optimize/optimize.h"

namespace delos {

/// As optimize(), by rank 0, while the others serve(). Gives the bytes that one process
/// gives.
/// @param options with a crew
/// @throws std::invalid_argument as optimize()
/// @throws std::runtime_error another process has other plugins, or fails
[[nodiscard]] OptimizeResult search_with_crew(const Scene& scene,
                                              PluginRegistry& plugins,
                                              const OptimizeOptions& options);

/// Take part in the search that rank 0 asks for.
void serve_search(ByteReader& job, Crew& crew, PluginRegistry& plugins, int threads);

}  // namespace delos
