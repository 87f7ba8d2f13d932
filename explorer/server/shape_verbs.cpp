#include <cmath>
#include <limits>

#include "server/request.h"
#include "server/verbs.h"
#include "session/drawn_shapes.h"

namespace delos::server {
namespace {

constexpr std::size_t kMostShapes = 16, kMostTriangles = 4'000'000;
constexpr double kOpen = std::numeric_limits<double>::infinity();
constexpr double kFarthest = 1e6;  // metres

double finite(const Json& json, const char* key) {
  if (!json.is_number() || !std::isfinite(json.get<double>()))
    throw BadRequest("'" + std::string(key) + "' must be a finite number");
  return json.get<double>();
}

/// {axis: 0, 1 or 2, at}
shapes::AxisPlane plane_of(const Json& json) {
  const double axis = number_or(json, "axis", 2, 2);
  if (axis != 0 && axis != 1 && axis != 2) throw BadRequest("'axis' must be 0, 1 or 2");
  shapes::AxisPlane plane{static_cast<int>(axis), {}};
  if (json.contains("at")) plane.at = number_or(json, "at", 0, kFarthest, -kFarthest);
  return plane;
}

session::BetweenShape between_of(const Json& ends) {
  if (!ends.is_array() || ends.size() != 2)
    throw BadRequest("'between' must be two values, null where there is no end");
  const auto end = [&](std::size_t k, double open) {
    return ends[k].is_null() ? open : finite(ends[k], "between");
  };
  return {end(0, -kOpen), end(1, kOpen)};
}

session::ReliefShape relief_of(const Json& json) {
  session::ReliefShape shape;
  if (json.contains("axis")) shape.layer = plane_of(json);
  shape.heights = {finite(member(json, "low"), "low"),
                   finite(member(json, "high"), "high"),
                   json.contains("log10") && json["log10"] == true,
                   number_or(json, "size", 1, kFarthest, -kFarthest)};
  if (shape.heights.log10 && !(shape.heights.low > 0))
    throw BadRequest("'low' must be positive where heights follow log10");
  return shape;
}

session::FieldShape shape_of(const Json& json) {
  if (json.contains("between")) return between_of(json["between"]);
  if (json.contains("relief") && json["relief"].is_object())
    return relief_of(json["relief"]);
  if (!json.contains("level"))
    throw BadRequest("a shape must have 'level', 'between' or 'relief'");
  return session::LevelShape{finite(json["level"], "level")};
}

KeptField kept_of(const Work& work, const Json& json) {
  const std::string kind = text_or_empty(json, "of");
  const KeptField kept = work.visitor.fields.find(kind.empty() ? "field" : kind);
  if (!kept.drawn)
    throw BadRequest("'of': no such field has been drawn; ask for it first");
  return kept;
}

}  // namespace

/// {shapes: [{of, level} or {of, between: [low, high]} or {of, relief: {axis, at, low,
/// high, log10, size}}], leaves: {axis, at}}: `of` is a verb that draws a field, or
/// pinned; by default field. Relief without an axis is that of planes; leaves without
/// one, all.
Reply shapes(const Work& work) {
  const Json& list = member(work.request, "shapes");
  if (!list.is_array() || list.size() > kMostShapes)
    throw BadRequest("'shapes' must be a list of 16 at most");
  session::MadeShapes made;
  std::size_t triangles = 0;
  KeptField of = kept_of(work, list.empty() ? Json::object() : list[0]);
  for (const Json& json : list) {
    if (!json.is_object()) throw BadRequest("a shape must be an object {…}");
    const KeptField kept = kept_of(work, json);
    made.meshes.push_back(session::shapes_of(*kept.drawn, shape_of(json), work.stop));
    for (const shapes::ShapeMesh& shape : made.meshes.back())
      triangles += shape.mesh.triangles.size();
    if (*work.stop) return superseded();
    if (triangles > kMostTriangles)
      return refusal(Status::unprocessable,
                     "a shape of more than 4 million triangles isn't drawn: sample the "
                     "scene less finely");
  }
  if (work.request.contains("leaves")) {
    const Json& leaves = work.request["leaves"];
    if (!leaves.is_object()) throw BadRequest("'leaves' must be an object {…}");
    of = kept_of(work, Json::object());
    made.leaves = session::leaves_of(*of.drawn, leaves.contains("axis")
                                                    ? std::optional(plane_of(leaves))
                                                    : std::nullopt);
  }
  return {Status::ok, "application/octet-stream",
          session::packed_shapes(made, of.drawn->coarse, of.revision)};
}

}  // namespace delos::server
