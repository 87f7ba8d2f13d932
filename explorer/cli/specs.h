// Which part of the samples meets what the user asks for.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "command.h"
#include "session/specs.h"

namespace delos::cli {

using session::MetSpec;
using session::specs_json;

void add_spec_option(CLI::App& command, std::vector<std::string>& texts);

/// @throws Failure kUsage
[[nodiscard]] std::vector<Spec> asked_specs(const std::vector<std::string>& texts,
                                            const LoadedScene& loaded);

/// On the samples of a field; metrics other than its own are evaluated there.
/// @throws Failure as unsolvable()
[[nodiscard]] std::vector<MetSpec> met_specs(const std::vector<Spec>& specs,
                                             const LoadedScene& loaded,
                                             const Field& field,
                                             const SceneOptions& options,
                                             const Interrupt& interrupt);

void print_specs(std::ostream& out, const std::vector<MetSpec>& all);

}  // namespace delos::cli
