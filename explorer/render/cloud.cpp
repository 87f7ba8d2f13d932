#include "render/cloud.h"

#include <algorithm>
#include <cmath>

namespace delos::render {
namespace {

using session::Drawn;

/// What is at a place of a grid.
struct Matter {
  bool solid = false, seen = false;
  double value = 0;
};

class Cloud {
 public:
  Cloud(const Pen& pen, const session::DrawnField& drawn, const ColourRange& colours,
        const SamplePart& part, const GridShape& grid)
      : pen_(pen),
        drawn_(drawn),
        colours_(colours),
        first_(part.first),
        grid_(grid),
        last_((grid.counts.array() - 1).cast<double>()),
        far_(grid.origin + last_.matrix().cwiseProduct(grid.step)),
        steps_(std::clamp(static_cast<int>(1.5 * double(grid.counts.maxCoeff())), 40,
                          96)) {}

  void operator()(double x, double y, const std::array<double, Raster::kSpots>& ends,
                  std::array<Haze, Raster::kSpots>& hazes) const {
    const Ray ray = pen_.eye.ray(x, y);
    const Eigen::Array3d a = (grid_.origin - ray.from).array() / ray.along.array(),
                         b = (far_ - ray.from).array() / ray.along.array();
    const double begin = std::max(a.min(b).maxCoeff(), 0.0), end = a.max(b).minCoeff();
    if (!(begin < end)) return;
    const double stride = (end - begin) / steps_;
    const double way = stride * ray.along.norm() / (far_ - grid_.origin).norm();
    Haze sum;
    std::size_t going = ends.size();
    for (int i = 0; i < steps_ && going > 0; ++i) {
      const double t = begin + (i + 0.5) * stride;
      going = 0;
      for (std::size_t k = 0; k < ends.size(); ++k) going += t < ends[k];
      add(matter_at(ray.from + t * ray.along), way, sum);
      for (std::size_t k = 0; k < ends.size(); ++k)
        if (t < ends[k]) hazes[k] = sum;
      if (sum.opacity > 0.99) return;
    }
  }

 private:
  void add(const Matter& matter, double way, Haze& sum) const {
    if (matter.solid) return;
    double density = 1.6;
    Colour colour = pen_.ground.blind;
    if (matter.seen) {
      const double part = std::clamp(colour_position(colours_, matter.value), 0.0, 1.0);
      density = 0.6 + 9 * std::pow(colours_.larger_is_better ? part : 1 - part, 3);
      colour = colour_of(colours_, matter.value);
    }
    const double more = (1 - sum.opacity) * -std::expm1(-density * way);
    for (std::size_t c = 0; c < 3; ++c) sum.light[c] += more * colour[c];
    sum.opacity += more;
  }

  [[nodiscard]] Matter matter_at(const Eigen::Vector3d& at) const {
    const Eigen::Array3d place =
        ((at - grid_.origin).array() / grid_.step.array()).max(0).min(last_);
    const Eigen::Array3d low = place.floor().min((last_ - 1).max(0));
    const Eigen::Array3d part = place - low;
    double sum = 0, seen = 0, solid = 0;
    for (int corner = 0; corner < 8; ++corner) {
      std::size_t index = first_;
      std::size_t stride = 1;
      double weight = 1;
      for (int k = 0; k < 3; ++k) {
        const bool high = (corner >> k & 1) != 0;
        weight *= high ? part[k] : 1 - part[k];
        index += stride * static_cast<std::size_t>(std::min(low[k] + high, last_[k]));
        stride *= static_cast<std::size_t>(grid_.counts[k]);
      }
      if (drawn_.mask[index] == Drawn::value) {
        sum += weight * drawn_.field.value[index];
        seen += weight;
      } else if (drawn_.mask[index] == Drawn::inside) {
        solid += weight;
      }
    }
    return {solid > 0.5, seen >= 0.5, seen > 0 ? sum / seen : 0};
  }

  const Pen& pen_;
  const session::DrawnField& drawn_;
  const ColourRange& colours_;
  std::size_t first_;
  const GridShape& grid_;
  Eigen::Array3d last_;  // index of the last sample along each axis
  Eigen::Vector3d far_;
  int steps_;
};

}  // namespace

void draw_cloud(const Pen& pen, const session::DrawnField& drawn,
                const ColourRange& colours) {
  for (const SamplePart& part : drawn.field.samples.parts)
    if (const auto* grid = std::get_if<GridShape>(&part.shape))
      pen.raster.compose(pen.eye, Cloud(pen, drawn, colours, part, *grid));
}

}  // namespace delos::render
