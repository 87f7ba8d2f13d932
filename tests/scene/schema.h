// Whether the JSON schema of scenes accepts a text, by a validator of others' making.
#pragma once

#include <string>

#include "session/json.h"

namespace delos::test {

/// A YAML text as the JSON that editors check.
/// @throws YAML::Exception it isn't YAML
[[nodiscard]] session::Json json_of_yaml(const std::string& text);

/// What the schema of these tests' plugins finds wrong with it; empty: nothing.
[[nodiscard]] std::string schema_problem(const session::Json& scene);

/// The same of a schema.
[[nodiscard]] std::string schema_problem(const session::Json& schema,
                                         const session::Json& scene);

}  // namespace delos::test
