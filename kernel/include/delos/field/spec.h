// What samples should meet: "coverage >= 3", "eigmax <= 1 mm".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include "delos/api.h"
#include "delos/field/field.h"
#include "delos/model/metric.h"

namespace delos {

/// How a value stands to a limit.
enum class Relation { below, at_most, at_least, above };

/// A specification of single samples.
struct Spec {
  std::string text;  ///< as it was written
  Metric metric;
  Relation relation = Relation::at_most;
  double limit = 0;  ///< SI
};

/// "METRIC <= VALUE", or with <, >= or >; the value with a unit or in SI.
/// @returns it, or a sentence that says what is wrong and what would be right
[[nodiscard]] DELOS_API std::variant<Spec, std::string> parse_spec(
    std::string_view text, const KnownMetrics& known);

/// How many samples meet a specification.
struct SpecShare {
  std::size_t met = 0, samples = 0;  ///< outside solids
  double share = 0;  ///< of the volume, where samples have weights; else of them
};

/// Blind samples, at which the metric has no finite value, never meet one.
/// @pre the field is of the specification's metric
[[nodiscard]] DELOS_API SpecShare share_meeting(const Field& field, const Spec& spec);

}  // namespace delos
