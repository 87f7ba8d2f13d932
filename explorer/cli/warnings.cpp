#include "warnings.h"

#include <iostream>

#include "delos/field/doubts.h"

namespace delos::cli {

Diagnostics doubts_of(const std::filesystem::path& file, const LoadedScene& loaded,
                      PluginRegistry& plugins) {
  return warnings_of(file, doubts(loaded.scene, loaded.system, plugins), plugins);
}

Diagnostics print_doubts(const std::filesystem::path& file, const LoadedScene& loaded,
                         PluginRegistry& plugins) {
  Diagnostics warnings = doubts_of(file, loaded, plugins);
  for (const Diagnostic& d : warnings) std::cerr << to_string(d) << "\n";
  return warnings;
}

}  // namespace delos::cli
