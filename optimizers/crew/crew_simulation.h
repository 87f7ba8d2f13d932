// The runs of a simulation, by all processes of a crew.
#pragma once

#include "crew/bytes.h"
#include "delos/optimize/crew.h"

namespace delos {

/// Take part in the simulation that rank 0 asks for by simulate_with_crew().
void serve_simulation(ByteReader& job, Crew& crew, PluginRegistry& plugins,
                      int threads);

}  // namespace delos
