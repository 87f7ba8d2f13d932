// Which part of the samples meets what is asked for.
#pragma once

#include <string>
#include <vector>

#include "delos/field/evaluate.h"
#include "delos/field/spec.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// Specifications as text, for this scene.
/// @throws Refusal of the question: one can't be read, or its metric not be computed
[[nodiscard]] std::vector<Spec> specs_of(const std::vector<std::string>& texts,
                                         const LoadedScene& loaded);

/// What came of a specification.
struct MetSpec {
  Spec spec;
  SpecShare share;
  bool by_volume = false;  ///< samples stand for volumes of their own
};

/// On the samples of a field; metrics other than its own are evaluated there.
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] std::vector<MetSpec> met_specs(const std::vector<Spec>& specs,
                                             const LoadedScene& loaded,
                                             const Field& field,
                                             const FieldOptions& options);

/// [{spec, share, met, samples}]
[[nodiscard]] Json specs_json(const std::vector<MetSpec>& all);

}  // namespace delos::session
