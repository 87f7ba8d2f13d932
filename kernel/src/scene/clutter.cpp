#include "delos/scene/clutter.h"

#include <numbers>
#include <random>

namespace delos {
namespace {

/// Uniform in [0, 1), by the upper 53 bits: what std::uniform_real_distribution gives
/// differs between libraries.
class Uniform {
 public:
  explicit Uniform(int seed) : random_(static_cast<std::uint64_t>(seed)) {}
  double operator()(double from, double to) {
    const double part = static_cast<double>(random_() >> 11) * 0x1p-53;
    return from + part * (to - from);
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace

std::vector<OccluderEntry> drawn_bodies(const ClutterEntry& clutter) {
  Uniform uniform(clutter.seed);
  std::vector<OccluderEntry> bodies;
  for (int k = 0; k < clutter.count; ++k) {
    // Every body takes seven numbers, whatever its shape.
    OccluderEntry body;
    for (int i = 0; i < 3; ++i)
      body.placement.at(i) = uniform(clutter.box.min(i), clutter.box.max(i));
    Eigen::Vector3d size;
    for (double& edge : size) edge = uniform(clutter.least, clutter.greatest);
    const double turn = uniform(0, 2 * std::numbers::pi);
    if (clutter.shape == ClutterShape::box) {
      body.body = BoxShape{-size / 2, size / 2};
      body.placement.facing = Rpy{{0, 0, turn}};
    } else {
      body.body = SphereShape{size(0) / 2};
    }
    body.name = clutter.name + '-' + std::to_string(k + 1);
    bodies.push_back(std::move(body));
  }
  return bodies;
}

std::vector<OccluderEntry> all_occluders(const Scene& scene) {
  std::vector<OccluderEntry> all = scene.occluders;
  for (const ClutterEntry& clutter : scene.clutter) {
    std::vector<OccluderEntry> drawn = drawn_bodies(clutter);
    all.insert(all.end(), drawn.begin(), drawn.end());
  }
  return all;
}

}  // namespace delos
