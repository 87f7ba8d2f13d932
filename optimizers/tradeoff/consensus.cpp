#include <algorithm>
#include <cmath>

#include "delos/device/faults.h"
#include "delos/optimize/layout.h"
#include "problem/search_samples.h"
#include "search/random_point.h"

namespace delos {
namespace {

/// Random designs that the best ones are compared with.
constexpr int kChance = 100;
/// Layouts nearer than this part of the distance by chance are the same.
constexpr double kAlike = 0.05;
constexpr double kSettled = 0.25, kFree = 0.6;

Eigen::Vector3d middle_of(const Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : all_samples(scene).points) box.extend(p);
  return box.center();
}

/// How much each device varies over some matches: root mean squares.
struct Spread {
  std::vector<double> shift, turn, both;  ///< metres, radians, metres
};

Spread spread_of(const std::vector<LayoutMatch>& matches,
                 const std::vector<double>& arms) {
  const std::size_t n = arms.size();
  Spread s{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  for (const LayoutMatch& match : matches) {
    for (std::size_t i = 0; i < n; ++i) {
      s.shift[i] += match.shift[i] * match.shift[i];
      s.turn[i] += match.turn[i] * match.turn[i];
    }
  }
  const double count = std::max<double>(1, static_cast<double>(matches.size()));
  for (std::size_t i = 0; i < n; ++i) {
    s.both[i] = std::sqrt((s.shift[i] + arms[i] * arms[i] * s.turn[i]) / count);
    s.shift[i] = std::sqrt(s.shift[i] / count);
    s.turn[i] = std::sqrt(s.turn[i] / count);
  }
  return s;
}

}  // namespace

Consensus consensus(const Scene& scene, PluginRegistry& plugins,
                    const std::vector<RankedDesign>& designs, std::size_t most,
                    std::uint64_t seed) {
  Design design(scene, plugins);
  const std::vector<int> kinds = device_kinds(scene, plugins);
  const Eigen::Vector3d middle = middle_of(scene);
  const auto layout = [&](const std::vector<double>& x) {
    design.set(x);
    std::vector<Pose> poses;
    for (const DeviceEntry& device : design.scene().devices)
      poses.push_back(device_pose(design.scene(), device));
    return poses;
  };

  std::vector<std::size_t> order(designs.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return designs[a].objective < designs[b].objective;
  });
  const std::vector<Pose> best = layout(designs[order.front()].x);

  // What chance gives.
  std::vector<LayoutMatch> by_chance;
  for (int k = 0; k < kChance; ++k) {
    UnitNumbers unit(seed, k);
    std::vector<double> x(design.size());
    for (double& value : x) value = unit();
    try {
      by_chance.push_back(match_layouts(kinds, best, layout(x), middle));
    } catch (const Unbuildable&) {
      // Surfaces may have holes.
    }
  }
  double chance = 0;
  for (const LayoutMatch& match : by_chance) chance += match.distance;
  if (!by_chance.empty()) chance /= static_cast<double>(by_chance.size());

  Consensus all;
  std::vector<std::vector<Pose>> taken;
  std::vector<LayoutMatch> matches;  // of the others with the best
  for (const std::size_t i : order) {
    if (all.layouts.size() == most) break;
    const std::vector<Pose> poses = layout(designs[i].x);
    const bool known = std::any_of(taken.begin(), taken.end(), [&](const auto& other) {
      return match_layouts(kinds, other, poses, middle).distance <= kAlike * chance;
    });
    if (known) continue;
    const LayoutMatch match = match_layouts(kinds, best, poses, middle);
    all.layouts.push_back({i, designs[i].objective, match.distance});
    if (!taken.empty()) matches.push_back(match);
    taken.push_back(poses);
  }

  std::vector<double> arms;
  for (const Pose& pose : best) arms.push_back((middle - pose.p).norm());
  const Spread own = spread_of(matches, arms), random = spread_of(by_chance, arms);
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (random.both[i] == 0) continue;  // nothing moves it
    const double part = own.both[i] / random.both[i];
    all.devices.push_back({scene.devices[i].name, best[i].p, own.shift[i], own.turn[i],
                           part,
                           part < kSettled ? Settled::settled
                           : part > kFree  ? Settled::free
                                           : Settled::partly});
  }
  return all;
}

}  // namespace delos
