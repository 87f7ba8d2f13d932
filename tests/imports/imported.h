// Imports, all the way to devices in their places.
#pragma once

#include <optional>
#include <string>

#include "delos/rig/system.h"
#include "delos/scene/io.h"
#include "imports/import.h"
#include "imports/written_rigs.h"
#include "support/folder.h"

namespace delos::test {

PluginRegistry& import_plugins();

/// A file of this text, imported.
struct Imported {
  std::optional<imports::Rig> rig;
  std::string text;  ///< of the scene
  std::optional<Scene> scene;
  std::optional<System> system;
  std::string findings;  ///< a line each, without the file's folder
};

/// @param files the one that is imported, then others beside it
Imported imported(const std::vector<std::pair<std::string, std::string>>& files,
                  const imports::ImportOptions& options = {});

}  // namespace delos::test
