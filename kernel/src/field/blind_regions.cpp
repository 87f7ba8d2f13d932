#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

#include "delos/field/blind.h"
#include "delos/layers/layers.h"

namespace delos {
namespace {

using Join = std::function<void(std::size_t, std::size_t)>;

void join_row(const SamplePart& part, const std::vector<std::size_t>& counts,
              const Join& join) {
  std::size_t stride = 1;
  for (const std::size_t count : counts) {
    for (std::size_t i = 0; i < part.count; ++i)
      if (i / stride % count + 1 < count) join(i, i + stride);
    stride *= count;
  }
}

/// Call `join` for all neighbours of a part, by their places within it.
void join_neighbours(const SamplePart& part, const Join& join) {
  const auto size = [](auto count) { return static_cast<std::size_t>(count); };
  if (const auto* grid = std::get_if<GridShape>(&part.shape)) {
    join_row(part,
             {size(grid->counts[0]), size(grid->counts[1]), size(grid->counts[2])},
             join);
  } else if (const auto* plane = std::get_if<PlaneShape>(&part.shape)) {
    join_row(part, {size(plane->counts[0]), size(plane->counts[1])}, join);
  } else if (const auto* surface = std::get_if<SurfaceShape>(&part.shape)) {
    for (const auto& corners : surface->triangles) {
      join(corners[0], corners[1]);
      join(corners[1], corners[2]);
      join(corners[2], corners[0]);
    }
  } else if (const auto* octree = std::get_if<OctreeShape>(&part.shape)) {
    // The edges of a cell, and no diagonals.
    for (const auto& corners : octree->cells)
      for (std::size_t a = 0; a < 8; ++a)
        for (const std::size_t bit : {1u, 2u, 4u})
          if (!(a & bit)) join(corners[a], corners[a | bit]);
  }
}

bool blind(const Field& field, std::size_t i) {
  return !field.observable[i] && (field.inside.empty() || !field.inside[i]);
}

/// The blind samples in sets of neighbours.
std::vector<std::vector<std::size_t>> connected(const Field& field) {
  std::vector<std::size_t> root(field.value.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const SamplePart& part : field.samples.parts) {
    const auto join = [&](std::size_t a, std::size_t b) {
      a += part.first;
      b += part.first;
      if (!blind(field, a) || !blind(field, b)) return;
      const auto [low, high] = std::minmax({find(a), find(b)});
      root[high] = low;
    };
    join_neighbours(part, join);
    if (!std::holds_alternative<ScatteredShape>(part.shape)) continue;
    std::size_t last = part.count;
    for (std::size_t i = 0; i < part.count; ++i) {
      if (!blind(field, part.first + i)) continue;
      if (last < part.count) join(last, i);
      last = i;
    }
  }
  std::map<std::size_t, std::vector<std::size_t>> sets;
  for (std::size_t i = 0; i < field.value.size(); ++i)
    if (blind(field, i)) sets[find(i)].push_back(i);
  std::vector<std::vector<std::size_t>> regions;
  for (auto& [first, samples] : sets) regions.push_back(std::move(samples));
  std::stable_sort(regions.begin(), regions.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return regions;
}

}  // namespace

std::vector<std::vector<bool>> seen_points(const System& system,
                                           const Orientations& orientations,
                                           const std::vector<Eigen::Vector3d>& points) {
  std::vector<TargetPose> poses;
  for (const Eigen::Vector3d& rpy : orientations.rpy)
    for (const Eigen::Vector3d& p : points)
      poses.push_back({rotation_from_rpy(rpy), p});
  std::vector<std::vector<bool>> all(system.devices.size(),
                                     std::vector<bool>(points.size()));
  // Blocks are made one by one: they are read once.
  const InformationLayers layers(system, poses, {.memory_limit = 0});
  LayerBlock scratch;
  for (std::size_t b = 0; b < layers.block_count(); ++b) {
    const LayerBlock& block = layers.block(b, scratch);
    for (std::size_t d = 0; d < all.size(); ++d)
      for (int lane = 0; lane < block.lanes; ++lane)
        if (block.seen[d] >> lane & 1)
          all[d][(b * kLanes + static_cast<std::size_t>(lane)) % points.size()] = true;
  }
  return all;
}

std::vector<BlindRegion> blind_regions(const System& system,
                                       const Orientations& orientations,
                                       const Field& field) {
  System clear = system;
  clear.occluders.clear();
  clear.in_world = clear.on_target = Occluders();
  std::vector<std::vector<std::size_t>> sets = connected(field);
  std::vector<Eigen::Vector3d> points;
  for (const auto& samples : sets)
    for (const std::size_t i : samples) points.push_back(field.samples.points[i]);
  const auto sees = seen_points(system, orientations, points),
             would_see = seen_points(clear, orientations, points);

  std::vector<BlindRegion> regions;
  std::size_t first = 0;  // of the region's points
  for (std::vector<std::size_t>& samples : sets) {
    BlindRegion region;
    region.samples = std::move(samples);
    const std::size_t end = first + region.samples.size();
    region.least_lost = region.most_lost = field.lost[region.samples.front()];
    for (const std::size_t i : region.samples) {
      region.box.extend(field.samples.points[i]);
      region.least_lost = std::min<int>(region.least_lost, field.lost[i]);
      region.most_lost = std::max<int>(region.most_lost, field.lost[i]);
    }
    for (std::size_t d = 0; d < system.devices.size(); ++d) {
      RegionView view{system.devices[d].name, 0, 0, 0};
      for (std::size_t i = first; i < end; ++i)
        ++(sees[d][i] ? view.sees : would_see[d][i] ? view.hidden : view.beyond);
      region.views.push_back(std::move(view));
    }
    for (std::size_t i = first; i < end; ++i)
      region.unseen +=
          std::none_of(sees.begin(), sees.end(), [&](const auto& of) { return of[i]; });
    regions.push_back(std::move(region));
    first = end;
  }
  return regions;
}

}  // namespace delos
