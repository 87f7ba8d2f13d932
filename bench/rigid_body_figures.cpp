// The figures of docs/rigid-body-filter.md, written into a folder as SVG.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "delos/rigid_body/experiments.h"
#include "figures/chart.h"

namespace {

using namespace delos::rigid_body;
using delos::figures::Chart;
using delos::figures::Series;
using delos::figures::Stroke;

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

/// The body's poses from the first on, by the true motion.
std::vector<BodyPose> poses_of(const Experiment& experiment) {
  std::vector<BodyPose> poses{{}};
  for (const BodyState& state : experiment.motion)
    poses.push_back(moved(state, experiment.dt, poses.back()));
  return poses;
}

/// The body's origin and its points e₁, e₂, e₃ after each frame, seen along y.
Chart motion_of(const Experiment& experiment) {
  Chart chart;
  chart.says = "Where the body's origin and its three points are, frame by frame";
  chart.x_name = "x";
  chart.y_name = "z";
  chart.x_unit = chart.y_unit = "m";
  chart.series = {{"e₁", Stroke::line, {}},
                  {"e₂", Stroke::line, {}},
                  {"e₃", Stroke::line, {}},
                  {"origin", Stroke::curve, {}}};
  for (const BodyPose& pose : poses_of(experiment)) {
    const BodyPoints points = unit_points(pose);
    for (std::size_t i = 0; i < 3; ++i)
      chart.series[i].points.push_back({points[i].x(), points[i].z()});
    chart.series[3].points.push_back({pose.t.x(), pose.t.z()});
  }
  return chart;
}

/// The pose of each frame as it is foretold a frame before, and as it is then.
struct Foretold {
  std::vector<Eigen::Vector3d> predicted, truth;
};

/// Σ ω Δt up to each frame, the last of its terms foretold.
Foretold rotations_of(const Experiment& experiment) {
  Foretold all;
  const auto frames = filtered(experiment);
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Eigen::Vector3d omega =
        i == 0 ? Eigen::Vector3d(0, 0, 0) : frames[i - 1].state.omega;
    all.predicted.emplace_back(turned + experiment.dt * omega);
    turned += experiment.dt * experiment.motion[i].omega;
    all.truth.push_back(turned);
  }
  return all;
}

/// The origin's place.
Foretold translations_of(const Experiment& experiment) {
  Foretold all;
  const auto frames = filtered(experiment);
  const auto poses = poses_of(experiment);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    BodyState next = i == 0 ? BodyState() : frames[i - 1].state;
    next.v += experiment.dt * next.a;
    all.predicted.push_back(moved(next, experiment.dt, poses[i]).t);
    all.truth.push_back(poses[i + 1].t);
  }
  return all;
}

Chart chart_of(const char* what, const char* unit, const Foretold& foretold) {
  Chart chart;
  chart.says = std::string(what) + " as foretold from the frame before, and as it is";
  chart.x_name = "frame";
  chart.y_name = what;
  chart.y_unit = unit;
  Series truth{"true", Stroke::dots, {}};
  for (int axis = 0; axis < 3; ++axis) {
    Series of{std::string(1, "xyz"[axis]), Stroke::line, {}};
    for (std::size_t i = 0; i < foretold.truth.size(); ++i) {
      const auto frame = static_cast<double>(i + 1);
      of.points.push_back({frame, foretold.predicted[i](axis)});
      truth.points.push_back({frame, foretold.truth[i](axis)});
    }
    chart.series.push_back(std::move(of));
  }
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
  const auto write = [&](const std::string& name, const Chart& chart) {
    std::ofstream(folder / name) << delos::figures::chart_drawing(chart).str() << "\n";
  };
  const Experiment steady = steady_motion(10), shake = shaken(steady, {}, 1),
                   turn = sudden_turn(18);
  const auto states = [&](const std::string& name, const Experiment& of) {
    write("rigid-body-" + name + "-omega.svg",
          chart_of("ω", "1/ms", &BodyState::omega, of));
    write("rigid-body-" + name + "-v.svg", chart_of("v", "m/ms", &BodyState::v, of));
    write("rigid-body-" + name + "-a.svg", chart_of("a", "m/ms²", &BodyState::a, of));
  };
  states("steady", steady);
  states("shaken", shake);
  states("turn", turn);
  write("rigid-body-steady-motion.svg", motion_of(steady));
  write("rigid-body-shaken-motion.svg", motion_of(shake));
  write("rigid-body-turn-motion.svg", motion_of(shaken(turn, {}, 1)));
  write("rigid-body-turn-rotation.svg",
        chart_of("rotation", "rad", rotations_of(turn)));
  write("rigid-body-turn-translation.svg",
        chart_of("translation", "m", translations_of(turn)));
}
