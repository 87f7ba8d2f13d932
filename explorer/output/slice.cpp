#include "output/slice.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "delos/text/format.h"
#include "delos/text/number_text.h"

namespace delos {
namespace {

constexpr const char* kAxisNames[] = {"x", "y", "z"};

bool is_flat_or_regular(const SamplePart& part) {
  return std::holds_alternative<GridShape>(part.shape) ||
         std::holds_alternative<PlaneShape>(part.shape);
}

bool better(double a, double b, const PictureOptions& options) {
  return options.larger_is_better ? a > b : a < b;
}

/// Index of the part's best sample; its first one where nothing is finite.
std::size_t best_sample(const Field& field, const SamplePart& part,
                        const PictureOptions& options) {
  std::optional<std::size_t> best;
  for (std::size_t i = part.first; i < part.first + part.count; ++i) {
    if (!std::isfinite(field.value[i])) continue;
    if (!best || better(field.value[i], field.value[*best], options)) best = i;
  }
  return best.value_or(part.first);
}

/// Which way to cut: the axis that is held still.
int held_axis(const GridShape& grid, const PictureOptions& options) {
  if (options.has_slice || grid.counts[2] == 1) return 2;
  if (grid.counts[0] == 1) return 0;
  if (grid.counts[1] == 1) return 1;
  return 2;
}

void take_cell(Slice& slice, const Field& field, std::size_t i) {
  slice.index.push_back(i);
  slice.value.push_back(field.value[i]);
  slice.reached.push_back(!field.cancelled || i < field.evaluated);
  slice.solid.push_back(!field.inside.empty() && field.inside[i]);
}

Slice cut(const Field& field, const SamplePart& part, const GridShape& grid,
          const PictureOptions& options) {
  const int held = held_axis(grid, options);
  const int right = held == 0 ? 1 : 0;
  const int up = held == 2 ? 1 : 2;
  const std::array<std::size_t, 3> stride = {
      1, static_cast<std::size_t>(grid.counts[0]),
      static_cast<std::size_t>(grid.counts[0] * grid.counts[1])};

  std::int64_t layer = 0;
  if (options.has_slice) {
    const double nearest =
        std::round((options.slice_z - grid.origin.z()) / grid.step.z());
    layer = static_cast<std::int64_t>(
        std::clamp(nearest, 0.0, static_cast<double>(grid.counts[2] - 1)));
  } else {
    const std::size_t best = best_sample(field, part, options) - part.first;
    layer = static_cast<std::int64_t>(best / stride[held]) % grid.counts[held];
  }

  Slice slice;
  const std::size_t first = part.first + static_cast<std::size_t>(layer) * stride[held];
  slice.place = std::string{kAxisNames[held]} + " = " +
                rounded(field.samples.points[first][held], 6) + " m";
  for (const auto& [side, from] : {std::pair{0, right}, std::pair{1, up}})
    slice.axis[side] = {kAxisNames[from], static_cast<int>(grid.counts[from]),
                        grid.origin[from], grid.step[from]};
  for (int row = 0; row < slice.axis[1].count; ++row)
    for (int column = 0; column < slice.axis[0].count; ++column)
      take_cell(slice, field, first + row * stride[up] + column * stride[right]);
  return slice;
}

/// A plane's edge as an axis. Where the edge runs along a world axis, that axis and its
/// coordinates; else the distance along the edge.
SliceAxis edge_axis(const Eigen::Vector3d& origin, const Eigen::Vector3d& edge,
                    int count, const char* name) {
  const double length = edge.norm();
  SliceAxis axis{name, count, 0, count > 1 ? length / (count - 1) : length};
  for (int i = 0; i < 3; ++i) {
    if (length == 0 || std::abs(edge[i]) < (1 - 1e-12) * length) continue;
    axis.name = kAxisNames[i];
    axis.first = std::min(origin[i], origin[i] + (count > 1 ? edge[i] : 0));
  }
  return axis;
}

/// Whether samples run against the axis they are drawn on.
bool runs_backwards(const Eigen::Vector3d& edge, const SliceAxis& axis) {
  for (int i = 0; i < 3; ++i)
    if (axis.name == kAxisNames[i]) return edge[i] < 0;
  return false;
}

/// "z = 1.2 m" for a plane square to a world axis; empty for a tilted one.
std::string plane_place(const PlaneShape& plane) {
  for (int i = 0; i < 3; ++i) {
    if (plane.u[i] == 0 && plane.v[i] == 0)
      return std::string{kAxisNames[i]} + " = " + rounded(plane.origin[i], 6) + " m";
  }
  return {};
}

Slice lay_out(const Field& field, const SamplePart& part, const PlaneShape& plane) {
  Slice slice;
  slice.place = plane_place(plane);
  slice.axis = {edge_axis(plane.origin, plane.u, plane.counts[0], "u"),
                edge_axis(plane.origin, plane.v, plane.counts[1], "v")};
  // An edge without length has no cell width of its own: make its cells square.
  for (const int side : {0, 1}) {
    if (slice.axis[side].step > 0) continue;
    const double other = slice.axis[1 - side].step;
    slice.axis[side].step = other > 0 ? other : 1;
  }
  const bool flip_u = runs_backwards(plane.u, slice.axis[0]);
  const bool flip_v = runs_backwards(plane.v, slice.axis[1]);
  for (int row = 0; row < plane.counts[1]; ++row) {
    for (int column = 0; column < plane.counts[0]; ++column) {
      const int u = flip_u ? plane.counts[0] - 1 - column : column;
      const int v = flip_v ? plane.counts[1] - 1 - row : row;
      take_cell(slice, field,
                part.first + static_cast<std::size_t>(v) * plane.counts[0] + u);
    }
  }
  return slice;
}

void find_extremes(Slice& slice, const PictureOptions& options) {
  for (std::size_t i = 0; i < slice.value.size(); ++i) {
    const double value = slice.value[i];
    if (!std::isfinite(value)) continue;
    ++slice.finite;
    if (!slice.best || better(value, slice.value[*slice.best], options)) slice.best = i;
    if (!slice.worst || better(slice.value[*slice.worst], value, options))
      slice.worst = i;
  }
}

}  // namespace

bool has_slice(const Samples& samples) {
  return std::any_of(samples.parts.begin(), samples.parts.end(), is_flat_or_regular);
}

Slice make_slice(const Field& field, const PictureOptions& options) {
  const auto part = std::find_if(field.samples.parts.begin(), field.samples.parts.end(),
                                 is_flat_or_regular);
  Slice slice;
  if (const auto* grid = std::get_if<GridShape>(&part->shape))
    slice = cut(field, *part, *grid, options);
  else
    slice = lay_out(field, *part, std::get<PlaneShape>(part->shape));
  find_extremes(slice, options);

  if (field.samples.parts.size() > 1) {
    std::string name = one_line(part->name);
    if (name.empty()) {
      name = "sample set " + std::to_string(part - field.samples.parts.begin() + 1) +
             " of " + std::to_string(field.samples.parts.size());
    }
    slice.place = slice.place.empty() ? name : name + ", " + slice.place;
  }
  return slice;
}

}  // namespace delos
