// Occlusion on one core: a torus of 100,352 triangles, dented so that it has no convex
// piece, in a room of 4 m. Segments from one device to a grid are how fields ask; both
// ends at random is the worst case, since every segment touches memory of its own.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <random>

#include "delos/geometry/defects.h"
#include "delos/geometry/occluders.h"
#include "delos/geometry/primitives.h"

namespace {

using namespace delos;
using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// 2·side² triangles.
TriangleMesh dented_torus(std::uint32_t side) {
  TriangleMesh mesh;
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return (i % side) * side + j % side;
  };
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const double u = 2 * std::numbers::pi * i / side,
                   v = 2 * std::numbers::pi * j / side;
      const double r = 0.5 + 0.05 * std::sin(9 * u) * std::sin(7 * v);
      mesh.vertices.emplace_back((1 + r * std::cos(v)) * std::cos(u),
                                 (1 + r * std::cos(v)) * std::sin(u), r * std::sin(v));
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

constexpr double kSkin = 1e-6;          // metres
const Vector3d kDevice(1.9, 1.8, 1.7);  // in a corner of the room

std::vector<Vector3d> random_points() {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> draw(-2, 2);
  std::vector<Vector3d> points;
  for (int i = 0; i < 200000; ++i) {
    points.emplace_back(draw(engine), draw(engine), draw(engine));
  }
  return points;
}

std::vector<Vector3d> grid_points() {
  std::vector<Vector3d> points;
  for (int k = 0; k < 60; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i)
        points.push_back(Vector3d(i, j, k) / 15 - Vector3d(2, 2, 2));
  return points;
}

/// Clutter of convex bodies, which can hide boxes as a whole.
Occluders pillars() {
  std::vector<TriangleMesh> parts;
  for (int i = 0; i < 10; ++i) {
    const double angle = 2 * std::numbers::pi * i / 10;
    parts.push_back(transformed(make_cylinder(0.25, 3),
                                Pose{.p = {std::cos(angle), std::sin(angle), -1.5}}));
  }
  return Occluders(parts);
}

/// Counts how often ask(i) is true for i in [0, count), and how fast.
template <class Ask>
void ask_all(benchmark::State& state, std::size_t count, Ask ask) {
  std::size_t yes = 0;
  for (auto _ : state) {
    yes = 0;
    for (std::size_t i = 0; i < count; ++i) yes += ask(i);
    benchmark::DoNotOptimize(yes);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
  state.counters["part_true"] = static_cast<double>(yes) / static_cast<double>(count);
}

void BM_BlocksFromADeviceToAGrid(benchmark::State& state) {
  const Occluders occluders({dented_torus(224)});
  const auto points = grid_points();
  ask_all(state, points.size(),
          [&](std::size_t i) { return occluders.blocks(kDevice, points[i], kSkin); });
}
BENCHMARK(BM_BlocksFromADeviceToAGrid)->Unit(benchmark::kMillisecond);

void BM_BlocksFromADeviceToRandomPoints(benchmark::State& state) {
  const Occluders occluders({dented_torus(224)});
  const auto points = random_points();
  ask_all(state, points.size(),
          [&](std::size_t i) { return occluders.blocks(kDevice, points[i], kSkin); });
}
BENCHMARK(BM_BlocksFromADeviceToRandomPoints)->Unit(benchmark::kMillisecond);

void BM_BlocksBetweenRandomPoints(benchmark::State& state) {
  const Occluders occluders({dented_torus(224)});
  const auto points = random_points();
  ask_all(state, points.size() - 1, [&](std::size_t i) {
    return occluders.blocks(points[i], points[i + 1], kSkin);
  });
}
BENCHMARK(BM_BlocksBetweenRandomPoints)->Unit(benchmark::kMillisecond);

AlignedBox3d cell(const Vector3d& corner) {
  return {corner, corner + Vector3d(1, 1, 1) / 15};
}

void BM_TouchesShaft(benchmark::State& state) {
  const Occluders occluders({dented_torus(224)});
  const auto points = grid_points();
  ask_all(state, points.size(), [&](std::size_t i) {
    return occluders.touches_shaft(kDevice, cell(points[i]));
  });
}
BENCHMARK(BM_TouchesShaft)->Unit(benchmark::kMillisecond);

void BM_TouchesShaftAmongPillars(benchmark::State& state) {
  const Occluders occluders = pillars();
  const auto points = grid_points();
  ask_all(state, points.size(), [&](std::size_t i) {
    return occluders.touches_shaft(kDevice, cell(points[i]));
  });
}
BENCHMARK(BM_TouchesShaftAmongPillars)->Unit(benchmark::kMillisecond);

void BM_HidesAmongPillars(benchmark::State& state) {
  const Occluders occluders = pillars();
  const auto points = grid_points();
  ask_all(state, points.size(), [&](std::size_t i) {
    return occluders.hides(kDevice, cell(points[i]), kSkin);
  });
}
BENCHMARK(BM_HidesAmongPillars)->Unit(benchmark::kMillisecond);

void BM_Contains(benchmark::State& state) {
  const Occluders occluders({dented_torus(224)});
  const auto points = random_points();
  ask_all(state, points.size(),
          [&](std::size_t i) { return occluders.contains(points[i]); });
}
BENCHMARK(BM_Contains)->Unit(benchmark::kMillisecond);

/// All of it: topology, convex pieces and tree.
void BM_Build(benchmark::State& state) {
  const TriangleMesh mesh = dented_torus(static_cast<std::uint32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(Occluders({mesh}).triangles());
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}
BENCHMARK(BM_Build)->Arg(224)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Build)->Arg(2236)->Iterations(1)->Unit(benchmark::kMillisecond);

void BM_FindDefects(benchmark::State& state) {
  const TriangleMesh mesh = dented_torus(224);
  for (auto _ : state) benchmark::DoNotOptimize(find_defects(mesh).closed);
}
BENCHMARK(BM_FindDefects)->Unit(benchmark::kMillisecond);

}  // namespace
