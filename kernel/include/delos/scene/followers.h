// What a hand that moves a variable moves with it.
#pragma once

#include <vector>

#include "delos/api.h"
#include "delos/document/override.h"
#include "delos/scene/scene.h"

namespace delos {

class PluginRegistry;

/// The changes by which the numbers that follow variables keep up with a change of
/// their scene, in SI: searches, studies and hands move what is tied or mirrored alike.
/// @param before, after the scene without and with the change; of `after` the variables
///        count that `before` has a number for, too
[[nodiscard]] DELOS_API std::vector<Override> following(Scene before, Scene after,
                                                        PluginRegistry& plugins);

}  // namespace delos
