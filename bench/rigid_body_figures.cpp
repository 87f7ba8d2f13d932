// The figures of docs/rigid-body-filter.md, written into a folder as SVG.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "delos/rigid_body/experiments.h"
#include "report/chart.h"

namespace {

using namespace delos::rigid_body;
using delos::report::Chart;
using delos::report::Series;
using delos::report::Stroke;

/// One of the three vectors of a state, axis by axis: filtered, and true as steps.
Chart chart_of(const char* what, const char* unit, Eigen::Vector3d BodyState::*part,
               const Experiment& experiment) {
  Chart chart;
  chart.says =
      std::string("The filter's ") + what + " after each frame, and the true one";
  chart.x_name = "frame";
  chart.y_name = std::string(what) + " [" + unit + "]";
  const auto frames = filtered(experiment);
  for (int axis = 0; axis < 3; ++axis) {
    Series of{std::string(1, "xyz"[axis]), Stroke::line, {}};
    for (std::size_t i = 0; i < frames.size(); ++i)
      of.points.push_back({static_cast<double>(i + 1), (frames[i].state.*part)(axis)});
    chart.series.push_back(std::move(of));
  }
  Series truth{"true", Stroke::dots, {}};
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      truth.points.push_back(
          {static_cast<double>(i + 1), (experiment.motion[i].*part)(axis)});
  chart.series.push_back(std::move(truth));
  return chart;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: bench_rigid_body_figures FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const auto write = [&](const char* name, const Chart& chart) {
    std::ofstream(folder / name) << delos::report::chart_drawing(chart).str() << "\n";
  };
  const Experiment shake = shaken(steady_motion(10), {}, 1), turn = sudden_turn(18);
  write("rigid-body-shaken-omega.svg", chart_of("ω", "1/ms", &BodyState::omega, shake));
  write("rigid-body-shaken-v.svg", chart_of("v", "m/ms", &BodyState::v, shake));
  write("rigid-body-turn-omega.svg", chart_of("ω", "1/ms", &BodyState::omega, turn));
  write("rigid-body-turn-v.svg", chart_of("v", "m/ms", &BodyState::v, turn));
  write("rigid-body-turn-a.svg", chart_of("a", "m/ms²", &BodyState::a, turn));
}
