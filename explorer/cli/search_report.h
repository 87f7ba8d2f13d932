// What a search found, for people and for scripts.
#pragma once

#include <functional>
#include <iosfwd>

#include "command.h"
#include "delos/optimize/answers.h"
#include "delos/optimize/optimize.h"
#include "json.h"
#include "status_line.h"

namespace delos::cli {

/// The contract's document: `optimize --json`.
[[nodiscard]] Json search_json(const OptimizeResult& result, PluginRegistry& plugins);

/// What changed, and whether constraints are kept.
void print_search(std::ostream& out, const OptimizeResult& result,
                  PluginRegistry& plugins);

/// What the design depends on: `answers` of the document, and a text.
[[nodiscard]] Json answers_json(const Answers& answers);
void print_answers(std::ostream& out, const Answers& answers, Scene scene,
                   PluginRegistry& plugins);

/// "mean eigmax"
[[nodiscard]] std::string objective_text(const Scene& scene);
/// The objective's unit, "1" where terms have several.
[[nodiscard]] std::string objective_unit(const Scene& scene);

/// What a maximised objective is, without the sign that minimising gave it.
[[nodiscard]] double objective_shown(const Scene& scene, double objective);
/// The SI unit of a constraint's slack.
[[nodiscard]] std::string constraint_unit(const ConstraintEntry& entry,
                                          const Scene& scene);

/// The best so far, on a line of stderr.
class SearchLine {
 public:
  explicit SearchLine(const Scene& scene);
  void update(const SearchProgress& at);
  void clear();

 private:
  StatusLine line_;
  std::string objective_, unit_;
};

/// Run a search and tell of it on stdout.
/// @param about   what a refusal is about: the scene, or the study
/// @param study   the file that keeps the search; empty: none
/// @param explain what the result depends on, or empty
/// @param warnings about the scene, for the JSON document
/// @returns the exit code
/// @throws Failure kDiagnostics
int finish_search(const std::function<OptimizeResult()>& search, SearchLine& line,
                  const std::filesystem::path& about,
                  const std::filesystem::path& study, PluginRegistry& plugins,
                  bool json,
                  const std::function<Answers(const OptimizeResult&)>& explain = {},
                  const Diagnostics& warnings = {});

}  // namespace delos::cli
