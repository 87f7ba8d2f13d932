#include "session/schema.h"

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "delos/document/shape.h"
#include "delos/scene/scene_shape.h"
#include "session/parameter_shape.h"

namespace delos::session {
namespace {

using Plugins = std::vector<const PluginInfo*>;
using Keys = std::vector<KeyShape> (*)();

/// A number as decimal notation has it, then perhaps a unit.
std::string quantity_pattern(const Bounds& bounds) {
  const char* sign = bounds.least >= 0 ? "\\+?" : "[-+]?";
  return std::string("^\\s*") + sign +
         "([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)?(\\s*[^-+.0-9\\s].*)?$";
}

void add_bounds(Json& schema, const Bounds& b) {
  if (std::isfinite(b.least))
    schema[b.above ? "exclusiveMinimum" : "minimum"] = b.least;
  if (std::isfinite(b.greatest))
    schema[b.below ? "exclusiveMaximum" : "maximum"] = b.greatest;
}

/// A bare number is in SI, so that its bounds count; text has a unit.
Json number_schema(const Shape& shape) {
  Json bare{{"type", "number"}};
  add_bounds(bare, shape.bounds);
  Json schema{
      {"anyOf",
       {bare, {{"type", "string"}, {"pattern", quantity_pattern(shape.bounds)}}}}};
  if (shape.unit) schema["x-unit"] = shape.unit;
  return schema;
}

Json integer_schema(const Shape& shape) {
  Json bare{{"type", "integer"}};
  add_bounds(bare, shape.bounds);
  return {{"anyOf", {bare, {{"type", "string"}, {"pattern", "^[-+]?[0-9]+$"}}}}};
}

/// YAML makes truths of some words.
template <class Words>
Json choice_schema(const Words& words) {
  Json values = Json::array();
  for (const std::string_view word : words) {
    values.push_back(word);
    if (word == "true") values.push_back(true);
    if (word == "false") values.push_back(false);
  }
  return {{"enum", values}};
}

Json list_schema(Json items, const Shape& shape) {
  Json schema{{"type", "array"}, {"items", std::move(items)}};
  if (shape.least > 0) schema["minItems"] = shape.least;
  if (shape.most != Shape::kMany) schema["maxItems"] = shape.most;
  return schema;
}

/// Writes each mapping once, as a definition that others refer to.
class Writer {
 public:
  explicit Writer(Plugins plugins) : plugins_(std::move(plugins)) {}

  /// @param path what a mapping's definition is called
  Json schema_of(const Shape& shape, const std::string& path);
  [[nodiscard]] const Json& definitions() const { return definitions_; }

 private:
  Json reference_to(Keys keys, const std::string& path);
  Json map_schema(const std::vector<KeyShape>& keys, const std::string& path);

  Plugins plugins_;
  std::map<Keys, std::string> names_;
  Json definitions_ = Json::object();
};

Json row_schema(const ParamSpec& row) {
  Json schema = Writer({}).schema_of(shape_of(row), "");
  if (row.kind == ParamKind::choice) schema = choice_schema(words_of(row));
  schema["description"] = row.help;
  if (row.scale == ParamScale::log) schema["x-scale"] = "log";
  return schema;
}

/// "Where the type is this one, the parameters are these." Without a preset those that
/// have no default must be there.
Json rules_of(const PluginInfo& plugin) {
  Json properties = Json::object(), required = Json::array(), numbers = Json::object();
  for (const ParamSpec& row : std::span(plugin.params, plugin.n_params)) {
    properties[row.name] = row_schema(row);
    if (!has_default(row)) required.push_back(row.name);
    if (row.kind == ParamKind::number)
      numbers[row.name] = number_schema(shapes::number(row.unit, at_least(0)));
  }
  const auto only = [](Json of) {
    return Json{{"properties", std::move(of)}, {"additionalProperties", false}};
  };
  const Json calibration{{"properties", {{"params", only(std::move(numbers))}}}};
  const Json params{{"params", only(std::move(properties))},
                    {"calibration", calibration}};
  Json of_type{{"properties", {{"type", {{"const", plugin.id}}}}},
               {"required", Json::array({"type"})}};
  Json rules = Json::array();
  rules.push_back({{"if", of_type}, {"then", {{"properties", params}}}});
  if (required.empty()) return rules;
  of_type["not"] = {{"required", Json::array({"preset"})}};
  rules.push_back({{"if", of_type},
                   {"then",
                    {{"properties", {{"params", {{"required", required}}}}},
                     {"required", Json::array({"params"})}}}});
  return rules;
}

/// A mapping that has a plugin's parameters beside the plugin's `type`.
bool is_device(const std::vector<KeyShape>& keys) {
  const auto has = [&](std::string_view name, Shape::Kind kind) {
    return std::any_of(keys.begin(), keys.end(), [&](const KeyShape& key) {
      return key.name == name && key.shape.kind == kind;
    });
  };
  return has("type", Shape::Kind::text) && has("params", Shape::Kind::parameters);
}

Json Writer::map_schema(const std::vector<KeyShape>& keys, const std::string& path) {
  Json properties = Json::object(), required = Json::array();
  for (const KeyShape& key : keys) {
    // Beside a reference nothing else counts, in draft 7.
    Json property{{"allOf", {schema_of(key.shape, path + "." + key.name)}}};
    property["description"] = key.help;
    properties[key.name] = std::move(property);
    if (key.required) required.push_back(key.name);
  }
  Json schema{{"type", "object"}, {"properties", std::move(properties)}};
  if (!required.empty()) schema["required"] = std::move(required);
  schema["additionalProperties"] = false;
  if (is_device(keys))
    for (const PluginInfo* plugin : plugins_)
      for (Json& rule : rules_of(*plugin)) schema["allOf"].push_back(std::move(rule));
  return schema;
}

Json Writer::reference_to(Keys keys, const std::string& path) {
  const auto [name, is_new] = names_.emplace(keys, path);
  if (is_new) definitions_[path] = map_schema(keys(), path);
  return {{"$ref", "#/definitions/" + name->second}};
}

Json Writer::schema_of(const Shape& shape, const std::string& path) {
  switch (shape.kind) {
    case Shape::Kind::number:
      return number_schema(shape);
    case Shape::Kind::integer:
      return integer_schema(shape);
    case Shape::Kind::numbers:
      return list_schema(number_schema(shape), shape);
    case Shape::Kind::text:
      return {{"type", {"string", "number", "boolean"}}};
    case Shape::Kind::name:
      return {{"type", {"string", "number", "boolean"}},
              {"pattern", "^[^.= ]([^.=]*[^.= ])?$"}};
    case Shape::Kind::choice:
      return choice_schema(shape.words());
    case Shape::Kind::list:
      return list_schema(schema_of(shape.item(), path), shape);
    case Shape::Kind::map:
      return reference_to(shape.keys, path);
    case Shape::Kind::table:
      return {{"type", "object"},
              {"additionalProperties", schema_of(shape.item(), path)}};
    case Shape::Kind::parameters:
      return {{"type", "object"}};
    case Shape::Kind::either: {
      Json forms = Json::array();
      for (const Shape& form : shape.forms())
        forms.push_back(schema_of(
            form, forms.empty() ? path : path + "." + std::to_string(forms.size())));
      return {{"anyOf", std::move(forms)}};
    }
    case Shape::Kind::nothing:
      return {{"type", "null"}};
    case Shape::Kind::anything:
      return Json::object();
  }
  return Json::object();
}

}  // namespace

Json scene_schema(PluginRegistry& plugins) {
  Plugins known;
  for (const PluginLoad& load : plugins.all())
    if (load.info) known.push_back(load.info);
  Writer writer(std::move(known));
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", "A Delos scene"}};
  schema.update(writer.schema_of(scene_shape(), "scene"));
  schema["definitions"] = writer.definitions();
  return schema;
}

}  // namespace delos::session
