// Replacing a file as a whole, or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>

#include "delos/api.h"

namespace delos {

/// Let `fill` write to `.name.tmp-<pid>` beside `file`, then rename that to `file`.
/// Follows a symbolic link. What was there stays as it was unless everything was
/// written.
///
/// @returns empty, or a sentence that says what the system refused
[[nodiscard]] DELOS_API std::string commit_file(
    const std::filesystem::path& file, const std::function<void(std::ostream&)>& fill);

/// Empty where the folder that `file` goes to exists; else a sentence.
[[nodiscard]] DELOS_API std::string missing_folder(const std::filesystem::path& file);

}  // namespace delos
