// JSON on stdout.
#pragma once

#include <iostream>

#include "session/json.h"

namespace delos::cli {

using session::Json;
using session::number;
using session::numbers;
using session::rows;

/// A document on stdout.
inline void print_document(const Json& json) {
  std::cout << session::text_of(json, 2) << "\n";
}

}  // namespace delos::cli
