#include "session/shape_forms.h"

#include <algorithm>
#include <array>

#include "delos/text/units.h"

namespace delos::session {
namespace {

bool is_number(const Json& value, const char* unit) {
  return value.is_string() && std::holds_alternative<double>(parse_quantity(
                                  value.get<std::string>(), unit ? unit : "1"));
}

/// Whether a value can be of a shape, as far as the first look tells.
bool fits(const Shape& shape, const Json& value) {
  switch (shape.kind) {
    case Shape::Kind::number:
    case Shape::Kind::integer:
      return is_number(value, shape.unit);
    case Shape::Kind::numbers:
      return value.is_array() &&
             std::all_of(value.begin(), value.end(),
                         [&](const Json& v) { return is_number(v, shape.unit); });
    case Shape::Kind::list:
      return value.is_array() && (value.empty() || fits(shape.item(), value.front()));
    case Shape::Kind::map: {
      const std::vector<KeyShape> keys = shape.keys();
      return value.is_object() &&
             std::all_of(value.items().begin(), value.items().end(),
                         [&](const auto& item) { return is_one_of(keys, item.key()); });
    }
    case Shape::Kind::table:
    case Shape::Kind::parameters:
      return value.is_object();
    case Shape::Kind::either: {
      const std::vector<Shape> forms = shape.forms();
      return std::any_of(forms.begin(), forms.end(),
                         [&](const Shape& form) { return fits(form, value); });
    }
    case Shape::Kind::nothing:
      return value.is_null();
    default:
      return value.is_string();
  }
}

}  // namespace

bool is_one_of(const std::vector<KeyShape>& keys, const std::string& name) {
  return std::any_of(keys.begin(), keys.end(),
                     [&](const KeyShape& key) { return key.name == name; });
}

Shape form_of(Shape shape, const Json& value) {
  while (shape.kind == Shape::Kind::either) {
    const std::vector<Shape> forms = shape.forms();
    const auto form = std::find_if(forms.begin(), forms.end(),
                                   [&](const Shape& f) { return fits(f, value); });
    shape = form == forms.end() ? shapes::text() : *form;
  }
  return shape;
}

std::string component(const std::string& key, const Shape& shape, std::size_t i) {
  if (key == "rpy") return std::array{"roll", "pitch", "yaw"}.at(i);
  if (key == "quaternion_wxyz") return std::array{"w", "x", "y", "z"}.at(i);
  const bool coordinates = shape.unit && shape.unit == std::string_view("m");
  return coordinates && shape.most <= 3 && i < 3 ? std::string(1, "xyz"[i])
                                                 : std::to_string(i);
}

}  // namespace delos::session
