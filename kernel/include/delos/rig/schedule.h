// When which devices report, over one cycle of all their rates.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "delos/api.h"
#include "delos/rig/system.h"

namespace delos {

/// Most updates in a cycle that is solved exactly.
inline constexpr int kMaxCycle = 2000;

/// One instant of a cycle.
struct UpdateSlot {
  double interval = 0;       ///< seconds since the instant before, > 0; cyclic
  std::vector<int> devices;  ///< who reports at this instant
};

/// The cycle after which the devices' updates repeat.
///
/// periodic: instants phase_i + j·period_i over the least common multiple of the
/// periods, which are taken to be fractions of each other within 1e-9. sequential: one
/// device after the other, each taking its own period.
/// @returns the cycle, or a sentence that says why there is none of at most kMaxCycle
///          instants and what would help.
[[nodiscard]] DELOS_API std::variant<std::vector<UpdateSlot>, std::string> update_cycle(
    const System& system);

}  // namespace delos
