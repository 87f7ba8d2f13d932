#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "delos/optimize/tradeoff.h"
#include "delos/scene/definition.h"
#include "search/random_point.h"
#include "search/start.h"
#include "tradeoff/device_count.h"

namespace delos {
namespace {

/// Random values that a new device's variables are tried with, all templates together.
constexpr int kTries = 96;

/// The scene with one definition for all numbers of devices: copies have rates of their
/// own where the rate of the device varies.
Scene with_one_definition(Scene scene, std::size_t most) {
  if (!varies_rates(scene) || most < 2) return scene;
  if (scene.fusion == Fusion::stacked)
    throw std::invalid_argument(
        "stacked fusion needs one rate, but each copy of a device would have its own; "
        "use continuous");
  if (!scene.fusion) scene.fusion = Fusion::continuous;
  return scene;
}

class CountSearch {
 public:
  CountSearch(PluginRegistry& plugins, const Prices& prices,
              const OptimizeOptions& options)
      : plugins_(plugins), prices_(prices), options_(options) {}

  DeviceCountPoint search(const Scene& scene) {
    OptimizeResult found = optimize(scene, plugins_, options_);
    DeviceCountPoint point;
    point.devices = found.scene.devices.size();
    point.price = price_of(found.scene, prices_);
    point.objective = found.best.objective;
    point.kept = found.best.feasible();
    point.constraints = std::move(found.constraints);
    point.scene = std::move(found.scene);
    return point;
  }

  /// The scene without the device that is missed least.
  Scene fewer(const Scene& scene) {
    Problem problem(scene, plugins_, {options_.samples, options_.threads});
    std::optional<std::size_t> least;
    double objective = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.devices.size(); ++i) {
      if (!has_variables(scene, scene.devices[i].name)) continue;
      const double without = problem.objective_without(problem.design().start(), i);
      if (least && without >= objective) continue;
      least = i;
      objective = without;
    }
    Scene rest = least ? without_device(scene, scene.devices[*least].name) : scene;
    if (!least || rest.variables.empty())
      throw std::invalid_argument("of " + std::to_string(scene.devices.size()) +
                                  " devices no more than this many can be left out: "
                                  "only those with variables of their own can");
    return rest;
  }

  /// The scene with one more device, at the best of some random places.
  Scene more(const Scene& scene) {
    std::vector<std::string> templates;
    for (const DeviceEntry& device : scene.devices)
      if (has_variables(scene, device.name)) templates.push_back(device.name);
    if (templates.empty())
      throw std::invalid_argument(
          "no device has variables of its own, so that none can be added");
    const int tries = std::max(8, kTries / static_cast<int>(templates.size()));
    std::optional<Scene> best;
    Score least;
    for (std::size_t t = 0; t < templates.size(); ++t) {
      const Scene grown = with_copy(scene, templates[t]);
      Problem problem(grown, plugins_, {options_.samples, options_.threads});
      const std::size_t own = problem.design().size() - scene.variables.size();
      UnitNumbers unit(options_.seed, static_cast<int>(t));
      for (int k = 0; k < tries; ++k) {
        std::vector<double> x = problem.design().start();
        for (std::size_t v = x.size() - own; v < x.size(); ++v) x[v] = unit();
        const Score score = problem.score(x);
        if (best && !better(score, least, problem.limits())) continue;
        least = score;
        problem.design().set(x);
        best = problem.design().scene();
      }
    }
    return *best;
  }

  /// Whether a scene as it stands beats a point.
  bool beats(const Scene& scene, const DeviceCountPoint& point) {
    Problem problem(scene, plugins_, {0, options_.threads});
    const Score score = problem.score(problem.design().start());
    return score.feasible() && (!point.kept || score.objective < point.objective);
  }

 private:
  PluginRegistry& plugins_;
  const Prices& prices_;
  const OptimizeOptions& options_;
};

}  // namespace

double price_of(const Scene& scene, const Prices& prices) {
  double sum = 0;
  for (const DeviceEntry& device : scene.devices) {
    auto price = prices.find(device.name);
    if (price == prices.end()) price = prices.find(device.type);
    sum += price == prices.end() ? 1 : price->second;
  }
  return sum;
}

std::vector<DeviceCountPoint> search_counts(const Scene& given, PluginRegistry& plugins,
                                            std::size_t from, std::size_t to,
                                            const Prices& prices,
                                            const OptimizeOptions& options,
                                            const SearchesDone& progress) {
  CountSearch searches(plugins, prices, options);
  const std::size_t own = given.devices.size();
  const std::size_t low = std::min(from, own), high = std::max(to, own);
  std::size_t done = 0;
  const auto tell = [&] {
    if (progress) progress(done++, high - low + 1);
  };
  const auto stopped = [&] { return options.cancel && options.cancel->load(); };

  // One guess and one definition for all, so that objectives can be compared.
  std::vector<DeviceCountPoint> points(high - low + 1);
  const auto at = [&](std::size_t n) -> DeviceCountPoint& { return points[n - low]; };
  tell();
  at(own) = searches.search(with_guess(with_one_definition(given, high), plugins));
  for (std::size_t n = own; n-- > low && !stopped();) {
    tell();
    at(n) = searches.search(searches.fewer(at(n + 1).scene));
  }
  for (std::size_t n = own + 1; n <= high && !stopped(); ++n) {
    tell();
    at(n) = searches.search(searches.more(at(n - 1).scene));
  }
  for (std::size_t n = high; n-- > low && !stopped();) {
    const Scene scene = searches.fewer(at(n + 1).scene);
    if (searches.beats(scene, at(n))) at(n) = searches.search(scene);
  }
  for (std::size_t n = low + 1; n <= high && !stopped(); ++n) {
    const Scene scene = searches.more(at(n - 1).scene);
    if (searches.beats(scene, at(n))) at(n) = searches.search(scene);
  }
  std::erase_if(points, [&](const DeviceCountPoint& point) {
    return point.devices < from || point.devices > to;
  });
  return points;
}

const DeviceCountPoint* cheapest_kept(const std::vector<DeviceCountPoint>& points) {
  const DeviceCountPoint* cheapest = nullptr;
  for (const DeviceCountPoint& point : points) {
    if (!point.kept) continue;
    if (!cheapest || point.price < cheapest->price ||
        (point.price == cheapest->price && point.objective < cheapest->objective))
      cheapest = &point;
  }
  return cheapest;
}

}  // namespace delos
