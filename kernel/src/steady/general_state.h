// What the general solvers of all fusions share.
#pragma once

#include <cmath>
#include <numeric>
#include <vector>

#include "delos/model/infinity.h"
#include "delos/steady/fused_state.h"

namespace delos {

/// One instant's state as that of the system.
inline void set_state(const SteadyState& state, FusedState& out) {
  out.status = state.status;
  out.prior = state.prior;
  out.posterior = state.posterior;
  out.unobservable = state.unobservable;
}

/// −T/ln ρ of a closed loop that shrinks by ρ in T seconds.
inline double time_constant_of_radius(double radius, double period) {
  if (radius >= 1) return kInfinity;
  return radius > 0 ? -period / std::log(radius) : 0;
}

/// 0 … count − 1: devices that all report at once.
inline std::vector<int> all_devices(std::size_t count) {
  std::vector<int> devices(count);
  std::iota(devices.begin(), devices.end(), 0);
  return devices;
}

}  // namespace delos
