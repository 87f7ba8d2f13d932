#include "session/key_manual.h"

#include <cmath>
#include <deque>
#include <set>
#include <sstream>

#include "delos/scene/scene_shape.h"
#include "delos/text/units.h"

namespace delos::session {
namespace {

/// A mapping, and the way to it: "devices[].calibration".
struct Mapping {
  std::string path;
  Shape shape;
};

std::string bounds_text(const Bounds& b) {
  std::string text;
  if (std::isfinite(b.least)) text += (b.above ? ", > " : ", ≥ ") + shortest(b.least);
  if (std::isfinite(b.greatest) && b.greatest < Shape::kMany)
    text += (b.below ? ", < " : ", ≤ ") + shortest(b.greatest);
  return text;
}

std::string unit_text(const Shape& shape) {
  if (!shape.unit) return ", its unit is that of what it is about";
  return std::string(shape.unit) == "1" ? "" : std::string(", ") + shape.unit;
}

std::string count_text(const Shape& shape) {
  if (shape.most == Shape::kMany)
    return shape.least > 0 ? std::to_string(shape.least) + " or more " : "";
  if (shape.least == shape.most) return std::to_string(shape.least) + " ";
  return std::to_string(shape.least) + " to " + std::to_string(shape.most) + " ";
}

/// What a value looks like, in words; mappings in it are told elsewhere.
std::string text_of(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::number:
      return "number" + unit_text(shape) + bounds_text(shape.bounds);
    case Shape::Kind::integer:
      return "whole number" + bounds_text(shape.bounds);
    case Shape::Kind::numbers:
      return "list of " + count_text(shape) + "numbers" + unit_text(shape) +
             bounds_text(shape.bounds);
    case Shape::Kind::text:
      return "text";
    case Shape::Kind::name:
      return "name";
    case Shape::Kind::choice: {
      std::string words;
      for (const char* word : shape.words())
        words += (words.empty() ? "`" : ", `") + std::string(word) + "`";
      return words;
    }
    case Shape::Kind::list:
      return "list of " + count_text(shape) + "× " + text_of(shape.item());
    case Shape::Kind::map:
      return "mapping";
    case Shape::Kind::table:
      return "names, each with: " + text_of(shape.item());
    case Shape::Kind::parameters:
      return "the plugin's parameters";
    case Shape::Kind::either: {
      std::string forms, last;
      for (const Shape& form : shape.forms()) {
        const std::string text = text_of(form);
        if (text != last) forms += (forms.empty() ? "" : "; or ") + text;
        last = text;
      }
      return forms;
    }
    case Shape::Kind::nothing:
      return "nothing";
    case Shape::Kind::anything:
      return "as that path's";
  }
  return "";
}

/// The mappings that a value may hold, from outside inwards.
void find_mappings(const std::string& path, const Shape& shape,
                   std::deque<Mapping>& out) {
  switch (shape.kind) {
    case Shape::Kind::map:
      out.push_back({path, shape});
      break;
    case Shape::Kind::list:
      find_mappings(path + "[]", shape.item(), out);
      break;
    case Shape::Kind::table:
      find_mappings(path + ".NAME", shape.item(), out);
      break;
    case Shape::Kind::either:
      for (const Shape& form : shape.forms()) find_mappings(path, form, out);
      break;
    default:
      break;
  }
}

/// @param told what paths and keys stand in a table already, such as those of a scene
/// that another one extends
void write_table(std::ostream& out, const Mapping& mapping,
                 std::set<std::string>& told) {
  const std::string title = !mapping.path.empty() ? "`" + mapping.path + "`"
                            : told.empty()        ? "A scene"
                                                  : "A scene that extends another";
  out << "\n### " << title
      << "\n\n| key | what it looks like | meaning |\n|---|---|---|\n";
  for (const KeyShape& key : mapping.shape.keys())
    if (told.insert(mapping.path + "." + key.name).second)
      out << "| `" << key.name << "`" << (key.required ? ", required" : "") << " | "
          << text_of(key.shape) << " | " << key.help << " |\n";
}

}  // namespace

std::string key_manual() {
  std::ostringstream out;
  std::deque<Mapping> open;
  find_mappings("", scene_shape(), open);
  std::set<std::vector<KeyShape> (*)()> seen;
  std::set<std::string> told;
  for (; !open.empty(); open.pop_front()) {
    const Mapping mapping = open.front();
    if (!seen.insert(mapping.shape.keys).second) continue;
    write_table(out, mapping, told);
    for (const KeyShape& key : mapping.shape.keys())
      find_mappings(mapping.path.empty() ? key.name : mapping.path + "." + key.name,
                    key.shape, open);
  }
  return out.str();
}

}  // namespace delos::session
