// What `delos tradeoff --json` found, and what layouts agree on, in a report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "delos/optimize/layout.h"
#include "report/html.h"

namespace delos::report {

/// A chart and a table of one document.
/// @throws std::invalid_argument one sentence: it isn't such a document
[[nodiscard]] Html tradeoff_section(const nlohmann::ordered_json& document);

/// The best layouts of a study, and which devices are settled.
/// @param values what each layout is worth, as it is shown
[[nodiscard]] Html consensus_section(const Consensus& found, std::size_t starts,
                                     const std::vector<std::string>& values);

}  // namespace delos::report
