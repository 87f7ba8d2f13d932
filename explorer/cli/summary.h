// A field's statistics for people.
#pragma once

#include <iosfwd>

#include "command.h"

namespace delos::cli {

/// Where the field is best, typical and worst, and how it was computed.
void print_summary(std::ostream& out, const LoadedScene& loaded, const Field& field);

}  // namespace delos::cli
