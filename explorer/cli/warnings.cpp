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

Json diagnostics_json(const Diagnostics& diagnostics) {
  const auto place = [](int n) { return n > 0 ? Json(n) : Json(); };
  Json list = Json::array();
  for (const Diagnostic& d : diagnostics) {
    list.push_back({{"severity", d.severity == Severity::error ? "error" : "warning"},
                    {"file", d.where.file},
                    {"line", place(d.where.line)},
                    {"column", place(d.where.column)},
                    {"message", d.message}});
  }
  return list;
}

}  // namespace delos::cli
