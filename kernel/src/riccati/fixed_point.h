// The fixed point of a filter map, by doubling.
#pragma once

#include "riccati/update_map.h"

namespace delos::riccati {

struct FixedPoint {
  StateMatrix posterior;  ///< Π with Π = H + A Π (I + G Π)⁻¹ Aᵀ
  int doublings = 0;
  bool settled = false;
};

/// @param map of a balanced system (balance.h) whose undetectable modes have been taken
/// out
FixedPoint fixed_point(const UpdateMap& map);

}  // namespace delos::riccati
