#include "delos/document/diagnostic.h"

#include "delos/text/number_text.h"

namespace delos {

std::string to_string(const Diagnostic& diagnostic) {
  std::string text = diagnostic.where.file;
  if (diagnostic.where.line > 0) text += ':' + std::to_string(diagnostic.where.line);
  if (diagnostic.where.column > 0)
    text += ':' + std::to_string(diagnostic.where.column);
  if (!text.empty()) text += ": ";
  text += diagnostic.severity == Severity::error ? "error: " : "warning: ";
  // What a scene holds may be anything, and a terminal obeys some of it.
  return one_line(text + diagnostic.message);
}

}  // namespace delos
