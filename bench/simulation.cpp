// How many readings a filter takes in a second: six states, four ranges at 50 Hz.
#include <benchmark/benchmark.h>

#include "../tests/support/rigs.h"
#include "delos/simulation/simulate.h"

namespace {

using namespace delos;

const TargetPose kPose{Eigen::Matrix3d::Identity(), {0.2, 0.2, 0.4}};

/// The filter by itself, all four readings of an instant: `readings` a second.
void filter_update(benchmark::State& state) {
  const System system = testing::acoustic_system();
  const auto filter = make_filter(static_cast<FilterKind>(state.range(0)));
  const ReadingModel model(system, kPose, 6);
  TrackEstimate start{StateVector::Zero(6), kPose.R,
                      1e-3 * StateMatrix::Identity(6, 6)};
  std::vector<TrackReading> readings;
  for (int d = 0; d < 4; ++d) {
    TrackReading reading{d, 0, 0, {0, 6}, {}};
    PredictedReading predicted;
    if (!model.predict(reading, start.x, start.R, predicted)) std::abort();
    reading.z = predicted.z;
    readings.push_back(reading);
  }
  for (auto _ : state) {
    TrackEstimate estimate = start;
    benchmark::DoNotOptimize(filter->update(model, readings, estimate));
  }
  state.counters["readings"] = benchmark::Counter(
      4.0 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(filter_update)->DenseRange(0, 3);

/// All of it on one core: targets, readings, filter, errors, NEES, the bound's sums.
void whole_simulation(benchmark::State& state) {
  const System system = testing::acoustic_system();
  double readings = 0;
  for (auto _ : state) {
    const Simulation s =
        simulate(system, kPose, {.runs = 200, .seconds = 2, .threads = 1});
    readings += 4.0 * 200 * static_cast<double>(s.instants.size());
  }
  state.counters["readings"] =
      benchmark::Counter(readings, benchmark::Counter::kIsRate);
}
BENCHMARK(whole_simulation)->Unit(benchmark::kMillisecond);

}  // namespace
