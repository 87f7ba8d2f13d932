// Searches of a furnished room with 8, 16 and 32 cameras, six variables each: how long
// until within 1 % of the best design that any of them found; and what a gradient
// costs.
//
//     bench_optimize [SECONDS] [CAMERAS]...      default: 60 s each, 8 16 32
//
// All methods begin at the same design, on one thread, on the same samples; every
// improvement is judged afterwards by its score on all samples, hard.
#include "delos/optimize/optimize.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "delos/scene/io.h"

namespace {

using namespace delos;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The room of scene 09 with cameras on a ring below the ceiling, looking at its
/// middle.
Scene room(int cameras, PluginRegistry& plugins) {
  Diagnostics findings;
  auto scene =
      load_scene(DELOS_SCENES "/09-camera-room.yaml",
                 {{"variables", "[]"}, {"constraints", "[]"}}, plugins, findings);
  if (!scene) throw std::runtime_error(to_string(findings.front()));
  const ParamValues lens = scene->devices.front().params;
  scene->devices.clear();
  for (int i = 0; i < cameras; ++i) {
    DeviceEntry camera;
    camera.name = "c" + std::to_string(i);
    camera.type = "pinhole_camera";
    camera.rate = 100;
    camera.params = lens;
    const double angle = 2 * std::numbers::pi * (i + 0.3) / cameras;
    camera.placement.at = {3 + 2.6 * std::cos(angle), 2.5 + 2.1 * std::sin(angle), 2.7};
    camera.placement.facing = Aim{{3, 2.5, 1}};
    scene->devices.push_back(camera);
    const double lower[] = {0.1, 0.1, 2.2}, upper[] = {5.9, 4.9, 2.9};
    const double aim_lower[] = {0.5, 0.5, 0}, aim_upper[] = {5.5, 4.5, 2};
    for (int k = 0; k < 3; ++k) {
      const std::string path = "devices." + camera.name, axis(1, "xyz"[k]);
      scene->variables.push_back(
          {path + ".at." + axis, lower[k], upper[k], ParamScale::linear, {}});
      scene->variables.push_back(
          {path + ".aim." + axis, aim_lower[k], aim_upper[k], ParamScale::linear, {}});
    }
  }
  return *scene;
}

/// Notes every improvement, and stops the search when its time is over.
class Observer final : public EvaluationLedger {
 public:
  struct Improvement {
    double seconds;
    std::size_t evaluations;  ///< of either kind, so far
    std::vector<double> x;
  };

  explicit Observer(double seconds) : limit_(seconds) {}

  bool recall(const EvaluationKey&, std::span<const double>,
              EvaluationRecord&) override {
    if (since(start_) > limit_) stop = true;
    return false;
  }
  void remember(const EvaluationKey& key, std::span<const double> x,
                const EvaluationRecord& record) override {
    ++evaluations;
    if (!record.slope.empty()) ++gradients;
    // Softer edges, and other starts, make numbers that can't be compared.
    if (record.width != width_ || key.start != of_start_)
      best_ = std::numeric_limits<double>::infinity();
    width_ = record.width;
    of_start_ = key.start;
    if (!(record.score.objective < best_)) return;
    best_ = record.score.objective;
    improvements.push_back({since(start_), evaluations, {x.begin(), x.end()}});
  }

  std::atomic<bool> stop = false;
  std::size_t evaluations = 0, gradients = 0;
  std::vector<Improvement> improvements;

 private:
  Clock::time_point start_ = Clock::now();
  int of_start_ = -1;
  double limit_, best_ = std::numeric_limits<double>::infinity(), width_ = -1;
};

struct Run {
  std::string algorithm;
  std::vector<Observer::Improvement> improvements;
  std::vector<double> dense;  ///< their scores on all samples
  double seconds = 0;
  std::size_t evaluations = 0, gradients = 0;
};

bool by_gradient(const std::string& algorithm) {
  return algorithm == "slsqp" || algorithm == "ccsa";
}

Run run(const Scene& scene, PluginRegistry& plugins, const std::string& algorithm,
        double seconds, Problem& judge) {
  Observer observer(seconds);
  OptimizeOptions options;
  options.algorithm = algorithm;
  options.starts = 8;  // as many as there is time for; global methods need one
  if (algorithm == "crs2" || algorithm == "isres") options.starts = 1;
  options.threads = 1;
  options.ledger = &observer;
  options.cancel = &observer.stop;
  if (!by_gradient(algorithm)) options.evaluations = 100'000'000;
  const auto start = Clock::now();
  const OptimizeResult result = optimize(scene, plugins, options);
  Run run{result.algorithm,
          std::move(observer.improvements),
          {},
          since(start),
          observer.evaluations,
          observer.gradients};
  for (const auto& at : run.improvements)
    run.dense.push_back(judge.score(at.x).objective);
  return run;
}

void print(const Run& run, double best, double cost) {
  std::size_t reached = 0;
  while (reached < run.dense.size() && run.dense[reached] > 1.01 * best) ++reached;
  double own = std::numeric_limits<double>::infinity();
  for (const double value : run.dense) own = std::min(own, value);
  std::printf("  %-8s best %.5g mm (%+.2f %%), %6.1f s, %7zu evaluations",
              run.algorithm.c_str(), 1e3 * own, 100 * (own / best - 1), run.seconds,
              run.evaluations);
  if (reached < run.dense.size()) {
    const auto& at = run.improvements[reached];
    const double fields =
        static_cast<double>(at.evaluations) * (run.gradients > 0 ? cost : 1);
    std::printf(";  within 1 %% after %.2f s, %.0f fields\n", at.seconds, fields);
  } else {
    std::printf(";  never within 1 %%\n");
  }
  std::fflush(stdout);
}

/// Seconds of a hard score and of a soft one with slopes; all variables move each time.
std::pair<double, double> costs(Problem& problem) {
  const std::size_t n = problem.design().size();
  std::vector<double> x = problem.design().start(), slope(n), none(1);
  double hard = 0, gradient = 0;
  constexpr int kTimes = 8;
  for (int i = -1; i < kTimes; ++i) {  // the first is to warm up
    for (double& value : x)
      value = std::min(1.0, std::max(0.0, value + (i % 2 ? 1e-3 : -1e-3)));
    auto start = Clock::now();
    (void)problem.score(x);
    if (i >= 0) hard += since(start) / kTimes;
    start = Clock::now();
    (void)problem.score_with_slopes(x, 0.03, slope.data(), none.data());
    if (i >= 0) gradient += since(start) / kTimes;
  }
  return {hard, gradient};
}

void compare(int cameras, double seconds, PluginRegistry& plugins) {
  const Scene scene = room(cameras, plugins);
  Problem judge(scene, plugins, {0, 0}), small(scene, plugins, {1500, 1});
  const auto [hard, gradient] = costs(small);
  std::printf("%d cameras, %zu variables, %zu of %zu samples\n", cameras,
              small.design().size(), small.samples(), judge.samples());
  std::printf("  a field %.2f ms, a field with the gradient %.2f ms: %.1f fields\n",
              1e3 * hard, 1e3 * gradient, gradient / hard);
  std::printf("  start    %.5g mm\n",
              1e3 * judge.score(judge.design().start()).objective);
  std::fflush(stdout);
  std::vector<Run> runs;
  for (const char* algorithm : {"slsqp", "ccsa", "cobyla", "bobyqa", "crs2", "isres"})
    runs.push_back(run(scene, plugins, algorithm, seconds, judge));
  double best = std::numeric_limits<double>::infinity();
  for (const Run& r : runs)
    for (const double value : r.dense) best = std::min(best, value);
  for (const Run& r : runs) print(r, best, gradient / hard);
}

/// What a gradient costs where 64 cameras have six variables each.
void gradient_cost(int cameras, PluginRegistry& plugins) {
  Problem problem(room(cameras, plugins), plugins, {1500, 1});
  const auto [hard, gradient] = costs(problem);
  std::printf("%d cameras: gradient over %zu variables costs %.1f fields\n", cameras,
              problem.design().size(), gradient / hard);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  PluginRegistry plugins(plugin_folders({}));
  const double seconds = argc > 1 ? std::atof(argv[1]) : 60;
  std::vector<int> cameras;
  for (int i = 2; i < argc; ++i) cameras.push_back(std::atoi(argv[i]));
  if (cameras.empty()) cameras = {8, 16, 32};
  gradient_cost(8, plugins);
  gradient_cost(64, plugins);
  for (const int count : cameras) compare(count, seconds, plugins);
}
