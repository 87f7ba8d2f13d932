#include "observe/sighting.h"

#include "delos/model/lanes.h"
#include "observe/point_rows.h"
#include "rig/sight.h"

namespace delos {

Sightings::Sightings(const System& system) {
  const int coordinates = system.motion.layout.coordinates();
  const int columns = information_size(system);
  PointRows rows;
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    // The number of rows is the same of every point, a far-away one's too.
    const TargetPose anywhere{Eigen::Matrix3d::Identity(), {1, 2, 3}};
    // Rows that fade in a shadow aren't smooth across its edge.
    const bool by_rows = !reads_without_sight(system, system.devices[i]) &&
                         observe_rows(system, system.devices[i], {0, 0, 0},
                                      {&anywhere, 1}, nullptr, rows);
    if (by_rows) {
      for (const PlacedMarker& marker : system.markers) {
        const auto numbers =
            static_cast<std::size_t>(rows.rows) * static_cast<std::size_t>(coordinates);
        all.push_back({i, marker, true, rows.rows, coordinates, record, numbers});
        record += numbers;
      }
    } else {
      const auto numbers = static_cast<std::size_t>(packed_index(columns, 0));
      all.push_back({i, {0, 0, 0}, false, 0, columns, record, numbers});
      record += numbers;
    }
  }
}

}  // namespace delos
