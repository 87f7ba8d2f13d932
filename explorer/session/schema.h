// What scenes may hold, as a JSON schema: for editors that help while one writes, and
// for forms.
#pragma once

#include "delos/plugin/registry.h"
#include "session/json.h"

namespace delos::session {

/// The schema (draft 7) of scene files, with the parameters of every plugin that is
/// found. Beside the standard's keywords stand `x-unit`, the SI unit of a number, and
/// `x-scale`, how a search should step it.
///
/// It knows no dimension of units, and nothing that several values tell together: what
/// it accepts may be refused when it is read. What it refuses always is.
[[nodiscard]] Json scene_schema(PluginRegistry& plugins);

}  // namespace delos::session
