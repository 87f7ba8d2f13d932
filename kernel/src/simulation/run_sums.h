// The sums over many runs: of threads, of processes, and of an earlier time.
#pragma once

#include "delos/simulation/simulate.h"
#include "simulation/tally.h"
#include "simulation/track_run.h"

namespace delos {

/// Add the tallies of all runs, in the order of their numbers: the same bytes for any
/// threads and parts, and for runs that go on from what was saved.
/// @param empty a tally of no runs
/// @param[in,out] sums of none
/// @throws std::invalid_argument what was saved isn't of such runs, or of more of them
/// @throws std::runtime_error another part has failed
/// @throws DeviceFault
void add_runs(const TrackRuns& runs, const Tally& empty,
              const SimulationOptions& options, Tally& sums);

}  // namespace delos
