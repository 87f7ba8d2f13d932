#include "session/diagnostics_json.h"

namespace delos::session {

Json diagnostics_json(const Diagnostics& diagnostics) {
  const auto place = [](int n) { return n > 0 ? Json(n) : Json(); };
  Json list = Json::array();
  for (const Diagnostic& d : diagnostics) {
    list.push_back({{"severity", d.severity == Severity::error ? "error" : "warning"},
                    {"file", d.where.file},
                    {"line", place(d.where.line)},
                    {"column", place(d.where.column)},
                    {"message", d.message}});
  }
  return list;
}

}  // namespace delos::session
