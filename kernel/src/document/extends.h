// Scenes that extend another one.
#pragma once

#include <optional>

#include "document/reader.h"

namespace delos {

/// The tree of a scene that extends others, as one:
///
///   extends: base.yaml        the base's keys, but those that stand here too
///   set: {PATH: value, …}     then single values changed, as --set does
///
/// Duplicate keys are found on the way. Of names of files, the reader learns where the
/// bases' are.
/// @returns nullopt, with a finding, where a base can't be read
[[nodiscard]] std::optional<Node> resolve_extends(Node scene, Reader& reader);

}  // namespace delos
