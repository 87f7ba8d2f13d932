// Options of evaluations, as Python gives them.
#pragma once

#include <string>

#include "delos/field/evaluate.h"
#include "stoppable.h"

namespace delos::python {

/// @param watch kept by reference
/// @throws Refusal of the question: there is no such solver
[[nodiscard]] FieldOptions field_options(Watch& watch, int threads,
                                         const std::string& solver);

}  // namespace delos::python
