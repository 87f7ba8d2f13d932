// All values of a scene as a form: what each is, its unit and its bounds.
#pragma once

#include "delos/plugin/registry.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// The sections of a scene but its devices and variables, by the tables that read it,
/// so that a page needs to know none of them:
///
///   {sections: [field]}
///   field: {path, name, help, kind, remove, rename, copy}, the last three where it may
///   be, and, by kind,
///     number, integer: value, unit, lower, upper
///     text:            value, known: names that it may have, where they are known
///     choice:          value, words
///     group:           members: [field], add: [{label, help, path, value}]
///     many:            value: how many there are, too many to be shown one by one
///
/// Paths are those of `--set`; what `add` and `remove` hold are changes by it. A number
/// is in SI; a bound that there isn't is null.
[[nodiscard]] Json scene_form(const LoadedScene& loaded, PluginRegistry& plugins);

}  // namespace delos::session
