#include "render/field_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "delos/text/format.h"
#include "session/drawn_shapes.h"
#include "session/refusal.h"

namespace delos::render {
namespace {

using session::Blame;
using session::Drawn;
using session::Refusal;
using shapes::Sheet;

/// More samples than these would hide the surface through them.
constexpr std::size_t kMostRinged = 500;

class FieldPainter {
 public:
  FieldPainter(const Pen& pen, const session::DrawnField& drawn,
               const std::optional<ColourRange>& colours)
      : pen_(pen),
        drawn_(drawn),
        colours_(colours),
        blended_(drawn.field.metric != "coverage") {}

  /// @param raised its values stand above it: only its blind parts are drawn
  void sheet(const Sheet& s, bool raised = false) {
    const auto colour = [&](const Eigen::Vector3d& uv, int x,
                            int y) -> std::optional<Colour> {
      if (raised && drawn_.mask[nearest(s, uv.x(), uv.y())] == Drawn::value)
        return std::nullopt;
      return at_sheet(s, uv.x(), uv.y(), x, y);
    };
    const Eigen::Vector3d o = s.origin, far = o + s.u + s.v;
    pen_.raster.triangle(pen_.eye,
                         {{{pen_.eye.seen(o), {0, 0, 0}},
                           {pen_.eye.seen(o + s.u), {1, 0, 0}},
                           {pen_.eye.seen(far), {1, 1, 0}}}},
                         colour);
    pen_.raster.triangle(pen_.eye,
                         {{{pen_.eye.seen(o), {0, 0, 0}},
                           {pen_.eye.seen(far), {1, 1, 0}},
                           {pen_.eye.seen(o + s.v), {0, 1, 0}}}},
                         colour);
    for (const auto& [a, b] : {std::pair(o, Eigen::Vector3d(o + s.u)),
                               std::pair(Eigen::Vector3d(o + s.u), far),
                               std::pair(far, Eigen::Vector3d(o + s.v)),
                               std::pair(Eigen::Vector3d(o + s.v), o)})
      line(a, b, pen_.ground.lines);
  }

  /// Lit from the eye: smooth on the surface, flat on caps.
  void shape(const shapes::ShapeMesh& shape) {
    const auto& [mesh, normals, values, caps] = shape;
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
      const auto& t = mesh.triangles[k];
      std::array<Eigen::Vector3d, 3> at;
      for (std::size_t c = 0; c < 3; ++c) at[c] = pen_.eye.seen(mesh.vertices[t[c]]);
      const Eigen::Vector3d flat = (at[1] - at[0]).cross(at[2] - at[0]).normalized();
      std::array<Corner, 3> seen;
      for (std::size_t c = 0; c < 3; ++c) {
        const Eigen::Vector3d normal = k < caps ? pen_.eye.turned(normals[t[c]]) : flat;
        seen[c] = {at[c], {normal.z(), values[t[c]], 0}};
      }
      pen_.raster.triangle(pen_.eye, seen, [&](const Eigen::Vector3d& v, int, int) {
        return lit(of_value(v.y()), 0.5 + 0.5 * std::min(1.0, std::abs(v.x())));
      });
    }
  }

  void leaves(const shapes::LeafEdges& edges) {
    for (std::size_t k = 0; k < edges.ends.size(); k += 2)
      line(edges.ends[k], edges.ends[k + 1], pen_.ground.faint);
  }

  /// @param ringed so that they are seen on what has their colour
  void points(const SamplePart& part, bool ringed = false) {
    const double radius = part.count > 2000 ? 2.5 : 4.5;
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
      const bool value = drawn_.mask[i] == Drawn::value;
      pen_.raster.disc(pen_.eye, pen_.eye.seen(point(i)), radius, !value,
                       value ? of_value(drawn_.field.value[i])
                       : drawn_.mask[i] == Drawn::inside ? pen_.ground.solid
                                                         : pen_.ground.blind);
      // What lies on one spot already stays.
      if (ringed)
        pen_.raster.disc(pen_.eye, pen_.eye.seen(point(i)), radius + 1, !value,
                         pen_.ground.lines);
    }
  }

  void surface(const SamplePart& part, const SurfaceShape& shape) {
    for (const auto& corners : shape.triangles) {
      std::array<std::size_t, 3> samples;
      std::array<Corner, 3> seen;
      for (std::size_t k = 0; k < 3; ++k) {
        samples[k] = part.first + corners[k];
        seen[k] = {pen_.eye.seen(point(samples[k])), Eigen::Vector3d::Unit(k)};
      }
      const double light = light_of(
          (seen[1].seen - seen[0].seen).cross(seen[2].seen - seen[0].seen), 0.78);
      pen_.raster.triangle(pen_.eye, seen,
                           [&](const Eigen::Vector3d& parts, int x, int y) {
                             return lit(at_corners(samples, parts, x, y), light);
                           });
    }
  }

 private:
  [[nodiscard]] const Eigen::Vector3d& point(std::size_t i) const {
    return drawn_.field.samples.points[i];
  }
  void line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Colour& colour) {
    pen_.raster.line(pen_.eye, pen_.eye.seen(a), pen_.eye.seen(b), colour);
  }
  [[nodiscard]] Colour of_value(double value) const {
    return colour_of(*colours_, value);
  }
  [[nodiscard]] Colour without_value(Drawn what, int x, int y) const {
    return what == Drawn::inside ? pen_.ground.solid : hatch(pen_.ground, x, y);
  }

  /// From the side it is darker. @param normal as the eye sees it
  [[nodiscard]] static double light_of(const Eigen::Vector3d& normal, double least) {
    const double length = normal.norm();
    return length > 0 ? least + (1 - least) * std::abs(normal.z()) / length : 1;
  }

  [[nodiscard]] static std::size_t nearest(const Sheet& s, double u, double v) {
    const auto along = [](double part, int n) {
      return static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * (n - 1)));
    };
    return s.index(along(u, s.nu), along(v, s.nv));
  }

  /// The nearest sample decides whether there is a value; values are blended between
  /// the samples that have one. Half a device sees nothing: counts aren't.
  [[nodiscard]] Colour at_sheet(const Sheet& s, double u, double v, int x,
                                int y) const {
    const double a = std::clamp(u, 0.0, 1.0) * (s.nu - 1),
                 b = std::clamp(v, 0.0, 1.0) * (s.nv - 1);
    const std::size_t nearest = this->nearest(s, u, v);
    if (drawn_.mask[nearest] != Drawn::value)
      return without_value(drawn_.mask[nearest], x, y);
    if (!blended_) return of_value(drawn_.field.value[nearest]);
    const int i = static_cast<int>(a), j = static_cast<int>(b);
    double sum = 0, weights = 0;
    for (const int dj : {0, 1})
      for (const int di : {0, 1}) {
        const std::size_t sample =
            s.index(std::min(i + di, s.nu - 1), std::min(j + dj, s.nv - 1));
        if (drawn_.mask[sample] != Drawn::value) continue;
        const double w =
            (di == 1 ? a - i : 1 - (a - i)) * (dj == 1 ? b - j : 1 - (b - j));
        sum += w * drawn_.field.value[sample];
        weights += w;
      }
    return of_value(sum / weights);
  }

  [[nodiscard]] Colour at_corners(const std::array<std::size_t, 3>& samples,
                                  const Eigen::Vector3d& parts, int x, int y) const {
    Eigen::Index nearest;
    parts.maxCoeff(&nearest);
    const auto first = samples[static_cast<std::size_t>(nearest)];
    if (drawn_.mask[first] != Drawn::value)
      return without_value(drawn_.mask[first], x, y);
    if (!blended_) return of_value(drawn_.field.value[first]);
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (drawn_.mask[samples[k]] != Drawn::value) continue;
      sum += parts[static_cast<Eigen::Index>(k)] * drawn_.field.value[samples[k]];
      weights += parts[static_cast<Eigen::Index>(k)];
    }
    return of_value(sum / weights);
  }

  const Pen& pen_;
  const session::DrawnField& drawn_;
  const std::optional<ColourRange>& colours_;
  bool blended_;
};

/// Outside the values that there are, a surface would be nowhere.
void check_level(double level, const ColourRange& colours, const std::string& unit) {
  if (level >= colours.low && level <= colours.high) return;
  throw Refusal(Blame::question, "surface '" + format_quantity(level, unit) +
                                     "': the field runs from " +
                                     format_quantity(colours.low, unit) + " to " +
                                     format_quantity(colours.high, unit));
}

/// What runs through volumes. @returns each with its area
std::vector<DrawnShape> draw_shapes(FieldPainter& painter,
                                    const session::DrawnField& drawn,
                                    const std::optional<ColourRange>& colours,
                                    const PictureOptions& options) {
  std::vector<DrawnShape> all;
  if (!colours) return all;  // blind everywhere
  const auto draw = [&](const session::FieldShape& shape, double low, double high) {
    all.push_back({low, high, 0, 0});
    for (const shapes::ShapeMesh& mesh : shapes_of(drawn, shape, nullptr)) {
      painter.shape(mesh);
      all.back().area += shapes::area_of(mesh.mesh);
      if (low < high) all.back().volume += shapes::volume_of(mesh.mesh);
    }
  };
  for (const double level : options.levels) {
    check_level(level, *colours, drawn.field.unit);
    draw(session::LevelShape{level}, level, level);
  }
  for (const auto& [low, high] : options.between)
    draw(session::BetweenShape{low, high}, low, high);
  return all;
}

/// Layers and planes, as high as their values.
void draw_reliefs(FieldPainter& painter, const session::DrawnField& drawn,
                  const std::optional<ColourRange>& colours,
                  const PictureOptions& options) {
  if (!colours || !options.reliefs) return;
  const shapes::Heights heights{colours->low, colours->high, colours->log10,
                                options.relief_height};
  const auto draw = [&](const session::FieldShape& shape) {
    for (const shapes::ShapeMesh& mesh : shapes_of(drawn, shape, nullptr))
      painter.shape(mesh);
  };
  for (const Slice& slice : options.slices) draw(session::ReliefShape{slice, heights});
  draw(session::ReliefShape{std::nullopt, heights});
}

/// Octree cells near what is sliced, or all.
void draw_leaves(FieldPainter& painter, const session::DrawnField& drawn,
                 const PictureOptions& options) {
  if (!options.cells) return;
  if (!drawn.leaves)
    throw Refusal(Blame::question,
                  "layers: there are no cells: the scene isn't sampled "
                  "adaptively");
  for (const Slice& slice : options.slices) painter.leaves(leaves_of(drawn, slice));
  if (options.slices.empty()) painter.leaves(leaves_of(drawn, std::nullopt));
}

}  // namespace

std::vector<DrawnShape> draw_field_layer(const Pen& pen,
                                         const session::DrawnField& drawn,
                                         const std::optional<ColourRange>& colours,
                                         const PictureOptions& options) {
  FieldPainter painter(pen, drawn, colours);
  bool grid_seen = false;
  for (const SamplePart& part : drawn.field.samples.parts) {
    if (const auto* grid = std::get_if<GridShape>(&part.shape)) {
      grid_seen = true;
      for (const Slice& slice : options.slices)
        painter.sheet(shapes::layer_of(part, *grid, slice), options.reliefs);
    } else if (const auto* plane = std::get_if<PlaneShape>(&part.shape)) {
      painter.sheet(shapes::sheet_of(part, *plane), options.reliefs);
    } else if (const auto* surface = std::get_if<SurfaceShape>(&part.shape)) {
      painter.surface(part, *surface);
    } else {
      painter.points(part);
    }
  }
  if (!grid_seen && !(options.levels.empty() && options.between.empty()))
    throw Refusal(Blame::question,
                  "surface: the scene samples no volume that one could run through");
  draw_leaves(painter, drawn, options);
  draw_reliefs(painter, drawn, colours, options);
  return draw_shapes(painter, drawn, colours, options);
}

void draw_through(const Pen& pen, const session::DrawnField& through,
                  const std::optional<ColourRange>& colours) {
  FieldPainter painter(pen, through, colours);
  for (const SamplePart& part : through.field.samples.parts) {
    if (const auto* surface = std::get_if<SurfaceShape>(&part.shape))
      painter.surface(part, *surface);
    else if (part.count <= kMostRinged)
      painter.points(part, true);
  }
}

}  // namespace delos::render
