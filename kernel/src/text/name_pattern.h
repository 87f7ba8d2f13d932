// Names that a pattern means.
#pragma once

#include <string_view>

namespace delos {

/// Whether a name fits a pattern in which '*' stands for anything.
[[nodiscard]] inline bool fits(std::string_view name, std::string_view pattern) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() != '*')
    return !name.empty() && name.front() == pattern.front() &&
           fits(name.substr(1), pattern.substr(1));
  for (std::size_t skip = 0; skip <= name.size(); ++skip)
    if (fits(name.substr(skip), pattern.substr(1))) return true;
  return false;
}

}  // namespace delos
