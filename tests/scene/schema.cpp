#include "scene/schema.h"

#include <yaml-cpp/yaml.h>

#include <charconv>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "scene/load.h"
#include "session/schema.h"

namespace delos::test {
namespace {

using session::Json;

/// A plain scalar is what it looks like; a quoted one is text.
Json scalar(const YAML::Node& node) {
  const std::string& text = node.Scalar();
  if (node.Tag() == "!") return text;
  if (text == "true" || text == "false") return text == "true";
  double number = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return text;
  if (number == std::floor(number) && std::abs(number) < 1e15)
    return static_cast<std::int64_t>(number);
  return number;
}

Json json_of(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Scalar:
      return scalar(node);
    case YAML::NodeType::Sequence: {
      Json list = Json::array();
      for (const YAML::Node& item : node) list.push_back(json_of(item));
      return list;
    }
    case YAML::NodeType::Map: {
      Json map = Json::object();
      for (const auto& entry : node) map[entry.first.Scalar()] = json_of(entry.second);
      return map;
    }
    default:
      return nullptr;
  }
}

/// The validator knows documents whose keys are sorted.
nlohmann::json sorted(const Json& json) { return nlohmann::json::parse(json.dump()); }

class Validator {
 public:
  explicit Validator(const Json& schema) {
    const nlohmann::json document = sorted(schema);
    const valijson::adapters::NlohmannJsonAdapter adapter(document);
    valijson::SchemaParser().populateSchema(adapter, schema_);
  }

  std::string problem(const Json& scene) {
    const nlohmann::json document = sorted(scene);
    const valijson::adapters::NlohmannJsonAdapter adapter(document);
    valijson::ValidationResults results;
    if (validator_.validate(schema_, adapter, &results)) return "";
    std::string text = "refused";
    valijson::ValidationResults::Error error;
    while (results.popError(error)) {
      text += "\n  ";
      for (const std::string& part : error.context) text += part;
      text += ": " + error.description;
    }
    return text;
  }

 private:
  valijson::Schema schema_;
  valijson::Validator validator_;
};

}  // namespace

Json json_of_yaml(const std::string& text) { return json_of(YAML::Load(text)); }

std::string schema_problem(const Json& scene) {
  static Validator validator(session::scene_schema(plugins()));
  return validator.problem(scene);
}

std::string schema_problem(const Json& schema, const Json& scene) {
  return Validator(schema).problem(scene);
}

}  // namespace delos::test
