// A project of one's own with a device in it, to begin with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace delos::session {

/// What was written, and what it builds against.
struct NewDevice {
  std::vector<std::filesystem::path> files;
  std::filesystem::path prefix;  ///< of CMAKE_PREFIX_PATH
};

/// Write a device's source, build, contract test, scene and README into a folder, which
/// is made where it isn't there.
/// @param id snake_case
/// @throws std::runtime_error it is no such id; a file is there already; one can't be
///         written; the patterns of an installation are missing
NewDevice write_new_device(const std::string& id, const std::filesystem::path& folder);

}  // namespace delos::session
