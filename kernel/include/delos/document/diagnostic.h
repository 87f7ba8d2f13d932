// What is wrong with a user's text, where, and what to do about it.
#pragma once

#include <string>
#include <vector>

#include "delos/api.h"

namespace delos {

/// A place in a text; lines and columns count from 1, 0 where they don't apply.
struct SourcePosition {
  std::string file;
  int line = 0;
  int column = 0;
};

enum class Severity { error, warning };

/// One finding. The message begins with the path of the value: "devices.cam1.rate: …".
struct Diagnostic {
  SourcePosition where;
  Severity severity = Severity::error;
  std::string message;
};

using Diagnostics = std::vector<Diagnostic>;

/// Something to say about a part of a text.
struct Remark {
  std::string path;     ///< of the part: "devices.cam1"
  std::string message;  ///< one sentence
};

/// "scene.yaml:12:7: error: devices.cam1.params.focall: unknown key; did you mean
/// 'focal'?" One line of valid UTF-8 without control characters.
[[nodiscard]] DELOS_API std::string to_string(const Diagnostic& diagnostic);

}  // namespace delos
