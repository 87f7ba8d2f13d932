// What becomes of a device's readings where something stands in their way.
#pragma once

namespace delos {

/// Radio and sound pass walls or go round them: a reading comes through sometimes, late
/// and with more noise. Whether something stands in the way is known to who solves;
/// that a reading is late isn't.
struct WithoutSight {
  double probability = 0;  ///< that an update has the reading, 0 to 1; 0: it is hidden
  double sigma = 0;        ///< more noise of it, its SI unit, ≥ 0
  double bias = 0;         ///< what it is off by, its SI unit

  [[nodiscard]] bool arrives() const { return probability > 0; }
  friend bool operator==(const WithoutSight&, const WithoutSight&) = default;
};

}  // namespace delos
