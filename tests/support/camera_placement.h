// The GECCO 2020 camera placement instances, built from their geometry.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "delos/optimize/cover.h"

namespace delos::test {

/// An instance: a square room, samples on a 0.5 m grid of five layers, cameras on the
/// 0.5 m grid of the ceiling at 2.5 m, with 8 pans and 3 tilts. Data and geometry:
/// tests/data/camera-placement/README.md.
struct CameraPlacement {
  const char* name;
  int length;         ///< of the room's side, m
  double resolution;  ///< wanted, pixels per metre
  int stored;         ///< cameras of the stored solution
};

inline constexpr CameraPlacement kCameraPlacements[] = {
    {"AC_01", 5, 100, 7},  {"AC_02", 10, 100, 4}, {"AC_03", 15, 100, 3},
    {"AC_04", 20, 100, 5}, {"AC_05", 25, 100, 7}, {"AC_10", 5, 500, 20},
    {"AC_11", 10, 500, 64}};

/// Where a sample is from a camera, in steps of the grid.
struct GridOffset {
  int x, y, layer;
};

/// What a camera sees of an endless grid, pan and tilt by number: inside the frustum,
/// and no farther along the axis than 960/resolution/tan(32.5°).
inline std::vector<GridOffset> seen_offsets(int tilt, int pan, double resolution,
                                            int steps) {
  constexpr double kStep = 0.5, kCeiling = 2.5, kRounding = 1e-9;
  const double wide = std::tan(32.5 * std::numbers::pi / 180);
  const double high = wide * 1080 / 1920, reach = 960 / resolution / wide;
  const double p = pan * std::numbers::pi / 4, t = -tilt * std::numbers::pi / 4;
  const std::array forward = {std::cos(t) * std::cos(p), std::cos(t) * std::sin(p),
                              std::sin(t)};
  const std::array right = {std::sin(p), -std::cos(p), 0.0};
  const std::array up = {-std::sin(t) * std::cos(p), -std::sin(t) * std::sin(p),
                         std::cos(t)};
  std::vector<GridOffset> seen;
  for (int x = -steps; x <= steps; ++x)
    for (int y = -steps; y <= steps; ++y)
      for (int layer = 0; layer < 5; ++layer) {
        const std::array d = {kStep * x, kStep * y, kStep * layer - kCeiling};
        const auto along = [&](const std::array<double, 3>& axis) {
          return d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
        };
        const double depth = along(forward);
        if (depth > 0 && depth <= reach + kRounding &&
            std::abs(along(right)) <= depth * wide + kRounding &&
            std::abs(along(up)) <= depth * high + kRounding)
          seen.push_back({x, y, layer});
      }
  return seen;
}

/// Candidate ((ix·N + iy)·3 + tilt)·8 + pan; sample (layer·N + ix)·N + iy.
inline CoverProblem camera_placement(const CameraPlacement& instance) {
  const int n = 2 * instance.length + 1;
  std::vector<std::vector<GridOffset>> views;
  for (int tilt = 0; tilt < 3; ++tilt)
    for (int pan = 0; pan < 8; ++pan)
      views.push_back(seen_offsets(tilt, pan, instance.resolution, n - 1));
  CoverProblem problem;
  problem.samples = 5 * n * n;
  problem.demand.assign(static_cast<std::size_t>(problem.samples), 1);
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (const std::vector<GridOffset>& view : views) {
        const std::size_t first = problem.seen.size();
        for (const GridOffset& at : view) {
          const int ix = x + at.x, iy = y + at.y;
          if (ix < 0 || iy < 0 || ix >= n || iy >= n) continue;
          problem.seen.push_back((at.layer * n + ix) * n + iy);
        }
        std::sort(problem.seen.begin() + static_cast<std::ptrdiff_t>(first),
                  problem.seen.end());
        problem.start.push_back(static_cast<std::int64_t>(problem.seen.size()));
      }
  problem.cost.assign(problem.start.size() - 1, 1);
  return problem;
}

/// The stored solution: its candidates.
inline std::vector<int> stored_cover(const CameraPlacement& instance) {
  std::ifstream in(std::string(DELOS_TEST_DATA "/camera-placement/") + instance.name +
                   ".txt");
  int count = 0;
  in >> count;
  std::vector<int> cameras(static_cast<std::size_t>(count));
  for (int& camera : cameras) in >> camera;
  return cameras;
}

}  // namespace delos::test
