// Which metrics have slopes with respect to the information.
#pragma once

#include <string>

#include "delos/api.h"
#include "delos/model/metric.h"
#include "delos/rig/system.h"

namespace delos {

/// Empty where SoftField can differentiate the metric of the system; else a sentence
/// that says why not.
[[nodiscard]] DELOS_API std::string slope_problem(const System& system,
                                                  const Metric& metric);

}  // namespace delos
