// Which part of the samples meets what the user asks for.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "command.h"
#include "delos/field/spec.h"
#include "json.h"

namespace delos::cli {

void add_spec_option(CLI::App& command, std::vector<std::string>& texts);

/// @throws Failure kUsage
[[nodiscard]] std::vector<Spec> specs_of(const std::vector<std::string>& texts,
                                         const LoadedScene& loaded);

/// What came of a specification.
struct MetSpec {
  Spec spec;
  SpecShare share;
  bool by_volume = false;  ///< samples stand for volumes of their own
};

/// On the samples of a field; metrics other than its own are evaluated there.
/// @throws Failure as unsolvable()
[[nodiscard]] std::vector<MetSpec> met_specs(const std::vector<Spec>& specs,
                                             const LoadedScene& loaded,
                                             const Field& field,
                                             const SceneOptions& options,
                                             const Interrupt& interrupt);

void print_specs(std::ostream& out, const std::vector<MetSpec>& all);
[[nodiscard]] Json specs_json(const std::vector<MetSpec>& all);

}  // namespace delos::cli
