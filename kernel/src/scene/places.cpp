#include "delos/scene/places.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "delos/sampling/samples.h"

namespace delos {
namespace {

/// The places of a box: cells of equal size, of each its middle.
std::vector<Eigen::Vector3d> spread_points(const Eigen::AlignedBox3d& box,
                                           std::size_t most) {
  const int n = std::max(1, static_cast<int>(std::cbrt(static_cast<double>(most))));
  std::vector<Eigen::Vector3d> points;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Eigen::Vector3d part = Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5) / n;
        points.emplace_back(box.min() + part.cwiseProduct(box.sizes()));
      }
  return points;
}

}  // namespace

std::vector<Pose> spread_poses(const Scene& scene, std::size_t most) {
  const auto* adaptive = std::get_if<AdaptiveSampling>(&scene.samples.front().shape);
  const std::vector<Eigen::Vector3d> points =
      adaptive ? spread_points({adaptive->min, adaptive->max}, most)
               : make_samples(scene.samples).points;
  const std::size_t turns = scene.orientations.rpy.size(), all = points.size() * turns;
  std::vector<Pose> poses;
  // Places at a constant stride could all lie on one side of a grid.
  std::mt19937_64 random(20070501);
  const std::size_t count = std::min(all, most);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = i * all / count, end = (i + 1) * all / count;
    const std::size_t at = first + random() % (end - first);
    poses.push_back(
        {rotation_from_rpy(scene.orientations.rpy[at % turns]), points[at / turns]});
  }
  return poses;
}

}  // namespace delos
