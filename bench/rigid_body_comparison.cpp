// Joint against apart: the table and the pictures of docs/rigid-body-filter.md.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "delos/rigid_body/comparison.h"
#include "figures/chart.h"

namespace {

using namespace delos::rigid_body;
using delos::figures::Chart;
using delos::figures::Series;
using delos::figures::Stroke;

constexpr double kLag = 1 / 30., kSeconds = 10;
constexpr int kTuningRuns = 3, kRuns = 8;
constexpr Formulation kAll[] = {Formulation::none, Formulation::apart,
                                Formulation::joint, Formulation::joint_about_body};

/// As many as can be told from each other.
bool is_drawn(Formulation formulation, bool inertial) {
  return inertial ? formulation == Formulation::apart
                  : formulation != Formulation::none;
}

struct Mean {
  double value = 0, error = 0;
};

Mean mean_over(const std::vector<MeasuredRun>& runs, Formulation formulation,
               bool inertial, const Tuning& tuning) {
  double sum = 0, squares = 0;
  for (const MeasuredRun& run : runs) {
    const double error = pixel_error(run, formulation, inertial, tuning);
    sum += error;
    squares += error * error;
  }
  const auto n = static_cast<double>(runs.size());
  const double mean = sum / n;
  return {mean, std::sqrt((squares / n - mean * mean) / (n - 1))};
}

std::vector<MeasuredRun> runs_of(const ComparedMotion& motion, double rate,
                                 std::uint64_t first_seed, int count) {
  std::vector<MeasuredRun> runs;
  for (int i = 0; i < count; ++i)
    runs.push_back(measured_run(motion, rate, kLag, kSeconds,
                                first_seed + static_cast<std::uint64_t>(i)));
  return runs;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: bench_rigid_body_comparison FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::puts(
      "| motion, frames a second | no filter | apart | joint | joint, about the body | "
      "apart, IMU | joint, IMU | about the body, IMU |");
  std::puts("|---|---|---|---|---|---|---|---|");
  std::size_t lost = 0;
  for (const ComparedMotion& motion : compared_motions()) {
    Chart chart;
    chart.says = "Pixel error of augmented points over the rate: " + motion.name;
    chart.x_name = "frames a second";
    chart.y_name = "error [pixels]";
    for (const bool inertial : {false, true})
      for (const Formulation f : kAll)
        if (is_drawn(f, inertial))
          chart.series.push_back({std::string(to_string(f)) + (inertial ? ", IMU" : ""),
                                  Stroke::line,
                                  {}});
    for (const double rate : {30., 60., 120.}) {
      const auto tuning_runs = runs_of(motion, rate, 100, kTuningRuns),
                 runs = runs_of(motion, rate, 200, kRuns);
      for (const MeasuredRun& run : runs) lost += run.lost;
      std::printf("| %s, %g |", motion.name.c_str(), rate);
      std::size_t series = 0;
      for (const bool inertial : {false, true})
        for (const Formulation f : kAll) {
          if (inertial && f == Formulation::none) continue;
          const Mean of = mean_over(runs, f, inertial, tuned(tuning_runs, f, inertial));
          std::printf(" %.2f ± %.2f |", of.value, of.error);
          if (is_drawn(f, inertial))
            chart.series[series++].points.push_back({rate, of.value});
        }
      std::puts("");
      std::fflush(stdout);
    }
    std::string name = motion.name;
    for (char& c : name)
      if (c == ' ' || c == ',') c = '-';
    std::ofstream(folder / ("rigid-body-" + name + ".svg"))
        << delos::figures::chart_drawing(chart).str() << "\n";
  }
  std::printf("\n%zu frames without a pose\n", lost);
}
