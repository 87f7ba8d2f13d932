// Camera placement instances from their geometry: how many cameras see every sample,
// and the bound on it, by the time of each.
//
//     bench_cover [SECONDS] [INSTANCE]...      default: 60 s at most each, all
//     instances
//
// A run ends when its count is proven, or as low as the stored one and its bound hasn't
// risen for a fifth of the time; "reached" is the time until the count stood.
#include "delos/optimize/cover.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/camera_placement.h"

namespace {

using namespace delos;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void run(const test::CameraPlacement& instance, double seconds) {
  auto start = Clock::now();
  const CoverProblem problem = test::camera_placement(instance);
  const double built = since(start);
  const bool valid = is_cover(problem, test::stored_cover(instance));

  start = Clock::now();
  double reached = 0, at_bound = 0;
  CoverProgress last;
  std::atomic<bool> cancel = false;
  CoverOptions options;
  options.seconds = seconds;
  options.cancel = &cancel;
  options.progress = [&](const CoverProgress& now) {
    if (now.cost < last.cost) reached = since(start);
    if (now.bound > last.bound) at_bound = since(start);
    last = now;
  };
  const CoverAnswer answer = solve_cover(problem, options);
  std::printf(
      "%s  %6d  %6d  %9zu  %5.1f  %5d  %5d  %5.1f  %5.1f  %5.1f  %4.0f  %4.0f  ",
      instance.name, problem.samples, problem.candidates(), problem.seen.size(), built,
      answer.samples_left, answer.candidates_left, answer.seconds, reached, at_bound,
      answer.cost, answer.lower_bound);
  std::printf("%4d %s  %s  %s\n", instance.stored, valid ? "valid" : "INVALID",
              is_cover(problem, answer.chosen) ? "valid" : "INVALID",
              to_string(answer.stop));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 60;
  const std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
  std::printf(
      "        samples  candidates  sightings  built  left         seconds  "
      "reached  bound at  count  bound  stored\n");
  for (const auto& instance : delos::test::kCameraPlacements)
    if (names.empty() ||
        std::find(names.begin(), names.end(), instance.name) != names.end())
      run(instance, seconds);
}
