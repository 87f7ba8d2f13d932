// Room models: closed meshes whose faces look inward, around everything.
#pragma once

#include "delos/scene/scene.h"
#include "document/reader.h"

namespace delos {

/// Mark occluders that are room models as rooms, with a warning: closed meshes of the
/// world that face inward and hold every device and every place that is looked at.
/// @param at the list of occluders
/// @pre the scene has no errors
void find_rooms(Reader& reader, const Place& at, Scene& scene);

}  // namespace delos
