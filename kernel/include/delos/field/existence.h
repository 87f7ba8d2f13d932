// Where a steady state exists, and why.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "delos/rig/system.h"

namespace delos {

/// Which conditions of a steady state a scene keeps.
struct Existence {
  std::size_t places = 0;      ///< that were tried
  std::size_t detectable = 0;  ///< of them: every mode that doesn't die out is seen
  bool stabilizable = true;    ///< noise drives every mode that doesn't die out
  bool on_circle = false;      ///< one that isn't driven neither grows nor dies out
  std::vector<std::string> undriven;  ///< states that such modes move
};

/// Try up to `most` places of a scene, outside solids.
/// @pre the system was built of the scene
/// @returns nothing tried where no Riccati equation is solved: artemis fusion
[[nodiscard]] DELOS_API Existence existence(const Scene& scene, const System& system,
                                            std::size_t most);

/// "detectable at all places tried (200), stabilizable": empty where nothing was tried.
[[nodiscard]] DELOS_API std::string to_string(const Existence& existence);

}  // namespace delos
