#pragma once

#include <cstddef>
#include <string>

namespace delos::test {

/// How often a text holds another, side by side.
inline std::size_t occurrences(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + what.size()))
    ++n;
  return n;
}

}  // namespace delos::test
