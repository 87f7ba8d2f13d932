#include "output/marker.h"

#include "delos/rig/system.h"

namespace delos {

std::vector<Marker> markers_of(const Scene& scene, const System& system) {
  std::vector<Marker> markers;
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    const PlacedDevice& device = system.devices[i];
    if (device.carried()) continue;
    const DeviceEntry& entry = scene.devices[i];
    const bool faces = entry.mounting ||
                       !std::holds_alternative<std::monostate>(entry.placement.facing);
    markers.push_back({device.name, device.X_WS().p, std::nullopt});
    if (faces) markers.back().faces = device.X_WS().R.col(2);
  }
  return markers;
}

}  // namespace delos
