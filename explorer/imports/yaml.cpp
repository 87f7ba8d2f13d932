// YAML as values, by yaml-cpp.
#include <yaml-cpp/yaml.h>

#include "imports/value.h"

namespace delos::imports {
namespace {

class YamlWalk {
 public:
  explicit YamlWalk(Source& source) : source_(source) {}

  /// Aliases are written out: what refers to itself ends by the depth, what multiplies
  /// by the count.
  bool value(const YAML::Node& node, Value& out, int depth) {
    out.line = node.Mark().line + 1;
    out.column = node.Mark().column + 1;
    if (depth > kDeepest || ++count_ > kMostValues) {
      source_.error(out, "values are nested too deeply, or too many");
      return false;
    }
    if (node.IsScalar()) out.text = node.Scalar();
    if (node.IsSequence()) out.kind = Value::Kind::list;
    if (node.IsMap()) out.kind = Value::Kind::map;
    if (!node.IsSequence() && !node.IsMap()) return true;
    for (const auto& member : node) {
      const bool named = node.IsMap();
      out.members.emplace_back(
          named && member.first.IsScalar() ? member.first.Scalar() : "", Value{});
      const YAML::Node& inner = named ? member.second : member;
      if (!value(inner, out.members.back().second, depth + 1)) return false;
    }
    return true;
  }

 private:
  Source& source_;
  int count_ = 0;
};

}  // namespace

std::optional<Value> parse_yaml(std::string_view text, Source& source) {
  std::string own(text);
  // cv::FileStorage writes "%YAML:1.0", which is no directive of YAML.
  if (own.starts_with("%YAML:")) own[0] = '#';
  try {
    Value root;
    if (!YamlWalk(source).value(YAML::Load(own), root, 1)) return std::nullopt;
    return root;
  } catch (const YAML::Exception& e) {
    source.error(e.mark.is_null() ? 0 : e.mark.line + 1,
                 "isn't whole YAML: " + e.msg + "; is the file cut off?");
    return std::nullopt;
  }
}

}  // namespace delos::imports
