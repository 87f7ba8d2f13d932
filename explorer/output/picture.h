// A slice of a field as a picture for reports.
#pragma once

#include <iosfwd>

#include "delos/field/field.h"
#include "output/write.h"

namespace delos {

/// PNG with axes in metres, a colour bar, hatching where it is blind, and the best and
/// the worst sample of the slice with their values.
/// @pre has_slice(field.samples)
void write_picture(const Field& field, const PictureOptions& options,
                   std::ostream& out);

}  // namespace delos
