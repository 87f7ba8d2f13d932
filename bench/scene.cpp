// How long a large scene takes to load: 500 devices, units on every number.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "delos/scene/io.h"
#include "delos/text/units.h"

namespace {

std::string large_scene(int devices) {
  std::string text =
      "delos: 1\nname: Large\nmotion:\n  type: position_velocity\n  state: position\n"
      "  q: [0.4 m^2/s^3, 0.4 m^2/s^3, 0.1 m^2/s^3]\n"
      "sample:\n  volume: {min: [0 m, 0 m, 0 m], max: [40 cm, 40 cm, 80 cm], step: 4 "
      "cm}\n"
      "devices:\n";
  for (int i = 0; i < devices; ++i) {
    const std::string x = delos::shortest(i * 0.25), name = "s" + std::to_string(i);
    text += "  - name: " + name + "\n    type: acoustic_range\n    rate: 50 Hz\n";
    text += "    at: [" + x + " cm, 1.5 m, 104.85 cm]\n    aim: [0 mm, 0 mm, " + x +
            " mm]\n    params: {r: 0.5 %, reach: 30 m}\n";
  }
  return text;
}

void LoadScene(benchmark::State& state) {
  const std::string text = large_scene(static_cast<int>(state.range(0)));
  delos::PluginRegistry plugins;
  for (auto _ : state) {
    delos::Diagnostics diagnostics;
    auto scene = delos::parse_scene(text, "large.yaml", {}, plugins, diagnostics);
    if (!scene) {
      state.SkipWithError(to_string(diagnostics.at(0)).c_str());
      break;
    }
    benchmark::DoNotOptimize(scene);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(LoadScene)->Arg(5)->Arg(50)->Arg(500)->Unit(benchmark::kMillisecond);

void WriteScene(benchmark::State& state) {
  delos::PluginRegistry plugins;
  delos::Diagnostics diagnostics;
  const auto scene =
      delos::parse_scene(large_scene(500), "large.yaml", {}, plugins, diagnostics);
  if (!scene) return state.SkipWithError(to_string(diagnostics.at(0)).c_str());
  for (auto _ : state) benchmark::DoNotOptimize(delos::write_scene(*scene));
}
BENCHMARK(WriteScene)->Unit(benchmark::kMillisecond);

void Quantity(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(delos::parse_quantity("104.85 cm", "m"));
}
BENCHMARK(Quantity);

}  // namespace
