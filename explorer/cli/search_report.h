// What a search found, for people and for scripts.
#pragma once

#include <functional>
#include <iosfwd>

#include "command.h"
#include "json.h"
#include "session/search_answer.h"
#include "status_line.h"

namespace delos::cli {

using session::answers_json;
using session::constraint_unit;
using session::objective_shown;
using session::objective_text;
using session::objective_unit;
using session::search_json;

/// What changed, and whether constraints are kept.
void print_search(std::ostream& out, const OptimizeResult& result,
                  PluginRegistry& plugins);

/// What the design depends on.
void print_answers(std::ostream& out, const Answers& answers, Scene scene,
                   PluginRegistry& plugins);

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
