// Options of surfaces through scattered samples.
#pragma once

#include <string>

#include "command.h"
#include "session/surface_through.h"

namespace delos::cli {

struct ThroughOptions {
  std::string method;  ///< empty: no surface
  std::string over = "z", relief = "0 m", radius;
  double power = 2;
};

/// All of them but --relief.
/// @param name of the option that chooses the method, without dashes
void add_through_options(CLI::App& command, const std::string& name,
                         ThroughOptions& options);

/// @param name as add_through_options()
/// @throws Failure kUsage
[[nodiscard]] session::Through through_of(const ThroughOptions& options,
                                          const std::string& name);

/// "surface through 52 samples by linear: 1 mm to 3 mm, 5 % of it blind".
/// @param through as surface_through() sums it up
[[nodiscard]] std::string through_words(const session::Json& through,
                                        const std::string& unit);

}  // namespace delos::cli
