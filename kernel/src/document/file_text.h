// The text of a file, all of it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace delos {

/// Read a file. Pipes and devices aren't read: they may never end.
/// @param[out] why where nothing is returned: "it is a folder", "No such file or
///             directory"
[[nodiscard]] std::optional<std::string> file_text(const std::filesystem::path& file,
                                                   std::string& why);

}  // namespace delos
