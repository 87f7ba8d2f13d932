// Fields of whole scenes, devices included, on one core; and what a moved device costs.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "delos/field/evaluate.h"
#include "delos/scene/io.h"

namespace {

using namespace delos;

Scene scene_01() {
  PluginRegistry plugins;
  Diagnostics diagnostics;
  const auto scene =
      load_scene(DELOS_SCENES "/01-acoustic.yaml", {{"sample.volume.step", "0.008"}},
                 plugins, diagnostics);
  if (!scene) throw std::runtime_error("scene 01 doesn't load");
  return *scene;
}

void report_rate(benchmark::State& state, std::size_t samples) {
  state.counters["samples_per_second"] = benchmark::Counter(
      static_cast<double>(samples) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate);
}

void BM_FieldOfScene01(benchmark::State& state) {
  const Scene scene = scene_01();
  PluginRegistry plugins;
  const System system = build_system(scene, plugins);
  const Samples samples = make_samples(scene.samples);
  const Metric metric = std::get<Metric>(parse_metric("eigmax", scene.motion.layout));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        evaluate_field(system, samples, scene.orientations, metric, {.threads = 1}));
  }
  report_rate(state, samples.points.size());
}
BENCHMARK(BM_FieldOfScene01)->Unit(benchmark::kMillisecond);

/// 64 cameras on a circle above a stage, looking at its middle.
Scene camera_ring() {
  Scene scene = scene_01();
  scene.metric = "eigmax";
  scene.devices.clear();
  ParamValues camera;
  camera.set("focal", 0.006);
  camera.set("pitch", 7.4e-6);
  camera.set("resolution", Eigen::MatrixXd(Eigen::Vector2d(640, 480)));
  camera.set("near", 0.1);
  camera.set("far", 50.0);
  camera.set("noise", std::string("pixels"));
  camera.set("sigma", 0.1);
  camera.set("r", 0.0);
  for (int i = 0; i < 64; ++i) {
    DeviceEntry entry;
    entry.name = "c" + std::to_string(i);
    entry.type = "pinhole_camera";
    entry.rate = 50;
    entry.params = camera;
    const double angle = 2 * std::numbers::pi * i / 64;
    entry.placement.at = {5 * std::cos(angle), 5 * std::sin(angle), 3};
    entry.placement.facing = Aim{{0, 0, 1}};
    scene.devices.push_back(entry);
  }
  scene.samples = {{"", VolumeSampling{{-2, -2, 0}, {2, 2, 2}, {0.1, 0.1, 0.1}}}};
  return scene;
}

// The two below belong together: their ratio is what moving a device saves.
void BM_FieldOf64CamerasFull(benchmark::State& state) {
  const Scene scene = camera_ring();
  PluginRegistry plugins;
  const System system = build_system(scene, plugins);
  const Samples samples = make_samples(scene.samples);
  const Metric metric = std::get<Metric>(parse_metric("eigmax", scene.motion.layout));
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        evaluate_field(system, samples, scene.orientations, metric, {.threads = 1}));
  }
  report_rate(state, samples.points.size());
}
BENCHMARK(BM_FieldOf64CamerasFull)->Unit(benchmark::kMillisecond);

void BM_FieldOf64CamerasAfterMovingOne(benchmark::State& state) {
  const Scene scene = camera_ring();
  PluginRegistry plugins;
  System system = build_system(scene, plugins);
  const Samples samples = make_samples(scene.samples);
  const Metric metric = std::get<Metric>(parse_metric("eigmax", scene.motion.layout));
  InformationLayers layers(system, field_poses(samples, scene.orientations),
                           {.memory_limit = std::size_t{4} << 30, .threads = 1});
  if (!layers.kept()) throw std::runtime_error("the layers don't fit");
  double step = 0.01;
  for (auto _ : state) {
    system.devices[17].X_WS().p.z() += step;
    step = -step;
    layers.update(system);
    benchmark::DoNotOptimize(
        evaluate_field(layers, samples, scene.orientations, metric, {.threads = 1}));
  }
  report_rate(state, samples.points.size());
  state.counters["layer_megabytes"] = static_cast<double>(layers.bytes()) / 1e6;
}
BENCHMARK(BM_FieldOf64CamerasAfterMovingOne)->Unit(benchmark::kMillisecond);

}  // namespace
