// Searches in sentences, and as commands.
#pragma once

#include <string>
#include <vector>

#include "delos/optimize/study.h"

namespace delos::report {

/// What a headline is made of.
struct SearchFigures {
  std::string objective, unit;  ///< "mean eigmax", SI
  double before = 0, after = 0;
  FieldStatistics field_before, field_after;
  bool constrained = false;
  std::vector<std::string> broken;  ///< constraints that aren't kept
  std::size_t evaluations = 0;
};
[[nodiscard]] std::string headline_of(const SearchFigures& figures,
                                      const StudySummary& summary);

/// The commands that compute a study again, a line each.
/// @param file of the study, as the user named it
[[nodiscard]] std::string commands_of(const StudySummary& summary,
                                      const std::string& file);

}  // namespace delos::report
