// GeoJSON: RFC 7946. A ring repeats its first point; rings after a polygon's first are
// holes. Points are longitudes and latitudes by the standard, and metres in many a
// plan.
#include <cmath>
#include <numbers>

#include "delos/text/words.h"
#include "imports/floor_plan.h"

namespace delos::imports {
namespace {

constexpr double kEarth = 6378137;  // WGS 84's equatorial radius, metres

class GeoJson {
 public:
  GeoJson(std::vector<Outline>& out, Source& source) : out_(out), source_(source) {}

  void object(const Value& value, int depth) {
    const std::string type = text_or_empty(value, "type");
    const char* inner = type == "FeatureCollection"    ? "features"
                        : type == "GeometryCollection" ? "geometries"
                                                       : nullptr;
    if (inner != nullptr && value.find(inner) && depth < 8) {
      for (const auto& [name, each] : value.find(inner)->members)
        object(each, depth + 1);
    } else if (type == "Feature" && value.find("geometry")) {
      name_ = "";
      height_ = 0;
      if (const Value* properties = value.find("properties")) {
        name_ = text_or_empty(*properties, "name");
        const Value* height = properties->find("height");
        const auto metres = height ? numbers_in(*height) : std::nullopt;
        if (metres && metres->size() == 1 && (*metres)[0] > 0) height_ = (*metres)[0];
      }
      object(*value.find("geometry"), depth + 1);
    } else if (type == "Polygon" || type == "MultiPolygon") {
      if (const Value* rings = value.find("coordinates"))
        for (const auto& [name, each] : rings->members)
          type == "Polygon" ? ring(each) : polygon(each);
    } else {
      ++left_out_;
    }
  }

  [[nodiscard]] std::size_t left_out() const { return left_out_; }

 private:
  void polygon(const Value& rings) {
    for (const auto& [name, each] : rings.members) ring(each);
  }

  void ring(const Value& points) {
    Outline outline{name_, {}, height_};
    for (const auto& [name, each] : points.members) {
      const auto p = numbers_in(each);
      if (!p || p->size() < 2) {
        source_.error(each, "a point must be [x, y]");
        return;
      }
      outline.corners.emplace_back((*p)[0], (*p)[1]);
    }
    if (outline.corners.size() > 1 && outline.corners.front() == outline.corners.back())
      outline.corners.pop_back();
    if (outline.corners.size() < 3) {
      source_.error(points, "a ring has three different points or more");
      return;
    }
    out_.push_back(std::move(outline));
  }

  std::vector<Outline>& out_;
  Source& source_;
  std::string name_;
  double height_ = 0;
  std::size_t left_out_ = 0;
};

/// Points of one building on the globe are within a fiftieth of a degree.
bool is_geographic(const std::vector<Outline>& outlines) {
  Eigen::AlignedBox2d box;
  for (const Outline& outline : outlines)
    for (const Eigen::Vector2d& p : outline.corners) box.extend(p);
  return !box.isEmpty() && box.sizes().maxCoeff() < 0.02 && box.min().x() >= -180 &&
         box.max().x() <= 180 && box.min().y() >= -90 && box.max().y() <= 90;
}

}  // namespace

bool is_geojson(const Value& root) {
  const std::string type = text_or_empty(root, "type");
  return type == "FeatureCollection" || type == "Feature" || type == "Polygon" ||
         type == "MultiPolygon" || type == "GeometryCollection";
}

std::vector<Outline> geojson_outlines(const Value& root, const ImportOptions& options,
                                      Rig& rig, Source& source) {
  rig.kind = "floor plan as GeoJSON";
  std::vector<Outline> outlines;
  GeoJson reader(outlines, source);
  reader.object(root, 0);
  if (reader.left_out() > 0)
    rig.facts.push_back(counted(reader.left_out(), "geometry") +
                        " that is no polygon left out: walls are outlines here");
  if (outlines.empty()) return outlines;
  const Eigen::Vector2d origin = outlines[0].corners[0];
  const bool globe = !options.unit && is_geographic(outlines);
  const double degree = std::numbers::pi / 180 * kEarth;
  const Eigen::Vector2d scale =
      globe ? Eigen::Vector2d(degree * std::cos(origin.y() * std::numbers::pi / 180),
                              degree)
            : Eigen::Vector2d::Constant(options.unit.value_or(1));
  for (Outline& outline : outlines)
    for (Eigen::Vector2d& p : outline.corners)
      p = (globe ? Eigen::Vector2d(p - origin) : p).cwiseProduct(scale);
  rig.facts.emplace_back(globe
                             ? "longitudes and latitudes, as metres east (x) and north "
                               "(y) of the first corner"
                             : "coordinates as lengths in the floor's own frame");
  return outlines;
}

}  // namespace delos::imports
