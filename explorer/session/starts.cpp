#include "session/starts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "delos/text/units.h"
#include "session/description.h"

namespace delos::session {
namespace {

/// Forms that the members of a list may begin with: the key that tells them.
struct Forms {
  const char* place;
  std::vector<const char*> keys;
};

const std::vector<Forms>& forms() {
  static const std::vector<Forms> all = {
      {"occluders", {"box", "cylinder", "sphere", "prism"}},
      {"regions", {"box", "cylinder", "sphere", "prism"}},
      {"sample", {"volume", "plane", "points", "path"}},
      {"surfaces", {"patch", "rail"}},
      {"beacons", {"grid", "list"}},
      {"constraints", {"metric", "inside", "outside", "spacing", "tilt", "clear"}},
      {"groups", {"at"}},
      {"motions", {"named"}},
      {"common_errors", {"place", "orientation", "offset", "scale"}},
  };
  return all;
}

/// Three digits are enough to begin with.
std::string text(double x) {
  if (x == 0) return "0";
  const double digit = std::pow(10, std::floor(std::log10(std::abs(x))) - 2);
  return shortest(std::round(x / digit) * digit);
}

Json list(const Eigen::Vector3d& v) {
  return {shortest(v.x()), shortest(v.y()), shortest(v.z())};
}

/// To a millimetre.
Eigen::Vector3d rounded(const Eigen::Vector3d& v) {
  return (v * 1e3).array().round() / 1e3;
}

/// A number that bounds hold, 1 where they can.
double number_in(const Bounds& b) {
  for (const double x : {1.0, 0.0, b.least, b.greatest, (b.least + b.greatest) / 2})
    if (std::isfinite(x) && b.hold(x)) return x;
  return std::isfinite(b.least) ? 2 * std::abs(b.least) + 1 : 0;
}

/// The shape of what stands under a key of a mapping.
std::optional<Shape> shape_under(const Shape& shape, const std::string& name) {
  if (shape.kind != Shape::Kind::map) return std::nullopt;
  for (const KeyShape& key : shape.keys())
    if (key.name == name) return key.shape;
  return std::nullopt;
}

}  // namespace

Starts::Starts(const LoadedScene& loaded)
    : loaded_(loaded), room_(sample_box(loaded.scene)) {
  // Of planes and points, which have no height, boxes need one.
  const double least = std::max(0.1 * room_.diagonal().norm(), 1e-3);
  const Eigen::Vector3d c = room_.center();
  const Eigen::Vector3d half = room_.sizes().cwiseMax(least) / 2;
  room_ = {rounded(c - half), rounded(c + half)};
}

Json Starts::known(const std::string& key) const {
  const Eigen::Vector3d size = room_.sizes(), c = room_.center();
  const double s = size.maxCoeff();
  if (key == "min") return list(rounded(c - size / 8));
  if (key == "max") return list(rounded(c + size / 8));
  if (key == "origin") return list(rounded({room_.min().x(), room_.min().y(), c.z()}));
  if (key == "u") return list(rounded({size.x(), 0, 0}));
  if (key == "v") return list(rounded({0, size.y(), 0}));
  if (key == "at") return list(rounded(c));
  if (key == "expression") return loaded_.metric.name;
  if (key == "normal") return {"0", "0", "-1"};
  if (key == "counts") return {"9", "9"};
  if (key == "radius" || key == "height" || key == "spacing" || key == "distance")
    return text(s / 8);
  if (key == "step") return text(s / 10);
  if (key == "polygon") {
    const std::string a = text(s / 8), b = text(-s / 8);
    const auto corner = [](const std::string& x, const std::string& y) {
      return Json::array({x, y});
    };
    return Json::array({corner(b, b), corner(a, b), corner(a, a), corner(b, a)});
  }
  if (key == "points" || key == "rail" || key == "clear" || key == "list")
    return {list(room_.min()), list(room_.max())};
  return nullptr;
}

Json Starts::required(const std::vector<KeyShape>& keys) const {
  Json map = Json::object();
  for (const KeyShape& key : keys)
    if (key.required) map[key.name] = value(key.shape, key.name);
  return map;
}

Json Starts::value(const Shape& shape, const std::string& key) const {
  Json start = known(key);
  if (!start.is_null()) return start;
  switch (shape.kind) {
    case Shape::Kind::number:
    case Shape::Kind::integer:
      return shortest(number_in(shape.bounds));
    case Shape::Kind::numbers:
      return Json(static_cast<std::size_t>(std::max(shape.least, 1)),
                  shortest(number_in(shape.bounds)));
    case Shape::Kind::choice:
      return shape.words().front();
    case Shape::Kind::list:
      return Json::array({value(shape.item(), "")});
    case Shape::Kind::map:
      return required(shape.keys());
    case Shape::Kind::either:
      // A mapping says more than a file's name does.
      for (const Shape& form : shape.forms())
        if (form.kind == Shape::Kind::map) return value(form, key);
      return value(shape.forms().front(), key);
    case Shape::Kind::table:
    case Shape::Kind::parameters:
      return Json::object();
    default:
      return "";
  }
}

Json Starts::special(const std::string& place, const std::string& form) const {
  const Scene& scene = loaded_.scene;
  const std::string region = scene.regions.empty() ? "" : scene.regions.front().name;
  if (place == "constraints" && form == "metric")
    return {{"metric", loaded_.metric.name},
            {loaded_.metric.larger_is_better ? "above" : "below", "1"}};
  // All others are about devices: about all of them.
  if (place == "constraints" && (form == "inside" || form == "outside"))
    return {{form, region}, {"devices", "*"}};
  if (place == "constraints" && form == "clear")
    return {{form, known(form)}, {"distance", known("distance")}, {"devices", "*"}};
  if (place == "constraints")
    return {{form, form == "tilt" ? Json("1") : known(form)}, {"devices", "*"}};
  if (place == "sample" && form == "path")
    return {{form, {{"points", known("points")}, {"count", "50"}}}};
  if (place == "sample" && form == "volume")
    return {{form,
             {{"min", list(room_.min())},
              {"max", list(room_.max())},
              {"step", known("step")}}}};
  if (place == "beacons" && form == "grid") {
    Eigen::Vector3d low = room_.min(), high = room_.max();
    low.z() = high.z();
    return {{form, {{"min", list(low)}, {"max", list(high)}, {"step", known("step")}}},
            {"normal", known("normal")},
            {"pattern", "full"}};
  }
  return nullptr;
}

std::vector<Starts::Member> Starts::members(const Shape& item,
                                            const std::string& place) const {
  if (item.kind == Shape::Kind::either) return members(item.forms().front(), place);
  std::vector<Member> all;
  for (const Forms& known_forms : forms()) {
    if (known_forms.place != place) continue;
    for (const std::string form : known_forms.keys) {
      Json member = special(place, form);
      if (member.is_null())
        if (const auto inner = shape_under(item, form))
          member = {{form, value(*inner, form)}};
      if (member.is_null()) continue;
      const bool body = place == "occluders" || place == "regions";
      if (body && form != "box") member["at"] = known("at");
      all.push_back({form, std::move(member)});
    }
    return all;
  }
  if (place == "objective.terms")
    return {{"term",
             {{loaded_.metric.larger_is_better ? "maximize" : "minimize", "mean"}}}};
  return {{"", value(item, "")}};
}

}  // namespace delos::session
