// Searches of a furnished room with 8, 16 and 32 cameras, six variables each: how long
// until near the best design that any of them found; and what a gradient costs, where a
// camera may fail too.
//
//     bench_optimize [MULTIPLE] [BEGINS] [CAMERAS]...      default: 6, 3, 8 16 32
//
// All methods begin at the same designs, on one thread, on the same samples; every
// improvement is judged afterwards by its score on all samples, hard. The time to come
// within 10, 5, 2 and 1 % of the best is the expected one of a search that is begun
// anew until it comes there: all that was spent over the begins that came there (Hansen
// et al., COCO, 2021). Seconds are those that the processor spent on this process, so
// that others on the machine don't count. The gradient searches run to their ends; then
// each of the others runs from each begin MULTIPLE times as long as the default one
// expects to come within 5 % of its own best.
#include "delos/optimize/optimize.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "delos/scene/io.h"

namespace {

using namespace delos;
/// Seconds that the processor has spent on this process.
double spent() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The room of scene 09 with cameras anywhere below the ceiling, looking anywhere; the
/// first begin has them on a ring instead, looking at the room's middle.
Scene room(int cameras, int begin, PluginRegistry& plugins) {
  Diagnostics findings;
  auto scene =
      load_scene(DELOS_SCENES "/09-camera-room.yaml",
                 {{"variables", "[]"}, {"constraints", "[]"}}, plugins, findings);
  if (!scene) throw std::runtime_error(to_string(findings.front()));
  const ParamValues lens = scene->devices.front().params;
  scene->devices.clear();
  std::mt19937_64 random(static_cast<std::uint64_t>(begin));
  const auto between = [&](double lower, double upper) {
    return lower + (upper - lower) * 0x1p-53 * static_cast<double>(random() >> 11);
  };
  for (int i = 0; i < cameras; ++i) {
    DeviceEntry camera;
    camera.name = "c" + std::to_string(i);
    camera.type = "pinhole_camera";
    camera.rate = 100;
    camera.params = lens;
    const double angle = 2 * std::numbers::pi * (i + 0.3) / cameras;
    Eigen::Vector3d at(3 + 2.6 * std::cos(angle), 2.5 + 2.1 * std::sin(angle), 2.7),
        aim(3, 2.5, 1);
    const double lower[] = {0.1, 0.1, 2.2}, upper[] = {5.9, 4.9, 2.9};
    const double aim_lower[] = {0.5, 0.5, 0}, aim_upper[] = {5.5, 4.5, 2};
    for (int k = 0; k < 3; ++k) {
      if (begin > 0) {
        at[k] = between(lower[k], upper[k]);
        aim[k] = between(aim_lower[k], aim_upper[k]);
      }
      const std::string path = "devices." + camera.name, axis(1, "xyz"[k]);
      scene->variables.push_back(
          {path + ".at." + axis, lower[k], upper[k], ParamScale::linear, {}});
      scene->variables.push_back(
          {path + ".aim." + axis, aim_lower[k], aim_upper[k], ParamScale::linear, {}});
    }
    camera.placement.at = at;
    camera.placement.facing = Aim{aim};
    scene->devices.push_back(camera);
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
    if (spent() - start_ > limit_) stop = true;
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
    improvements.push_back({spent() - start_, evaluations, {x.begin(), x.end()}});
  }

  std::atomic<bool> stop = false;
  std::size_t evaluations = 0, gradients = 0;
  std::vector<Improvement> improvements;

 private:
  double start_ = spent();
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

constexpr double kForever = std::numeric_limits<double>::infinity();

Run run(const Scene& scene, PluginRegistry& plugins, const std::string& algorithm,
        double seconds, Problem& judge) {
  Observer observer(seconds);
  OptimizeOptions options;
  options.algorithm = algorithm;
  options.threads = 1;
  options.ledger = &observer;
  options.cancel = &observer.stop;
  if (seconds < kForever) {
    // As many starts as there is time for; global methods need one.
    options.starts = algorithm == "crs2" || algorithm == "isres" ? 1 : 16;
    options.evaluations = 100'000'000;
  }
  const double start = spent();
  const OptimizeResult result = optimize(scene, plugins, options);
  Run run{result.algorithm,
          std::move(observer.improvements),
          {},
          spent() - start,
          observer.evaluations,
          observer.gradients};
  for (const auto& at : run.improvements)
    run.dense.push_back(judge.score(at.x).objective);
  return run;
}

double best_of(const Run& run) {
  return *std::min_element(run.dense.begin(), run.dense.end());
}

/// The first improvement down to a value; null: none.
const Observer::Improvement* reaching(const Run& run, double value) {
  for (std::size_t i = 0; i < run.dense.size(); ++i)
    if (run.dense[i] <= value) return &run.improvements[i];
  return nullptr;
}

/// A method from all begins.
using Runs = std::vector<Run>;

double best_of(const Runs& runs) {
  double best = kForever;
  for (const Run& run : runs) best = std::min(best, best_of(run));
  return best;
}

/// What all begins spent until they came down to a value, or to their ends.
struct Expected {
  double spent = 0, fields = 0;
  int came = 0;
  [[nodiscard]] double seconds() const { return came > 0 ? spent / came : kForever; }
};

/// @param cost of an evaluation, in fields
Expected expected(const Runs& runs, double value, double cost) {
  Expected sum;
  for (const Run& run : runs) {
    const auto* at = reaching(run, value);
    sum.came += at ? 1 : 0;
    sum.spent += at ? at->seconds : run.seconds;
    sum.fields += cost * static_cast<double>(at ? at->evaluations : run.evaluations);
  }
  return sum;
}

/// @param own the default search
void print(const Runs& runs, const Runs& own, double best, double cost) {
  std::printf("  %s ends", runs.front().algorithm.c_str());
  for (const Run& run : runs)
    std::printf(" %.1f %%%s", 100 * (best_of(run) / best - 1),
                &run == &runs.back() ? " above the best" : ",");
  std::printf(" after %.0f s\n", runs.back().seconds);
  for (const int percent : {10, 5, 2, 1}) {
    const double value = (1 + 0.01 * percent) * best;
    const Expected all = expected(runs, value, cost);
    const double first = expected(own, value, cost).seconds();
    if (all.came > 0)
      std::printf("    within %2d %%: %8.2f s, %7.0f fields, %d of %zu: %.1f times\n",
                  percent, all.seconds(), all.fields / all.came, all.came, runs.size(),
                  all.seconds() / first);
    else
      std::printf("    within %2d %%: never in %.0f s: > %.1f times\n", percent,
                  all.spent, all.spent / first);
  }
  std::fflush(stdout);
}

/// Seconds of a hard score and of a soft one with slopes; all variables move each time.
std::pair<double, double> costs(Problem& problem) {
  const std::size_t n = problem.design().size();
  std::vector<double> x = problem.design().start(), slope(n), none(1);
  double hard = 0, gradient = 0;
  constexpr int kTimes = 24;
  for (int i = -1; i < kTimes; ++i) {  // the first is to warm up
    for (double& value : x)
      value = std::min(1.0, std::max(0.0, value + (i % 2 ? 1e-3 : -1e-3)));
    double start = spent();
    (void)problem.score(x);
    if (i >= 0) hard += (spent() - start) / kTimes;
    start = spent();
    (void)problem.score_with_slopes(x, 0.03, slope.data(), none.data());
    if (i >= 0) gradient += (spent() - start) / kTimes;
  }
  return {hard, gradient};
}

void compare(int cameras, double multiple, int begins, PluginRegistry& plugins) {
  std::vector<Scene> scenes;
  for (int k = 0; k < begins; ++k) scenes.push_back(room(cameras, k, plugins));
  Problem judge(scenes[0], plugins, {0, 0}), small(scenes[0], plugins, {1500, 1});
  const auto [hard, gradient] = costs(small);
  std::printf("%d cameras, %zu variables, %zu of %zu samples\n", cameras,
              small.design().size(), small.samples(), judge.samples());
  std::printf("  a field %.2f ms, a field with the gradient %.2f ms: %.1f fields\n",
              1e3 * hard, 1e3 * gradient, gradient / hard);
  std::fflush(stdout);
  const auto from_all = [&](const char* algorithm, double limit) {
    Runs runs;
    for (const Scene& scene : scenes)
      runs.push_back(run(scene, plugins, algorithm, limit, judge));
    return runs;
  };
  std::vector<Runs> methods;
  for (const char* algorithm : {"auto", "slsqp"})
    methods.push_back(from_all(algorithm, kForever));
  const double near = 1.05 * best_of(methods[0]);
  const double limit = multiple * expected(methods[0], near, 1).seconds();
  for (const char* algorithm : {"cobyla", "bobyqa", "crs2", "isres"})
    methods.push_back(from_all(algorithm, limit));
  double best = kForever;
  for (const Runs& runs : methods) best = std::min(best, best_of(runs));
  std::printf("  the best %.5g mm\n", 1e3 * best);
  for (const Runs& runs : methods)
    print(runs, methods[0], best, runs.front().gradients > 0 ? gradient / hard : 1);
}

/// What a gradient costs where cameras have six variables each, and what it costs where
/// any one of them may fail.
void gradient_cost(int cameras, PluginRegistry& plugins) {
  Scene scene = room(cameras, 0, plugins);
  Problem problem(scene, plugins, {1500, 1});
  const auto [hard, gradient] = costs(problem);
  std::printf("%d cameras: gradient over %zu variables costs %.1f fields", cameras,
              problem.design().size(), gradient / hard);
  for (const DeviceEntry& camera : scene.devices)
    scene.objective.robust.failures.push_back(camera.name);
  Problem robust(scene, plugins, {1500, 1});
  const auto [worst, of_worst] = costs(robust);
  std::printf("; where one may fail, a score %.1f fields, a gradient %.1f\n",
              worst / hard, of_worst / hard);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  PluginRegistry plugins(plugin_folders({}));
  const double multiple = argc > 1 ? std::atof(argv[1]) : 6;
  const int begins = argc > 2 ? std::atoi(argv[2]) : 3;
  std::vector<int> cameras;
  for (int i = 3; i < argc; ++i) cameras.push_back(std::atoi(argv[i]));
  if (cameras.empty()) cameras = {8, 16, 32};
  gradient_cost(8, plugins);
  gradient_cost(64, plugins);
  for (const int count : cameras) compare(count, multiple, begins, plugins);
}
