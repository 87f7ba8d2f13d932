// Statistics of a range of a field's points.
#pragma once

#include <cstddef>

#include "delos/api.h"
#include "delos/field/field.h"

namespace delos {

/// summarize() over the points first, …, first + count − 1.
/// @pre the range lies within the field
[[nodiscard]] DELOS_API FieldStatistics summarize_range(const Field& field,
                                                        std::size_t first,
                                                        std::size_t count);

}  // namespace delos
