// What the server answers.
#pragma once

#include <string>

#include "session/diagnostics_json.h"

namespace delos::server {

using session::Json;

/// Status codes of HTTP that are used (RFC 9110, section 15).
enum class Status : unsigned {
  ok = 200,
  bad_request = 400,
  forbidden = 403,
  not_found = 404,
  method_not_allowed = 405,
  conflict = 409,  ///< a newer request took its place
  too_large = 413,
  wrong_type = 415,
  misdirected = 421,
  unprocessable = 422,
  internal = 500,
  busy = 503,
};

struct Reply {
  Status status = Status::ok;
  std::string type = "application/json";
  std::string body;
};

[[nodiscard]] inline Reply json_reply(const Json& json) {
  return {Status::ok, "application/json", session::text_of(json)};
}

/// {error: {message, findings: [{severity, file, line, column, message}]}}
[[nodiscard]] inline Reply refusal(Status status, const std::string& message,
                                   const Diagnostics& findings = {}) {
  const Json error{{"message", message},
                   {"findings", session::diagnostics_json(findings)}};
  return {status, "application/json", session::text_of({{"error", error}})};
}

}  // namespace delos::server
