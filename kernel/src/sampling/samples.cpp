#include "delos/sampling/samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace delos {
namespace {

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

/// Samples along one axis, min, min + step, … ≤ max.
std::int64_t axis_count(double min, double max, double step) {
  // A step that divides the box in decimals does so in doubles only to rounding:
  // 0.8/0.04 must give 20 steps however it is rounded.
  constexpr double kRounding = 1e-9;
  const double steps = std::floor((max - min) / step + kRounding);
  if (!(steps < 9e18)) return kMost;
  return static_cast<std::int64_t>(steps) + 1;
}

Eigen::Matrix<std::int64_t, 3, 1> grid_counts(const VolumeSampling& v) {
  return {axis_count(v.min.x(), v.max.x(), v.step.x()),
          axis_count(v.min.y(), v.max.y(), v.step.y()),
          axis_count(v.min.z(), v.max.z(), v.step.z())};
}

double path_length(const PathSampling& p) {
  double length = 0;
  for (std::size_t i = 1; i < p.waypoints.size(); ++i)
    length += (p.waypoints[i] - p.waypoints[i - 1]).norm();
  return length;
}

std::int64_t path_count(const PathSampling& p) {
  if (p.step) return axis_count(0, path_length(p), *p.step);
  return p.count ? *p.count : static_cast<std::int64_t>(p.waypoints.size());
}

std::int64_t saturating_product(std::int64_t a, std::int64_t b) {
  std::int64_t product;
  return __builtin_mul_overflow(a, b, &product) ? kMost : product;
}

struct Count {
  std::int64_t operator()(const VolumeSampling& v) const {
    const auto n = grid_counts(v);
    return saturating_product(saturating_product(n.x(), n.y()), n.z());
  }
  std::int64_t operator()(const PlaneSampling& p) const {
    return saturating_product(p.counts[0], p.counts[1]);
  }
  std::int64_t operator()(const PointSampling& p) const {
    return static_cast<std::int64_t>(p.points.size());
  }
  std::int64_t operator()(const PathSampling& p) const { return path_count(p); }
  std::int64_t operator()(const MeshSampling& m) const {
    return static_cast<std::int64_t>(m.surface.mesh->vertices.size());
  }
  std::int64_t operator()(const AdaptiveSampling&) const { return 0; }
};

/// Appends the points of a shape and tells how they hang together.
struct Make {
  std::vector<Eigen::Vector3d>& points;

  decltype(SamplePart::shape) operator()(const VolumeSampling& v) const {
    const GridShape grid{v.min, v.step, grid_counts(v)};
    for (std::int64_t k = 0; k < grid.counts.z(); ++k)
      for (std::int64_t j = 0; j < grid.counts.y(); ++j)
        for (std::int64_t i = 0; i < grid.counts.x(); ++i)
          points.emplace_back(v.min.x() + static_cast<double>(i) * v.step.x(),
                              v.min.y() + static_cast<double>(j) * v.step.y(),
                              v.min.z() + static_cast<double>(k) * v.step.z());
    return grid;
  }

  decltype(SamplePart::shape) operator()(const PlaneSampling& p) const {
    // The last sample is at a = 1 exactly; a single one stays at the origin.
    const auto fraction = [](int i, int n) {
      return n > 1 ? static_cast<double>(i) / (n - 1) : 0.0;
    };
    for (int j = 0; j < p.counts[1]; ++j)
      for (int i = 0; i < p.counts[0]; ++i)
        points.emplace_back(p.origin + fraction(i, p.counts[0]) * p.u +
                            fraction(j, p.counts[1]) * p.v);
    return PlaneShape{p.origin, p.u, p.v, p.counts};
  }

  decltype(SamplePart::shape) operator()(const PointSampling& p) const {
    points.insert(points.end(), p.points.begin(), p.points.end());
    return ScatteredShape{};
  }

  decltype(SamplePart::shape) operator()(const PathSampling& p) const {
    if (!p.step && !p.count) {
      points.insert(points.end(), p.waypoints.begin(), p.waypoints.end());
      return ScatteredShape{};
    }
    const std::int64_t count = path_count(p);
    const double length = path_length(p);
    std::size_t leg = 1;
    double before = 0;  // the path's length up to this leg
    for (std::int64_t k = 0; k < count; ++k) {
      const auto i = static_cast<double>(k);
      const double s =
          p.step ? i * *p.step : length * i / static_cast<double>(count - 1);
      double here = (p.waypoints[leg] - p.waypoints[leg - 1]).norm();
      while (s > before + here && leg + 1 < p.waypoints.size()) {
        before += here;
        ++leg;
        here = (p.waypoints[leg] - p.waypoints[leg - 1]).norm();
      }
      // Rounding of the sum may not lead beyond the end.
      const double part = here > 0 ? std::min((s - before) / here, 1.0) : 0;
      points.emplace_back(p.waypoints[leg - 1] +
                          part * (p.waypoints[leg] - p.waypoints[leg - 1]));
    }
    return ScatteredShape{};
  }

  decltype(SamplePart::shape) operator()(const MeshSampling& m) const {
    for (const Eigen::Vector3d& vertex : m.surface.mesh->vertices)
      points.emplace_back(m.surface.scale * vertex);
    return SurfaceShape{m.surface.mesh->triangles};
  }

  decltype(SamplePart::shape) operator()(const AdaptiveSampling&) const {
    throw std::invalid_argument(
        "adaptive samples are chosen while a field is evaluated; give the volume a "
        "step instead of 'adaptive'");
  }
};

}  // namespace

bool operator==(const AdaptiveSampling& a, const AdaptiveSampling& b) {
  const auto same_box = [](const auto& p, const auto& q) {
    return p.has_value() == q.has_value() &&
           (!p || (p->min() == q->min() && p->max() == q->max()));
  };
  return a.min == b.min && a.max == b.max && a.tolerance == b.tolerance &&
         a.depth == b.depth && a.evaluations == b.evaluations &&
         a.seconds == b.seconds && a.near_value == b.near_value &&
         same_box(a.within, b.within);
}

std::int64_t sample_count(const SampleSet& set) {
  return std::visit(Count{}, set.shape);
}

Samples make_samples(const std::vector<SampleSet>& sets) {
  Samples samples;
  std::size_t total = 0;
  for (const SampleSet& set : sets)
    total += static_cast<std::size_t>(sample_count(set));
  samples.points.reserve(total);
  for (const SampleSet& set : sets) {
    SamplePart part;
    part.name = set.name;
    part.first = samples.points.size();
    part.shape = std::visit(Make{samples.points}, set.shape);
    part.count = samples.points.size() - part.first;
    samples.parts.push_back(std::move(part));
  }
  return samples;
}

}  // namespace delos
