// Drawings as floor plans: polygons, rectangles, and closed paths of straight lines. y
// grows downwards in a drawing. Transformations aren't read.
#include <cctype>

#include "imports/floor_plan.h"

namespace delos::imports {
namespace {

/// A path's straight pieces, one outline a subpath; commands M L H V Z, of both cases.
/// @returns false where it has curves, or isn't a path
bool path_outlines(std::string_view d, std::vector<Outline>& out) {
  Eigen::Vector2d at = Eigen::Vector2d::Zero(), start = at;
  std::vector<Outline> found;
  while (true) {
    const std::size_t begin = d.find_first_not_of(" \t\r\n,");
    if (begin == std::string_view::npos) break;
    const char command = d[begin];
    d.remove_prefix(begin + 1);
    const std::size_t end = std::min(d.find_first_of("MmLlHhVvZzCcSsQqTtAa"), d.size());
    Value words;
    words.text = std::string(d.substr(0, end));
    const bool none = words.text.find_first_not_of(" \t\r\n,") == std::string::npos;
    const auto v = none ? std::optional(std::vector<double>{}) : numbers_in(words);
    d.remove_prefix(end);
    const char kind =
        static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    const bool relative = kind != command, pairs = kind == 'M' || kind == 'L';
    if (std::string_view("MLHVZ").find(kind) == std::string_view::npos || !v ||
        (pairs && v->size() % 2 != 0) || (kind == 'M' && v->empty()))
      return false;
    if (kind == 'Z') at = start;
    for (std::size_t i = 0; i < v->size(); i += pairs ? 2 : 1) {
      const double x = (*v)[i];
      const Eigen::Vector2d from = relative ? at : Eigen::Vector2d::Zero().eval();
      if (pairs) at = from + Eigen::Vector2d(x, (*v)[i + 1]);
      if (kind == 'H') at.x() = from.x() + x;
      if (kind == 'V') at.y() = from.y() + x;
      if (kind == 'M' && i == 0) {
        found.emplace_back();
        start = at;
      }
      if (found.empty()) return false;
      found.back().corners.push_back(at);
    }
  }
  for (Outline& outline : found) {
    if (outline.corners.size() > 1 && outline.corners.front() == outline.corners.back())
      outline.corners.pop_back();
    if (outline.corners.size() < 3) return false;
    out.push_back(std::move(outline));
  }
  return true;
}

class SvgPlan {
 public:
  SvgPlan(std::vector<Outline>& out, Source& source) : out_(out), source_(source) {}

  void element(const Value& value) {
    for (const auto& [name, each] : value.members) {
      if (each.kind != Value::Kind::map) continue;
      if (each.find("transform"))
        source_.warning(each,
                        "its transformation isn't read; apply it in the drawing "
                        "program");
      if (name == "polygon") {
        polygon(each);
      } else if (name == "rect") {
        rectangle(each);
      } else if (name == "path") {
        if (!path_outlines(text_or_empty(each, "d"), out_))
          source_.warning(each, "a path that is open or has curves is left out");
      }
      element(each);
    }
  }

 private:
  void polygon(const Value& value) {
    const Value* points = value.find("points");
    const auto v = points ? numbers_in(*points) : std::nullopt;
    if (!v || v->size() < 6 || v->size() % 2 != 0) {
      source_.error(value, "a polygon has three points or more");
      return;
    }
    Outline outline;
    for (std::size_t i = 0; i < v->size(); i += 2)
      outline.corners.emplace_back((*v)[i], (*v)[i + 1]);
    out_.push_back(std::move(outline));
  }

  void rectangle(const Value& value) {
    const auto x = number_or(value, "x", 0, source_),
               y = number_or(value, "y", 0, source_),
               w = number(value, "width", source_),
               h = number(value, "height", source_);
    if (!x || !y || !w || !h) return;
    out_.push_back(
        {"", {{*x, *y}, {*x + *w, *y}, {*x + *w, *y + *h}, {*x, *y + *h}}, 0});
  }

  std::vector<Outline>& out_;
  Source& source_;
};

}  // namespace

bool is_svg(const Value& root) { return root.find("svg") != nullptr; }

std::vector<Outline> svg_outlines(const Value& root, const ImportOptions& options,
                                  Rig& rig, Source& source) {
  rig.kind = "floor plan as SVG";
  rig.facts.emplace_back("y of the drawing grows downwards, and is turned over");
  std::vector<Outline> outlines;
  SvgPlan(outlines, source).element(*root.find("svg"));
  const auto unit = asked_unit(options, source);
  for (Outline& outline : outlines)
    for (Eigen::Vector2d& p : outline.corners)
      p = unit.value_or(1) * Eigen::Vector2d(p.x(), -p.y());
  return outlines;
}

}  // namespace delos::imports
