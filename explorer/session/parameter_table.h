// A plugin's table of parameters for scripts and pages.
#pragma once

#include "delos/plugin.h"
#include "session/json.h"

namespace delos::session {

[[nodiscard]] const char* word(ParamKind kind);

/// {id, version, summary, params: [{name, kind, unit, default, scale, choices, lower,
/// upper, help}]}; null where a number isn't given or a bound is infinite.
[[nodiscard]] Json parameter_table(const PluginInfo& info);

}  // namespace delos::session
