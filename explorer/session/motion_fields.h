// The fields of a scene's several motions, and the worst of them at each sample.
#pragma once

#include <string>
#include <vector>

#include "delos/field/field.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// The field of one motion.
struct MotionField {
  std::string name;
  Field field;
};

/// At each sample the worst value of all; what any doesn't observe isn't observed.
/// @pre one or more, of one metric and the same samples
[[nodiscard]] Field envelope_of(const std::vector<MotionField>& fields);

/// The envelope's document, with that of each as `motions`.
[[nodiscard]] Json motion_fields_json(const LoadedScene& loaded, const Field& envelope,
                                      const std::vector<MotionField>& fields);

}  // namespace delos::session
