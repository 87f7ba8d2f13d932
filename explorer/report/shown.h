// What is shown of a design in a report.
#pragma once

#include "report/report.h"
#include "session/drawn_field.h"

namespace delos::report {

/// A design with its field, and what is drawn of it.
struct Shown {
  const session::LoadedScene& loaded;
  Field field;  ///< on the scene's own samples
  session::DrawnField drawn;
};

/// Evaluate a design. @throws as scene_report()
[[nodiscard]] Shown shown(const session::LoadedScene& loaded, const Making& making);

/// {description, around, field}
[[nodiscard]] session::Json design_json(const Shown& shown, PluginRegistry& plugins);

/// A field in base64. What depends on the machine and the hour isn't in it.
[[nodiscard]] session::Json packed_json(session::DrawnField drawn);

/// [{part, version}] of the program, of the one that began a study where that is
/// another, and of the plugins that a scene uses.
[[nodiscard]] session::Json versions_json(const Making& making,
                                          const std::string& begun_with,
                                          const Scene& scene, PluginRegistry& plugins);

}  // namespace delos::report
