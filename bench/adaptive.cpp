// Adaptive against regular sampling: what either needs for the same error.
//
// Errors are over 40,000 random points that were evaluated directly:
// |log10(read/true)|, one decade where only one of the two is blind. A regular grid is
// read as usual, log10 of the metric by trilinear interpolation, blind where a corner
// is. An octree is read with shadows' edges as its nodes have them (nodes) and with a
// ray where its cell leaves a doubt (rays). One thread; prints tables.
#include "delos/field/adaptive.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "delos/scene/io.h"

namespace {

using namespace delos;

struct Case {
  std::string name;
  System system;
  Orientations orientations;
  Metric metric;
  Eigen::AlignedBox3d box;
};

Case scene_case(const std::string& file, const Eigen::AlignedBox3d& box) {
  PluginRegistry plugins;
  Diagnostics diagnostics;
  const auto scene =
      load_scene(std::string(DELOS_SCENES "/") + file, {}, plugins, diagnostics);
  if (!scene) throw std::runtime_error(file + " doesn't load");
  return {scene->name, build_system(*scene, plugins), scene->orientations,
          std::get<Metric>(parse_metric("eigmax", scene->motion.layout)), box};
}

Samples random_points(const Eigen::AlignedBox3d& box, int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Samples samples;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d p = box.min();
    for (int k = 0; k < 3; ++k) p(k) += uniform(random) * box.sizes()(k);
    samples.points.push_back(p);
  }
  samples.parts.push_back({"", 0, samples.points.size(), ScatteredShape{}});
  return samples;
}

struct Errors {
  double l2 = 0, p95 = 0;
};

Errors errors_of(const std::vector<double>& read, const std::vector<double>& truth) {
  std::vector<double> all;
  double sum = 0;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const bool both = std::isfinite(read[i]) && std::isfinite(truth[i]);
    const double off = read[i] == truth[i] ? 0
                       : both ? std::min(1.0, std::abs(std::log10(read[i] / truth[i])))
                              : 1;
    all.push_back(off);
    sum += off * off;
  }
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(all.size() * 95 / 100);
  std::nth_element(all.begin(), at, all.end());
  return {std::sqrt(sum / static_cast<double>(all.size())), *at};
}

/// A field over a regular grid of n³ samples.
struct RegularField {
  RegularField(const Case& c, int samples) : box(c.box), n(samples) {
    const Eigen::Vector3d step = box.sizes() / (n - 1);
    field = evaluate_field(
        c.system, make_samples({{"", VolumeSampling{box.min(), box.max(), step}}}),
        c.orientations, c.metric, {.threads = 1});
  }
  [[nodiscard]] double read(const Eigen::Vector3d& p) const {
    const auto un = static_cast<std::size_t>(n);
    std::size_t base[3];
    double part[3];
    for (int i = 0; i < 3; ++i) {
      const double at = (p(i) - box.min()(i)) / box.sizes()(i) * (n - 1);
      const double cell = std::min(std::floor(at), n - 2.0);
      base[i] = static_cast<std::size_t>(cell);
      part[i] = at - cell;
    }
    double sum = 0;
    for (std::size_t c = 0; c < 8; ++c) {
      double weight = 1;
      std::size_t at[3];
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t up = c >> i & 1;
        weight *= up ? part[i] : 1 - part[i];
        at[i] = base[i] + up;
      }
      if (weight > 0) {
        sum += weight * std::log10(field.value[at[0] + un * (at[1] + un * at[2])]);
      }
    }
    return std::pow(10.0, sum);
  }
  Eigen::AlignedBox3d box;
  int n;
  Field field;
};

/// One row of a table.
struct Row {
  double evaluations;
  Errors errors;
};

void print(const char* what, double evaluations, std::uint64_t rays, double seconds,
           const Errors& e) {
  std::printf("%-26s %11.0f %11llu %9.3f %10.6f %10.6f\n", what, evaluations,
              static_cast<unsigned long long>(rays), seconds, e.l2, e.p95);
  std::fflush(stdout);
}

/// The first row that is at least as good as another, by both errors; or null.
const Row* as_good(const std::vector<Row>& rows, const Row& other) {
  for (const Row& row : rows) {
    if (row.errors.l2 <= other.errors.l2 && row.errors.p95 <= other.errors.p95)
      return &row;
  }
  return nullptr;
}

struct Setting {
  double tolerance;
  int depth;
};

AdaptiveField octree_of(const Case& c, const Setting& setting,
                        std::optional<double> near_value) {
  AdaptiveSampling sampling;
  sampling.min = c.box.min();
  sampling.max = c.box.max();
  sampling.tolerance = setting.tolerance;
  sampling.depth = setting.depth;
  sampling.near_value = near_value;
  AdaptiveOptions options;
  options.field.threads = 1;
  options.held_back = options.spread = 0;
  return evaluate_adaptive(c.system, sampling, c.orientations, c.metric, options);
}

Errors errors_of(const RegularField& field, const Samples& points,
                 const std::vector<double>& truth) {
  std::vector<double> read;
  for (const Eigen::Vector3d& p : points.points) read.push_back(field.read(p));
  return errors_of(read, truth);
}

/// The least regular grid that is at least as good as an octree, up to 129³; bisection
/// needs a smooth scene, where finer is better.
void print_equal_grid(const Case& c, const Samples& points,
                      const std::vector<double>& truth, const Row& octree) {
  int worse = 2, good = 129;
  while (good - worse > 1) {
    const int n = (good + worse) / 2;
    const Errors e = errors_of(RegularField(c, n), points, truth);
    (e.l2 <= octree.errors.l2 && e.p95 <= octree.errors.p95 ? good : worse) = n;
  }
  std::printf("as good as the octree of %.0f: regular %d^3, %.1f times more\n",
              octree.evaluations, good, std::pow(good, 3) / octree.evaluations);
}

void compare(const Case& c, const std::vector<int>& grids,
             const std::vector<Setting>& settings, bool smooth = false) {
  const Samples points = random_points(c.box, 40'000, 1);
  const Field truth =
      evaluate_field(c.system, points, c.orientations, c.metric, {.threads = 1});
  std::printf("\n%s\n%-26s %11s %11s %9s %10s %10s\n", c.name.c_str(), "sampling",
              "evaluations", "rays", "seconds", "L2", "p95");
  std::vector<Row> regular, octree;
  for (const int n : grids) {
    const RegularField field(c, n);
    const auto evaluations = static_cast<double>(field.field.evaluations);
    regular.push_back({evaluations, errors_of(field, points, truth.value)});
    char what[32];
    std::snprintf(what, sizeof what, "regular %d^3", n);
    print(what, evaluations, 0, field.field.seconds, regular.back().errors);
  }
  double saved = 0;
  for (const Setting& setting : settings) {
    const AdaptiveField field = octree_of(c, setting, {});
    const AdaptiveReport& report = field.report();
    const auto evaluations = static_cast<double>(field.field().evaluations);
    char what[32];
    std::snprintf(what, sizeof what, "octree %.2g %% depth %d", 100 * setting.tolerance,
                  setting.depth);
    const Errors nodes = errors_of(field.read(points).value, truth.value);
    print(what, evaluations, report.rays, field.field().seconds, nodes);
    octree.push_back({evaluations, nodes});
    if (report.rays == 0) continue;
    const Field exact = field.read(points, ShadowEdges::exact);
    print("  read with rays", evaluations, report.rays, field.field().seconds,
          errors_of(exact.value, truth.value));
    saved = static_cast<double>(report.rays_saved) /
            static_cast<double>(report.rays + report.rays_saved);
  }
  for (std::size_t g = 0; g < regular.size(); ++g) {
    const Row* row = as_good(octree, regular[g]);
    if (!row) continue;
    std::printf(
        "as good as regular %d^3: octree of %.0f evaluations, %.1f times fewer\n",
        grids[g], row->evaluations, regular[g].evaluations / row->evaluations);
  }
  if (smooth) {
    for (const Row& row : octree) print_equal_grid(c, points, truth.value, row);
  }
  if (octree.size() > 2 && saved > 0) {
    std::printf(
        "evaluations grow with the power %.2f of resolution (a level is twice)\n",
        std::log2(octree.back().evaluations / octree[0].evaluations) /
            static_cast<double>(octree.size() - 1));
    std::printf("sight lines that needed no ray: %.1f %%\n", 100 * saved);
  }
}

/// Mean distance, along vertical lines, between where the true metric and the read one
/// first cross a value.
template <class Read>
double surface_distance(const Case& c, double value, Read&& read) {
  constexpr int kSteps = 400;
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  double sum = 0;
  int found = 0;
  for (int line = 0; line < 300; ++line) {
    Samples samples;
    const double x = c.box.min().x() + uniform(random) * c.box.sizes().x();
    const double y = c.box.min().y() + uniform(random) * c.box.sizes().y();
    for (int i = 0; i <= kSteps; ++i) {
      samples.points.emplace_back(x, y,
                                  c.box.min().z() + c.box.sizes().z() * i / kSteps);
    }
    samples.parts.push_back({"", 0, samples.points.size(), ScatteredShape{}});
    const Field truth =
        evaluate_field(c.system, samples, c.orientations, c.metric, {.threads = 1});
    const auto crossing = [&](const std::vector<double>& values) {
      for (std::size_t i = 0; i + 1 < values.size(); ++i) {
        if (!std::isfinite(values[i]) || !std::isfinite(values[i + 1])) continue;
        if ((values[i] < value) == (values[i + 1] < value)) continue;
        return static_cast<double>(i) +
               (value - values[i]) / (values[i + 1] - values[i]);
      }
      return -1.0;
    };
    const double there = crossing(truth.value), here = crossing(read(samples));
    if (there < 0 || here < 0) continue;
    sum += std::abs(there - here) * c.box.sizes().z() / kSteps;
    ++found;
  }
  return found > 0 ? sum / found : 0;
}

void focus(const Case& c, double value, const std::vector<int>& grids,
           const std::vector<Setting>& settings) {
  std::printf("\n%s, the surface where %s is %g m\n%-26s %11s %14s\n", c.name.c_str(),
              c.metric.name.c_str(), value, "sampling", "evaluations", "distance [m]");
  for (const int n : grids) {
    const RegularField field(c, n);
    const double distance = surface_distance(c, value, [&](const Samples& s) {
      std::vector<double> read;
      for (const Eigen::Vector3d& p : s.points) read.push_back(field.read(p));
      return read;
    });
    std::printf("regular %4d^3              %11zu %14.3g\n", n, field.field.evaluations,
                distance);
  }
  for (const Setting& setting : settings) {
    const AdaptiveField field = octree_of(c, setting, value);
    const double distance = surface_distance(
        c, value, [&](const Samples& s) { return field.read(s).value; });
    std::printf("octree %6.2g %% depth %d     %11zu %14.3g\n", 100 * setting.tolerance,
                setting.depth, field.field().evaluations, distance);
  }
}

/// What looking along sight lines costs of a regular field.
void visibility_share(const Case& c) {
  Case empty = c;
  empty.system.in_world = empty.system.on_target = Occluders();
  const double with = RegularField(c, 65).field.seconds;
  const double without = RegularField(empty, 65).field.seconds;
  std::printf(
      "\n%s, regular 65^3: %.3f s, without occluders %.3f s: sight takes %.0f %%\n",
      c.name.c_str(), with, without, 100 * (with - without) / with);
}

Eigen::AlignedBox3d box(Eigen::Vector3d min, Eigen::Vector3d max) { return {min, max}; }

}  // namespace

int main(int argc, char** argv) {
  const auto wanted = [&](const char* part) {
    return argc == 1 ||
           std::find(argv + 1, argv + argc, std::string(part)) != argv + argc;
  };
  const Case acoustic =
      scene_case("10-better-speakers.yaml", box({0, 0, 0}, {0.4, 0.4, 0.8}));
  const Case cameras =
      scene_case("02-eight-cameras.yaml", box({0, 0, 0}, {0.4, 0.4, 0.8}));
  const Case lab =
      scene_case("06-furnished-lab.yaml", box({-3, -4.2, 0}, {1.6, 3.4, 2}));
  const Case torso = scene_case("07-torso.yaml", box({-0.6, -0.5, 0}, {0.6, 0.5, 0.5}));
  if (wanted("acoustic")) {
    compare(acoustic, {9, 17, 33, 65},
            {{2e-3, 8}, {1e-3, 8}, {5e-4, 8}, {2e-4, 8}, {1e-4, 8}}, true);
  }
  if (wanted("cameras")) {
    compare(cameras, {17, 33, 65, 129, 257}, {{1e-2, 8}, {1e-5, 8}, {1e-6, 8}});
  }
  if (wanted("lab")) {
    compare(lab, {17, 33, 65, 129, 257}, {{0.02, 3}, {0.02, 4}, {0.02, 5}, {0.02, 6}});
  }
  if (wanted("torso")) {
    compare(torso, {17, 33, 65, 129}, {{0.02, 3}, {0.02, 4}, {0.02, 5}, {0.02, 6}});
  }
  if (wanted("focus")) {
    focus(acoustic, 0.04, {17, 33, 65}, {{5e-3, 8}, {5e-4, 8}, {5e-5, 8}});
  }
  if (wanted("sight")) {
    visibility_share(lab);
    visibility_share(torso);
  }
}
