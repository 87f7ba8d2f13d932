// Camera placement instances from their geometry: how many cameras see every sample,
// and the bound on it, by the time of each.
//
//     bench_cover [SECONDS] [INSTANCE]...      default: 60 s at most each, all
//
// A run ends when its count is proven, or with the time. "reached" is the time until
// the count stood, "bound at" until the bound did; "processor" the seconds of all
// threads, which a busy machine hardly stretches, until the count stood and in all.
// Both covers are judged, the stored one and ours.
#include "delos/optimize/cover.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "support/camera_placement.h"

namespace {

using namespace delos;
using Clock = std::chrono::steady_clock;

/// Seconds of the process's threads so far.
double processor() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void run(const test::CameraPlacement& instance, double seconds) {
  auto start = Clock::now();
  const CoverProblem problem = test::camera_placement(instance);
  const double built = since(start);
  const bool valid = is_cover(problem, test::stored_cover(instance));

  start = Clock::now();
  const double busy = processor();
  double reached = 0, reached_busy = 0, at_bound = 0;
  CoverProgress last;
  CoverOptions options;
  options.seconds = seconds;
  options.progress = [&](const CoverProgress& now) {
    if (now.cost < last.cost) {
      reached = since(start);
      reached_busy = processor() - busy;
    }
    if (now.bound > last.bound) at_bound = since(start);
    last = now;
  };
  const CoverAnswer answer = solve_cover(problem, options);
  std::printf("%s %7d %10d %9zu %6.1f %6d %5d %8.1f %8.1f %9.1f", instance.name,
              problem.samples, problem.candidates(), problem.seen.size(), built,
              answer.samples_left, answer.candidates_left, answer.seconds, reached,
              at_bound);
  std::printf(
      " %5.1f %5.1f %6.0f %6.0f %7d %s %s %s\n", reached_busy, processor() - busy,
      answer.cost, answer.lower_bound, instance.stored, valid ? "valid" : "INVALID",
      is_cover(problem, answer.chosen) ? "valid" : "INVALID", to_string(answer.stop));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 60;
  const std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
  std::printf(
      "      samples candidates sightings  built   left        seconds  reached  "
      "bound at   processor  count  bound  stored\n");
  for (const auto& instance : delos::test::kCameraPlacements)
    if (names.empty() ||
        std::find(names.begin(), names.end(), instance.name) != names.end())
      run(instance, seconds);
}
