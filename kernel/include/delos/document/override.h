// A change of one value of a text, by its path.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "delos/api.h"

namespace delos {

/// A change of one value before a scene is checked: "devices.s1.at.z" = "1.2 m".
struct Override {
  std::string path;
  std::string value;
};

/// "PATH=VALUE" as the command line writes it; nullopt where there is no '=' or no
/// path.
[[nodiscard]] DELOS_API std::optional<Override> parse_override(std::string_view text);

}  // namespace delos
