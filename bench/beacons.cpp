// A HiBall under its ceiling on one core: poses a second with 26 views, and how that
// depends on the size of the ceiling, whose visible part stays the same.
#include <benchmark/benchmark.h>

#include <cmath>

#include "delos/field/evaluate.h"
#include "delos/observe/beacon_use.h"
#include "delos/scene/io.h"

namespace {

using namespace delos;

/// Head height under the middle of a square ceiling of about so many LEDs, 10 cm apart.
Scene under(const std::string& scene, double beacons) {
  const double half = 0.1 * std::round((std::sqrt(beacons) - 1) / 2);
  const auto corner = [](double x) {
    return "[" + std::to_string(x) + ", " + std::to_string(x) + ", 2.8]";
  };
  PluginRegistry plugins;
  Diagnostics diagnostics;
  const auto loaded =
      load_scene(DELOS_SCENES "/hiball/" + scene + ".yaml",
                 {{"beacons.ceiling.grid.min", corner(-half)},
                  {"beacons.ceiling.grid.max", corner(half)},
                  {"sample",
                   "{plane: {origin: [-0.5, -0.5, 1.9], u: [1, 0, 0], v: [0, 1, 0], "
                   "counts: [40, 40]}}"}},
                 plugins, diagnostics);
  if (!loaded) throw std::runtime_error("the scene doesn't load");
  return *loaded;
}

void run(benchmark::State& state, Scene scene, SightingRule rule) {
  PluginRegistry plugins;
  scene.devices[0].select = rule;
  scene.devices[0].count = rule == SightingRule::mean ? 1 : 10;
  const System system = build_system(scene, plugins);
  const Samples samples = make_samples(scene.samples);
  const Metric metric = std::get<Metric>(parse_metric("eigmax", scene.motion.layout));
  state.counters["sightings"] =
      beacon_use(system, field_poses(samples, scene.orientations)).sightings;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        evaluate_field(system, samples, scene.orientations, metric, {.threads = 1}));
  }
  state.counters["poses_per_second"] =
      benchmark::Counter(static_cast<double>(samples.points.size()) *
                             static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
  state.counters["beacons"] =
      static_cast<double>(system.devices[0].carried()->beacons->size());
}

/// The area of the published figures, from near the ceiling's middle to its corner.
void BM_PublishedArea(benchmark::State& state) {
  PluginRegistry plugins;
  Diagnostics diagnostics;
  const auto scene =
      load_scene(DELOS_SCENES "/hiball/six-lepd.yaml",
                 {{"sample.plane.counts", "[100, 100]"}}, plugins, diagnostics);
  if (!scene) throw std::runtime_error("the scene doesn't load");
  run(state, *scene, SightingRule::mean);
}
BENCHMARK(BM_PublishedArea)->Unit(benchmark::kMillisecond);

void BM_UnderTheMiddle(benchmark::State& state) {
  run(state, under("six-lepd", static_cast<double>(state.range(0))),
      SightingRule::mean);
}
BENCHMARK(BM_UnderTheMiddle)
    ->Arg(1000)
    ->Arg(5700)
    ->Arg(20000)
    ->Arg(100000)
    ->Unit(benchmark::kMillisecond);

void BM_WideField(benchmark::State& state) {
  run(state, under("six-lepd-wide", 5700), SightingRule::mean);
}
BENCHMARK(BM_WideField)->Unit(benchmark::kMillisecond);

void BM_Nearest(benchmark::State& state) {
  run(state, under("six-lepd", 5700), SightingRule::nearest);
}
BENCHMARK(BM_Nearest)->Unit(benchmark::kMillisecond);

void BM_Best(benchmark::State& state) {
  run(state, under("six-lepd", 5700), SightingRule::best);
}
BENCHMARK(BM_Best)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
