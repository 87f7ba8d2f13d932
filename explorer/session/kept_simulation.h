// Finished runs of a simulation in a file, to go on from.
#pragma once

#include <filesystem>
#include <string>

#include "session/simulation_answer.h"

namespace delos::session {

/// What runs depend on, as text: the program's scene, the place, the options without
/// the number of runs and of threads.
[[nodiscard]] std::string identity_of_runs(const LoadedScene& loaded,
                                           const SimulatedPlace& place,
                                           const SimulationOptions& options);

/// What a file of save_runs() has.
struct KeptRuns {
  std::string sums;     ///< empty where there is no such file
  std::string problem;  ///< why it can't be gone on from; empty: it can
};
[[nodiscard]] KeptRuns kept_runs(const std::filesystem::path& file,
                                 const std::string& identity);

/// Whole or not at all: a kill leaves what was there.
/// @returns empty, or why it was not written
[[nodiscard]] std::string save_runs(const std::filesystem::path& file,
                                    const std::string& identity,
                                    const std::string& sums);

}  // namespace delos::session
