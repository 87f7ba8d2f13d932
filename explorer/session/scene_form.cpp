#include "session/scene_form.h"

#include <algorithm>
#include <array>

#include "delos/scene/definition.h"
#include "delos/scene/number.h"
#include "delos/scene/scene_shape.h"
#include "delos/text/units.h"
#include "session/form_edits.h"
#include "session/names_used.h"
#include "session/search_answer.h"
#include "session/shape_forms.h"
#include "session/starts.h"
#include "session/value_tree.h"

namespace delos::session {
namespace {

/// Sections that have panels of their own, or nothing to change.
constexpr std::array kElsewhere = {"delos", "devices", "variables", "metric", "fusion"};
/// Members of a list that are shown one by one.
constexpr std::size_t kMostMembers = 60;

class Form {
 public:
  Form(const LoadedScene& loaded, PluginRegistry& plugins)
      : scene_(loaded.scene),
        plugins_(plugins),
        tree_(value_tree(scene_)),
        starts_(loaded) {}

  [[nodiscard]] Json sections() {
    Json all = Json::array();
    for (const KeyShape& key : scene_shape().forms().front().keys()) {
      if (std::find(kElsewhere.begin(), kElsewhere.end(), std::string_view(key.name)) !=
          kElsewhere.end())
        continue;
      section_ = key.name;
      const Json* value = value_at(tree_, key.name);
      if (value)
        all.push_back(field(key.shape, *value, key.name, key.name, key.help));
      else
        all.push_back(absent(key));
      if (value && !key.required) all.back()["remove"] = change("-", key.name);
    }
    return all;
  }

 private:
  static Json change(const std::string& path, const Json& value) {
    return {{"path", path}, {"value", value.is_string() ? value : Json(value.dump())}};
  }

  /// A section that there isn't: what it may begin with.
  Json absent(const KeyShape& key) {
    const Shape::Kind kind = key.shape.kind;
    Json json{
        {"path", key.name}, {"name", key.name}, {"help", key.help}, {"kind", "group"}};
    json["members"] = Json::array();
    if (kind == Shape::Kind::list || kind == Shape::Kind::table)
      json["add"] = new_members(key.shape, Json::array(), key.name);
    else if (section_ == "objective")
      json["add"] = new_members(shapes::list([] { return terms_item(); }),
                                Json::array(), "objective.terms");
    else
      json["add"] = Json::array({offer(key, key.name)});
    return json;
  }

  /// What the members of `objective.terms` look like.
  static Shape terms_item() {
    for (const KeyShape& key : scene_shape().forms().front().keys()) {
      if (key.name != std::string_view("objective")) continue;
      for (const Shape& form : key.shape.forms())
        for (const KeyShape& inner : form.keys())
          if (inner.name == std::string_view("terms")) return inner.shape.item();
    }
    return shapes::anything();
  }

  Json offer(const KeyShape& key, const std::string& path) const {
    Json json = change(path, starts_.value(key.shape, key.name));
    json["label"] = key.name;
    json["help"] = key.help;
    return json;
  }

  Json field(Shape shape, const Json& value, const std::string& path,
             const std::string& name, const char* help) {
    shape = form_of(shape, value);
    Json json{{"path", path}, {"name", name}, {"help", help}};
    switch (shape.kind) {
      case Shape::Kind::number:
      case Shape::Kind::integer:
        number_field(json, shape, value);
        break;
      case Shape::Kind::choice:
        json["kind"] = "choice";
        json["value"] = value;
        json["words"] = Json::array();
        for (const char* word : shape.words()) json["words"].push_back(word);
        break;
      case Shape::Kind::numbers:
      case Shape::Kind::list:
        list_group(json, shape, value);
        break;
      case Shape::Kind::map:
        map_group(json, shape, value);
        break;
      case Shape::Kind::table:
        table_group(json, shape, value);
        break;
      default:
        json["kind"] = "text";
        json["value"] = value.is_string() ? value : Json(value.dump());
        json["known"] = names_for(scene_, tree_, section_, name);
    }
    return json;
  }

  /// Of a number that only the rest of the scene gives a unit, what is known of it.
  void number_field(Json& json, const Shape& shape, const Json& value) {
    std::string unit = shape.unit ? shape.unit : "";
    double lower = shape.bounds.least, upper = shape.bounds.greatest;
    const std::string path = json["path"];
    if (!shape.unit) {
      const auto found = find_number(scene_, path, plugins_);
      if (const auto* known = std::get_if<SceneNumber>(&found)) {
        unit = known->unit;
        lower = std::max(lower, known->lower);
        upper = std::min(upper, known->upper);
      } else {
        unit = unit_of_limit(path);
      }
    }
    const auto read = parse_quantity(value.get<std::string>(), unit);
    json["kind"] = shape.kind == Shape::Kind::integer ? "integer" : "number";
    json["value"] =
        std::holds_alternative<double>(read) ? number(std::get<double>(read)) : Json();
    json["unit"] = unit;
    json["lower"] = number(lower);
    json["upper"] = number(upper);
  }

  /// "constraints.NAME.below", "objective.terms.0.limit"
  [[nodiscard]] std::string unit_of_limit(const std::string& path) const {
    const std::vector<std::string> parts = segments_of(path);
    if (section_ == "constraints")
      for (const ConstraintEntry& entry : scene_.constraints)
        if (parts.size() > 1 && entry.name == parts[1])
          return constraint_unit(entry, scene_);
    if (section_ == "objective" && parts.size() > 2) {
      const std::size_t term = std::stoul(parts[2]);
      const std::string& metric = scene_.objective.terms.at(term).metric;
      return std::get<Metric>(parse_metric(metric.empty() ? scene_.metric : metric,
                                           known_metrics(scene_)))
          .unit;
    }
    return "1";
  }

  void map_group(Json& json, const Shape& shape, const Json& value) {
    json["kind"] = "group";
    Json members = Json::array(), add = Json::array();
    const std::string path = json["path"];
    for (const KeyShape& key : shape.keys()) {
      const std::string inner = path + '.' + key.name;
      const auto there = value.find(key.name);
      if (there == value.end()) {
        add.push_back(offer(key, inner));
        continue;
      }
      if (key.name == std::string_view("name") && path != section_) continue;
      members.push_back(field(key.shape, *there, inner, key.name, key.help));
      if (!key.required) members.back()["remove"] = change(path + ".-", key.name);
    }
    // A single sample set is a section, and a list of one.
    if (section_ == "sample" && path == "sample") offer_sets(add);
    json["members"] = std::move(members);
    json["add"] = std::move(add);
  }

  void offer_sets(Json& add) const {
    Json first = tree_["sample"];
    if (!first.contains("name")) first["name"] = "all";
    for (const Starts::Member& set :
         starts_.members(scene_shape_of("sample").forms().front(), "sample")) {
      Json second = {{"name", free_among({first["name"]}, set.label)}};
      second.update(set.value);
      Json offered = change("sample", Json::array({first, second}));
      offered["label"] = "one more set: " + set.label;
      offered["help"] = "then the set that there is gets a name";
      add.push_back(std::move(offered));
    }
  }

  static Shape scene_shape_of(std::string_view section) {
    for (const KeyShape& key : scene_shape().forms().front().keys())
      if (key.name == section) return key.shape;
    return shapes::anything();
  }

  void list_group(Json& json, const Shape& shape, const Json& value) {
    const std::string path = json["path"], key = json["name"], help = json["help"];
    if (value.size() > kMostMembers) {
      json["kind"] = "many";
      json["value"] = value.size();
      return;
    }
    const bool single = shape.kind == Shape::Kind::numbers;
    const Shape item = single ? shapes::number(shape.unit, shape.bounds) : shape.item();
    json["kind"] = "group";
    json["members"] = Json::array();
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string name =
          single ? component(key, shape, i) : member_name(value, i);
      Json member = field(item, value[i], path + '.' + name, name, help.c_str());
      if (value.size() > static_cast<std::size_t>(std::max(shape.least, 1)) ||
          (path == section_ && shape.least == 0 && value.size() > 1))
        member["remove"] = change(path + ".-", name);
      else if (path == section_ && shape.least == 0)
        member["remove"] = change("-", section_);
      if (value[i].is_object()) may_be_copied(member, path, value[i].contains("name"));
      json["members"].push_back(std::move(member));
    }
    json["add"] = static_cast<int>(value.size()) < shape.most && !single
                      ? new_members(shape, value, path)
                      : Json::array();
  }

  void table_group(Json& json, const Shape& shape, const Json& value) {
    // Names that are paths themselves, as of a sum's factors, lead nowhere by one.
    bool dotted = false;
    for (const auto& [name, inner] : value.items())
      dotted |= name.find('.') != std::string::npos;
    if (dotted) {
      json["kind"] = "text";
      json["value"] = value.dump();
      return;
    }
    const std::string path = json["path"], help = json["help"];
    json["kind"] = "group";
    json["members"] = Json::array();
    for (const auto& [name, inner] : value.items()) {
      Json member = field(shape.item(), inner, path + '.' + name, name, help.c_str());
      member["remove"] = path == section_ && value.size() == 1
                             ? change("-", section_)
                             : change(path + ".-", name);
      may_be_copied(member, path, true);
      json["members"].push_back(std::move(member));
    }
    json["add"] = new_members(shape, value, path);
  }

  /// Members of sections are what can be called and copied.
  void may_be_copied(Json& member, const std::string& list, bool named) const {
    member["copy"] = list == section_ || list == "objective.terms";
    member["rename"] = named && list == section_;
  }

  Json new_members(const Shape& shape, const Json& there,
                   const std::string& path) const {
    const bool table = shape.kind == Shape::Kind::table;
    std::vector<std::string> names;
    if (there.is_object())
      for (const auto& [name, member] : there.items()) names.push_back(name);
    for (std::size_t i = 0; there.is_array() && i < there.size(); ++i)
      names.push_back(member_name(there, i));
    const Shape item = shape.item();
    const bool named = item.kind == Shape::Kind::map && is_one_of(item.keys(), "name");
    Json add = Json::array();
    for (const Starts::Member& member : starts_.members(item, path)) {
      const std::string like = member.label.empty() ? section_ : member.label;
      const std::string name = free_among(names, like);
      Json value = member.value;
      if (named && !table) {
        value = {{"name", name}};
        value.update(member.value);
      }
      Json offered = change(table ? path + '.' + name : path + ".+", value);
      offered["label"] = like;
      offered["help"] = "one more";
      add.push_back(std::move(offered));
    }
    return add;
  }

  Scene scene_;
  PluginRegistry& plugins_;
  Json tree_;
  Starts starts_;
  std::string section_;  ///< that is being made
};

}  // namespace

Json scene_form(const LoadedScene& loaded, PluginRegistry& plugins) {
  return {{"sections", Form(loaded, plugins).sections()}};
}

}  // namespace delos::session
