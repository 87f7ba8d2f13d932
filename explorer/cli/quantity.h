// Quantities on the command line.
#pragma once

#include <string>

namespace delos::cli {

/// A number above 0 in an SI unit, such as '2 ms'.
/// @param unit SI, "1" of a bare number
/// @throws Failure kUsage
[[nodiscard]] double quantity_above_0(const std::string& text, const char* unit,
                                      const char* option);

/// The same, 0 or above; empty is 0.
/// @throws Failure kUsage
[[nodiscard]] double quantity_from_0(const std::string& text, const char* unit,
                                     const char* option);

}  // namespace delos::cli
