// Fields as JSON with every value.
#pragma once

#include <iosfwd>

#include "delos/field/field.h"

namespace delos {

/// The members of field_json(), then
///
///   "columns": ["x", "y", "z", "value", "observable"],
///   "values": [[x, y, z, value or null, 0 or 1], …]     one sample a line
void write_json(const Field& field, std::ostream& out);

}  // namespace delos
