// Which of its forms a written value has.
#pragma once

#include <string>
#include <vector>

#include "delos/document/shape.h"
#include "session/json.h"

namespace delos::session {

[[nodiscard]] bool is_one_of(const std::vector<KeyShape>& keys,
                             const std::string& name);

/// The form of a shape that a value has, as far as the first look tells; text where it
/// has none.
/// @param value of value_tree()
[[nodiscard]] Shape form_of(Shape shape, const Json& value);

/// What paths call number i of a list that stands under a key.
[[nodiscard]] std::string component(const std::string& key, const Shape& shape,
                                    std::size_t i);

}  // namespace delos::session
