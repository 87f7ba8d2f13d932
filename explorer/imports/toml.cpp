// TOML as values, by toml++.
#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>

#include "delos/text/units.h"
#include "imports/value.h"

namespace delos::imports {
namespace {

/// @pre toml++ itself nests no deeper than 256
Value toml_value(const toml::node& node) {
  Value out;
  out.line = static_cast<int>(node.source().begin.line);
  out.column = static_cast<int>(node.source().begin.column);
  if (const auto* table = node.as_table()) {
    out.kind = Value::Kind::map;
    for (const auto& [key, value] : *table)
      out.members.emplace_back(std::string(key.str()), toml_value(value));
  } else if (const auto* array = node.as_array()) {
    out.kind = Value::Kind::list;
    for (const toml::node& value : *array)
      out.members.emplace_back("", toml_value(value));
  } else if (const auto* text = node.as_string()) {
    out.text = text->get();
  } else if (const auto* whole = node.as_integer()) {
    out.text = std::to_string(whole->get());
  } else if (const auto* real = node.as_floating_point()) {
    out.text = shortest(real->get());
  } else if (const auto* yes = node.as_boolean()) {
    out.text = yes->get() ? "true" : "false";
  }
  return out;
}

}  // namespace

std::optional<Value> parse_toml(std::string_view text, Source& source) {
  try {
    return toml_value(toml::parse(text));
  } catch (const toml::parse_error& e) {
    source.error(static_cast<int>(e.source().begin.line),
                 "isn't whole TOML: " + std::string(e.description()));
    return std::nullopt;
  }
}

}  // namespace delos::imports
