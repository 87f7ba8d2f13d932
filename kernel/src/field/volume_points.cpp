#include "field/volume_points.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace delos {
namespace {

class Cut {
 public:
  Cut(const Octree& tree, const std::function<bool(Octree::Index)>& edge, int about,
      std::uint64_t seed)
      : tree_(tree), edge_(edge), random_(seed) {
    double smooth = 0, edges = 0;
    for (const Octree::Index leaf : tree.leaves())
      (edge(leaf) ? edges : smooth) += tree.box_of(leaf).volume();
    most_ = 2 * (smooth + kFiner * edges) / about;
  }

  VolumePoints operator()() {
    for (Octree::Index c = 0; c < tree_.cells().size(); ++c)
      if (tree_.cells()[c].level == 0) cell(c);
    return std::move(out_);
  }

 private:
  static constexpr double kFiner = 8;

  void cell(Octree::Index c) {
    const Eigen::AlignedBox3d box = tree_.box_of(c);
    const double most = edge_(c) ? most_ / kFiner : most_;
    if (tree_.is_leaf(c)) {
      const double parts = std::cbrt(box.volume() / most);
      return split(box, std::max(1, static_cast<int>(std::lround(parts))));
    }
    if (box.volume() <= most) return pair(box);
    for (Octree::Index child = 0; child < 8; ++child)
      cell(tree_.cells()[c].first_child + child);
  }

  void split(const Eigen::AlignedBox3d& box, int parts) {
    const Eigen::Vector3d size = box.sizes() / parts;
    for (int k = 0; k < parts; ++k)
      for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i) {
          const Eigen::Vector3d least =
              box.min() + size.cwiseProduct(Eigen::Vector3d(i, j, k));
          pair({least, least + size});
        }
  }

  void pair(const Eigen::AlignedBox3d& box) {
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 2; ++i) {
      const double x = uniform(random_), y = uniform(random_), z = uniform(random_);
      const Eigen::Vector3d part(x, y, z);
      out_.points.emplace_back(box.min() + part.cwiseProduct(box.sizes()));
      out_.weight.push_back(box.volume() / 2);
    }
  }

  const Octree& tree_;
  const std::function<bool(Octree::Index)>& edge_;
  std::mt19937_64 random_;
  double most_ = 0;  // m³ of a box that no edge crosses
  VolumePoints out_;
};

}  // namespace

VolumePoints volume_points(const Octree& tree,
                           const std::function<bool(Octree::Index)>& edge, int about,
                           std::uint64_t seed) {
  return Cut(tree, edge, about, seed)();
}

}  // namespace delos
