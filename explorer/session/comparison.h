// Scenes side by side, on the samples of the first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delos/field/field.h"
#include "delos/observe/beacon_use.h"
#include "session/json.h"
#include "session/loaded_scene.h"
#include "session/specs.h"

namespace delos::session {

/// What one scene of a comparison shows.
struct ComparedSide {
  Field field;
  FieldStatistics statistics;
  std::optional<double> better;  ///< the part of the samples that is better than asked
  std::vector<MetSpec> specs;
  std::optional<BeaconUse> use;  ///< where devices on the target see beacons
};

// NOLINTNEXTLINE(bugprone-exception-escape): as its fields
struct ComparisonAnswer {
  std::vector<ComparedSide> sides;
  std::vector<Comparison> differences;  ///< of each later side from the first
  bool cancelled = false;               ///< then there are fewer sides than scenes
};

/// What is shown of each side besides its field.
struct ComparisonQuestion {
  std::optional<Spec> better;      ///< of the metric that is compared
  std::vector<std::string> specs;  ///< as specs_of()
};

/// Give all sides one fusion, unless they demand different ones.
void evaluate_alike(std::vector<LoadedScene>& sides);

/// Why these sides can't be compared, a sentence; empty where they can.
/// @param names what the user calls each
[[nodiscard]] std::string incomparable(const std::vector<LoadedScene>& sides,
                                       const std::vector<std::string>& names);

/// @pre two sides or more, comparable
/// @throws Refusal as specs_of()
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] ComparisonAnswer compare_scenes(const std::vector<LoadedScene>& sides,
                                              const ComparisonQuestion& question,
                                              const FieldOptions& options);

/// The same of fields that were stored.
/// @pre two or more
/// @throws Refusal of the question: they are of other samples or metrics than the first
[[nodiscard]] ComparisonAnswer compare_stored(std::vector<Field> fields);

/// Whether all values are of the same covariance.
[[nodiscard]] bool evaluated_alike(const ComparisonAnswer& answer);

/// The contract's document (`compare --json`).
[[nodiscard]] Json comparison_json(const ComparisonAnswer& answer);

}  // namespace delos::session
