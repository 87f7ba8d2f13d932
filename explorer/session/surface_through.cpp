#include "session/surface_through.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "delos/model/infinity.h"
#include "session/refusal.h"

namespace delos::session {
namespace {

constexpr const char* kAxes[3] = {"x", "y", "z"};

/// Samples as they are seen along the axis.
struct Seen {
  std::vector<std::size_t> index;  ///< among the field's
  std::vector<Eigen::Vector2d> places;
  std::vector<double> heights;  ///< along the axis
  std::vector<double> values;   ///< +∞ where there is none to draw
  Eigen::AlignedBox2d box;
  double low = kInfinity, high = -kInfinity;  ///< of the values there are
};

/// The plane's two axes, rising.
std::array<int, 2> sides_of(int axis) { return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2}; }

Seen seen_along(const DrawnField& drawn, int axis) {
  const auto [a, b] = sides_of(axis);
  Seen seen;
  for (const SamplePart& part : drawn.field.samples.parts) {
    if (!std::holds_alternative<ScatteredShape>(part.shape) &&
        !std::holds_alternative<SurfaceShape>(part.shape))
      continue;
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
      const Eigen::Vector3d& p = drawn.field.samples.points[i];
      const bool value = drawn.mask[i] == Drawn::value;
      seen.index.push_back(i);
      seen.places.emplace_back(p[a], p[b]);
      seen.heights.push_back(p[axis]);
      seen.values.push_back(value ? drawn.field.value[i] : kInfinity);
      seen.box.extend(seen.places.back());
      if (!value) continue;
      seen.low = std::min(seen.low, drawn.field.value[i]);
      seen.high = std::max(seen.high, drawn.field.value[i]);
    }
  }
  return seen;
}

void check_through(const DrawnField& drawn, const Seen& seen, const Through& through) {
  if (seen.index.empty())
    throw Refusal(Blame::question,
                  "through: the scene samples no points, path or mesh for a surface to "
                  "go through");
  if (drawn.field.metric == "coverage" &&
      through.how.method != ScatteredMethod::nearest)
    throw Refusal(
        Blame::question,
        "through: half a device sees nothing: the surface of a count is by nearest");
  if (!(seen.box.sizes().minCoeff() > 0))
    throw Refusal(Blame::question, std::string("through: seen along ") +
                                       kAxes[through.axis] +
                                       " all samples are in one line; choose another "
                                       "axis, or sample more");
}

/// Samples along the sides of a box, as far apart along the one as along the other.
Eigen::Vector2i grid_counts(const Eigen::Vector2d& size, std::size_t most) {
  const double step = std::sqrt(size.prod() / static_cast<double>(most));
  const double most_along = std::max(2.0, static_cast<double>(most) / 2);
  return (size.array() / step).round().max(1.0).min(most_along - 1).cast<int>() + 1;
}

/// Lifts places by their values.
class Relief {
 public:
  Relief(const Seen& seen, const Through& through, bool larger_is_better)
      : low_(seen.low),
        slope_(seen.high > seen.low ? through.relief / (seen.high - seen.low) : 0),
        blind_(larger_is_better ? 0 : through.relief) {}

  [[nodiscard]] double at(double value) const {
    return std::isfinite(value) ? slope_ * (value - low_) : blind_;
  }

 private:
  double low_, slope_, blind_;
};

/// The surface on its grid: some of its places have nothing.
struct Grid {
  Eigen::Vector2i counts;
  std::vector<Eigen::Vector2d> places;
  std::vector<double> values;   ///< NaN: nothing; +∞: blind
  std::vector<double> heights;  ///< along the axis
  std::vector<Drawn> mask;
};

ScatteredSurface interpolated(const Seen& seen, const std::vector<double>& values,
                              const Through& through) {
  try {
    return {seen.places, values, through.how};
  } catch (const std::invalid_argument& error) {
    throw Refusal(Blame::question, std::string("through: ") + error.what());
  }
}

Grid grid_of(const DrawnField& drawn, const Seen& seen, const Through& through) {
  const ScatteredSurface values = interpolated(seen, seen.values, through);
  const auto [least, most] = std::ranges::minmax(seen.heights);
  std::optional<ScatteredSurface> heights;
  if (most > least) heights = interpolated(seen, seen.heights, through);
  Grid grid;
  grid.counts = grid_counts(seen.box.sizes(), through.most);
  for (int j = 0; j < grid.counts.y(); ++j)
    for (int i = 0; i < grid.counts.x(); ++i) {
      // The last ones are the box's own numbers.
      const Eigen::Array2d part(static_cast<double>(i) / (grid.counts.x() - 1),
                                static_cast<double>(j) / (grid.counts.y() - 1));
      const Eigen::Vector2d p =
          (1 - part) * seen.box.min().array() + part * seen.box.max().array();
      const double value = values.at(p);
      const Drawn nearest = drawn.mask[seen.index[values.nearest(p)]];
      grid.places.push_back(p);
      grid.values.push_back(value);
      grid.heights.push_back(heights ? heights->at(p) : least);
      grid.mask.push_back(std::isfinite(value)      ? Drawn::value
                          : nearest == Drawn::value ? Drawn::blind
                                                    : nearest);
    }
  return grid;
}

/// Two triangles a cell, or one where one corner has nothing.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const Grid& grid) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    for (const std::uint32_t corner : {a, b, c})
      if (std::isnan(grid.values[corner])) return;
    triangles.push_back({a, b, c});
  };
  const auto nu = static_cast<std::uint32_t>(grid.counts.x());
  for (std::uint32_t j = 0; j + 1 < static_cast<std::uint32_t>(grid.counts.y()); ++j)
    for (std::uint32_t i = 0; i + 1 < nu; ++i) {
      const std::uint32_t a = i + j * nu, b = a + 1, c = b + nu, d = a + nu;
      if (std::isnan(grid.values[a]) || std::isnan(grid.values[c])) {
        add(a, b, d);
        add(b, c, d);
      } else {
        add(a, b, c);
        add(a, c, d);
      }
    }
  return triangles;
}

/// Samples of the surface's field, one after the other.
class Collected {
 public:
  Collected(DrawnField& to, int axis, const Relief& relief)
      : to_(to), axis_(axis), relief_(relief) {}

  std::uint32_t add(const Eigen::Vector2d& place, double height, double value,
                    Drawn drawn) {
    const auto [a, b] = sides_of(axis_);
    Eigen::Vector3d p;
    p[a] = place.x();
    p[b] = place.y();
    p[axis_] = height + relief_.at(value);
    to_.field.samples.points.push_back(p);
    to_.field.value.push_back(value);
    to_.mask.push_back(drawn);
    return static_cast<std::uint32_t>(to_.mask.size() - 1);
  }

  /// All since the last part as the next one.
  template <class Shape>
  void end_part(const char* name, Shape shape) {
    auto& parts = to_.field.samples.parts;
    const std::size_t first =
        parts.empty() ? 0 : parts.back().first + parts.back().count;
    parts.push_back({name, first, to_.mask.size() - first, std::move(shape)});
  }

 private:
  DrawnField& to_;
  int axis_;
  const Relief& relief_;
};

Json through_json(const Through& through, const Grid& grid, std::size_t samples) {
  double low = kInfinity, high = -kInfinity;
  std::size_t places = 0, blind = 0;
  for (const double value : grid.values) {
    if (std::isnan(value)) continue;
    ++places;
    if (!std::isfinite(value)) {
      ++blind;
      continue;
    }
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return {{"method", to_string(through.how.method)},
          {"over", kAxes[through.axis]},
          {"grid", {grid.counts.x(), grid.counts.y()}},
          {"samples", samples},
          {"places", places},
          {"blind", blind},
          {"min", low <= high ? Json(low) : Json()},
          {"max", low <= high ? Json(high) : Json()}};
}

}  // namespace

DrawnField surface_through(const DrawnField& drawn, const Through& through) {
  const Seen seen = seen_along(drawn, through.axis);
  check_through(drawn, seen, through);
  const Grid grid = grid_of(drawn, seen, through);

  DrawnField surface;
  surface.field.scene = drawn.field.scene;
  surface.field.metric = drawn.field.metric;
  surface.field.unit = drawn.field.unit;
  surface.field.definition = drawn.field.definition;
  surface.field.larger_is_better = drawn.field.larger_is_better;
  surface.coarse = drawn.coarse;
  surface.summary = drawn.summary;
  surface.summary["through"] = through_json(through, grid, seen.index.size());

  const Relief relief(seen, through, drawn.field.larger_is_better);
  Collected all(surface, through.axis, relief);
  auto triangles = triangles_of(grid);
  if (triangles.empty())
    throw Refusal(Blame::question,
                  std::string("through: ") + to_string(through.how.method) +
                      " says nothing at any place of the grid; a larger radius would");
  // Places that no triangle has are left out.
  std::vector<std::optional<std::uint32_t>> vertex(grid.places.size());
  for (auto& triangle : triangles)
    for (std::uint32_t& corner : triangle) {
      auto& known = vertex[corner];
      if (!known)
        known = all.add(grid.places[corner], grid.heights[corner], grid.values[corner],
                        grid.mask[corner]);
      corner = *known;
    }
  all.end_part("surface", SurfaceShape{std::move(triangles)});
  for (std::size_t k = 0; k < seen.index.size(); ++k)
    all.add(seen.places[k], seen.heights[k], seen.values[k], drawn.mask[seen.index[k]]);
  all.end_part("samples", ScatteredShape{});
  return surface;
}

}  // namespace delos::session
