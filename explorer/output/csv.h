// Fields as comma-separated values.
#pragma once

#include <iosfwd>

#include "delos/field/field.h"

namespace delos {

/// `x,y,z,value,observable` and a line a sample, ended by a newline alone. Numbers read
/// back as the same doubles; a value that isn't finite is empty; observable is 0 or 1.
void write_csv(const Field& field, std::ostream& out);

}  // namespace delos
