#include "warnings.h"

#include <iostream>

#include "session/check_answer.h"

namespace delos::cli {

Diagnostics print_doubts(const std::filesystem::path& file, const LoadedScene& loaded,
                         PluginRegistry& plugins) {
  Diagnostics warnings = session::doubts_of(file, loaded, plugins);
  for (const Diagnostic& d : warnings) std::cerr << to_string(d) << "\n";
  return warnings;
}

}  // namespace delos::cli
