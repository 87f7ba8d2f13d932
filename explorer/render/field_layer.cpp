#include "render/field_layer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "delos/text/format.h"
#include "render/isosurface.h"
#include "session/refusal.h"

namespace delos::render {
namespace {

using session::Blame;
using session::Drawn;
using session::Refusal;

/// More samples than these would hide the surface through them.
constexpr std::size_t kMostRinged = 500;

/// Samples of a parallelogram, the first direction fastest.
struct Sheet {
  Eigen::Vector3d origin, u, v;
  int nu, nv;
  std::function<std::size_t(int, int)> index;
};

class FieldPainter {
 public:
  FieldPainter(const Pen& pen, const session::DrawnField& drawn,
               const std::optional<ColourRange>& colours)
      : pen_(pen),
        drawn_(drawn),
        colours_(colours),
        blended_(drawn.field.metric != "coverage") {}

  void sheet(const Sheet& s) {
    const auto colour = [&](const Eigen::Vector3d& uv, int x, int y) {
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
      pen_.raster.line(pen_.eye, pen_.eye.seen(a), pen_.eye.seen(b), pen_.ground.lines);
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

  DrawnLevel level(const SamplePart& part, const GridShape& grid, double level) {
    const auto value = [&](std::size_t i) {
      return drawn_.mask[part.first + i] == Drawn::value
                 ? drawn_.field.value[part.first + i]
                 : std::numeric_limits<double>::quiet_NaN();
    };
    const Isosurface iso = isosurface(grid, value, level);
    const Colour colour = of_value(level);
    for (const auto& triangle : iso.mesh.triangles) {
      std::array<Corner, 3> seen;
      for (std::size_t k = 0; k < 3; ++k)
        seen[k] = {
            pen_.eye.seen(iso.mesh.vertices[triangle[k]]),
            pen_.eye.seen(iso.mesh.vertices[triangle[k]] + iso.normals[triangle[k]]) -
                pen_.eye.seen(iso.mesh.vertices[triangle[k]])};
      pen_.raster.triangle(pen_.eye, seen,
                           [&](const Eigen::Vector3d& normal, int, int) {
                             return lit(colour, light_of(normal, 0.5));
                           });
    }
    return {level, area_of(iso.mesh)};
  }

 private:
  [[nodiscard]] const Eigen::Vector3d& point(std::size_t i) const {
    return drawn_.field.samples.points[i];
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

  /// The nearest sample decides whether there is a value; values are blended between
  /// the samples that have one. Half a device sees nothing: counts aren't.
  [[nodiscard]] Colour at_sheet(const Sheet& s, double u, double v, int x,
                                int y) const {
    const double a = std::clamp(u, 0.0, 1.0) * (s.nu - 1),
                 b = std::clamp(v, 0.0, 1.0) * (s.nv - 1);
    const std::size_t nearest =
        s.index(static_cast<int>(std::lround(a)), static_cast<int>(std::lround(b)));
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

Sheet layer_of(const SamplePart& part, const GridShape& grid, const Slice& slice) {
  const int axis = slice.axis;
  const std::int64_t count = grid.counts[axis];
  const double last =
      grid.origin[axis] + static_cast<double>(count - 1) * grid.step[axis];
  const double at = slice.at.value_or((grid.origin[axis] + last) / 2);
  const double n = count > 1 ? (at - grid.origin[axis]) / grid.step[axis] : 0;
  const auto layer = static_cast<std::size_t>(
      std::clamp<double>(std::round(n), 0, static_cast<double>(count - 1)));
  const std::array<std::size_t, 3> strides{
      1, static_cast<std::size_t>(grid.counts.x()),
      static_cast<std::size_t>(grid.counts.x() * grid.counts.y())};
  const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  Sheet sheet{grid.origin,
              Eigen::Vector3d::Zero(),
              Eigen::Vector3d::Zero(),
              static_cast<int>(grid.counts[a]),
              static_cast<int>(grid.counts[b]),
              {}};
  sheet.origin[axis] += static_cast<double>(layer) * grid.step[axis];
  sheet.u[a] = static_cast<double>(grid.counts[a] - 1) * grid.step[a];
  sheet.v[b] = static_cast<double>(grid.counts[b] - 1) * grid.step[b];
  sheet.index = [=, first = part.first](int i, int j) {
    return first + layer * strides[static_cast<std::size_t>(axis)] +
           static_cast<std::size_t>(i) * strides[static_cast<std::size_t>(a)] +
           static_cast<std::size_t>(j) * strides[static_cast<std::size_t>(b)];
  };
  return sheet;
}

/// Outside the values that there are, a surface would be nowhere.
void check_level(double level, const ColourRange& colours, const std::string& unit) {
  if (level >= colours.low && level <= colours.high) return;
  throw Refusal(Blame::question, "surface '" + format_quantity(level, unit) +
                                     "': the field runs from " +
                                     format_quantity(colours.low, unit) + " to " +
                                     format_quantity(colours.high, unit));
}

}  // namespace

std::vector<DrawnLevel> draw_field_layer(const Pen& pen,
                                         const session::DrawnField& drawn,
                                         const std::optional<ColourRange>& colours,
                                         const PictureOptions& options) {
  FieldPainter painter(pen, drawn, colours);
  std::vector<DrawnLevel> levels;
  bool grid_seen = false;
  for (const SamplePart& part : drawn.field.samples.parts) {
    if (const auto* grid = std::get_if<GridShape>(&part.shape)) {
      grid_seen = true;
      for (const Slice& slice : options.slices)
        painter.sheet(layer_of(part, *grid, slice));
      for (const double level : options.levels) {
        if (!colours) continue;  // blind everywhere
        check_level(level, *colours, drawn.field.unit);
        levels.push_back(painter.level(part, *grid, level));
      }
    } else if (const auto* plane = std::get_if<PlaneShape>(&part.shape)) {
      const int nu = plane->counts.x();
      painter.sheet({plane->origin, plane->u, plane->v, nu, plane->counts.y(),
                     [first = part.first, nu](int i, int j) {
                       return first + static_cast<std::size_t>(i) +
                              static_cast<std::size_t>(j) *
                                  static_cast<std::size_t>(nu);
                     }});
    } else if (const auto* surface = std::get_if<SurfaceShape>(&part.shape)) {
      painter.surface(part, *surface);
    } else {
      painter.points(part);
    }
  }
  if (!grid_seen && !options.levels.empty())
    throw Refusal(Blame::question,
                  "surface: the scene samples no volume that one could run through");
  return levels;
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
