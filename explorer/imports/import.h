// Files that people have, as scenes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "imports/rig.h"

namespace delos::imports {

/// Read a calibration, or an input file of Artemis; what the file holds says which.
///
/// @param folder  of the scene that will be written; empty: this file's
/// @param findings what is wrong, and what is hardly meant; appended
/// @returns the devices, with motion and samples; nullopt where a finding is an error
[[nodiscard]] std::optional<Rig> import_file(const std::filesystem::path& file,
                                             const std::filesystem::path& folder,
                                             const ImportOptions& options,
                                             Diagnostics& findings);

/// The same of a text; `file` names it, and is what files beside it are looked for
/// from.
[[nodiscard]] std::optional<Rig> import_text(std::string_view text,
                                             const std::filesystem::path& file,
                                             const std::filesystem::path& folder,
                                             const ImportOptions& options,
                                             Diagnostics& findings);

}  // namespace delos::imports
