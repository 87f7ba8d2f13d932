// A study as a document, and designs as its acts write them.
#pragma once

#include <filesystem>
#include <string>

#include "delos/optimize/study.h"
#include "session/json.h"

namespace delos::session {

/// `study --json`: {scene, algorithm, seed, locked, rounds, acts, waiting_acts}
[[nodiscard]] Json study_json(const StudySummary& summary);

/// The design of a scene file, as the act `inject` writes it.
/// @throws std::invalid_argument it can't be read, or lacks a variable of the study
[[nodiscard]] std::string design_of(const std::filesystem::path& file,
                                    const Study& study, PluginRegistry& plugins);

}  // namespace delos::session
