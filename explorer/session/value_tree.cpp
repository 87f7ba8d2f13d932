#include "session/value_tree.h"

#include <yaml-cpp/yaml.h>

#include <sstream>

#include "delos/scene/io.h"

namespace delos::session {
namespace {

Json value_of(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  if (node.IsSequence()) {
    Json list = Json::array();
    for (const YAML::Node& item : node) list.push_back(value_of(item));
    return list;
  }
  if (!node.IsMap()) return nullptr;
  Json map = Json::object();
  for (const auto& member : node) map[member.first.Scalar()] = value_of(member.second);
  return map;
}

const Json* member_of(const Json& value, const std::string& name) {
  if (value.is_object()) {
    const auto found = value.find(name);
    return found == value.end() ? nullptr : &*found;
  }
  for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
    if (member_name(value, i) == name) return &value[i];
  return nullptr;
}

}  // namespace

Json value_tree(const Scene& scene) { return value_of(YAML::Load(write_scene(scene))); }

std::vector<std::string> segments_of(const std::string& path) {
  std::vector<std::string> segments;
  std::istringstream parts(path);
  for (std::string part; std::getline(parts, part, '.');) segments.push_back(part);
  return segments;
}

std::string member_name(const Json& list, std::size_t index) {
  const Json& member = list[index];
  const bool named = member.is_object() && member.contains("name");
  return named ? member["name"].get<std::string>() : std::to_string(index);
}

const Json* value_at(const Json& tree, const std::string& path) {
  const Json* value = &tree;
  for (const std::string& segment : segments_of(path)) {
    value = member_of(*value, segment);
    if (!value) return nullptr;
  }
  return value;
}

}  // namespace delos::session
