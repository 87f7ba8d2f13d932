// The keys that say how well devices are known.
#pragma once

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_calibration(Reader& reader, const Place& at, DeviceEntry& out);
[[nodiscard]] std::optional<Node> write_calibration(const DeviceEntry& device);

/// Needs the devices and the groups.
void read_common_errors(Reader& reader, const Place& at, Scene& scene);
[[nodiscard]] std::optional<Node> write_common_errors(const Scene& scene);

/// A device's readings must tell what its errors do.
/// @param device made of the entry
/// @param layout null where it isn't known
void check_calibration(Reader& reader, const Place& at, const DeviceEntry& entry,
                       const Device& device, const StateLayout* layout);

/// The scene's fusion and motion must leave constant errors a meaning.
void check_calibrations(Reader& reader, const Place& root, const Scene& scene);

[[nodiscard]] std::vector<KeyShape> calibration_keys();
[[nodiscard]] Shape common_error_shape();

}  // namespace delos
