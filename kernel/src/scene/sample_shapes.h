// Grids and parallelograms of samples: the keys of `volume` and `plane`.
#pragma once

#include <optional>

#include "delos/scene/scene.h"
#include "scene/keys.h"

namespace delos {

// nullopt: there is a finding.
[[nodiscard]] std::optional<VolumeSampling> read_volume(Reader& reader,
                                                        const Place& at);
[[nodiscard]] std::optional<PlaneSampling> read_plane(Reader& reader, const Place& at);

[[nodiscard]] Node write_volume(const VolumeSampling& volume);
[[nodiscard]] Node write_plane(const PlaneSampling& plane);

}  // namespace delos
