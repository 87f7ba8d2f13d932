// The keys that say how long a device samples, and what that does.
#pragma once

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_timing(Reader& reader, const Place& at, DeviceEntry& out);
[[nodiscard]] std::optional<Node> write_timing(const DeviceEntry& device);

void read_noise_over_time(Reader& reader, const Place& at, DeviceEntry& out);
[[nodiscard]] std::optional<Node> write_noise_over_time(const DeviceEntry& device);

/// Exposure, rate, timing and noise of a device fit together.
void check_sample_time(Reader& reader, const Place& at, const DeviceEntry& device);

[[nodiscard]] std::vector<KeyShape> timing_keys();
[[nodiscard]] std::vector<KeyShape> noise_over_time_keys();

}  // namespace delos
