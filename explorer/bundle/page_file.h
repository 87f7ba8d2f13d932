// The page's files, which stand in the program: nothing is read from a disk.
#pragma once

#include <optional>
#include <string_view>

namespace delos::bundle {

struct PageFile {
  std::string_view type;  ///< for Content-Type
  std::string_view bytes;
};

/// The file of a path such as "/explorer.js"; nullopt where the table has none.
[[nodiscard]] std::optional<PageFile> page_file(std::string_view path);

}  // namespace delos::bundle
