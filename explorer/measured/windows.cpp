#include "measured/windows.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "delos/model/infinity.h"
#include "delos/sampling/sets.h"

namespace delos::measured {
namespace {

void add_value(Field& field, const Eigen::Vector3d& at, double value) {
  field.samples.points.push_back(at);
  field.value.push_back(value);
  field.observable.push_back(std::isfinite(value));
  field.lost.push_back(0);
}

}  // namespace

std::vector<Window> windows_of(const PosesComparison& comparison, std::size_t size) {
  std::vector<Window> windows;
  std::size_t first = 0;
  for (const PathComparison& path : comparison.paths) {
    const std::size_t end = first + path.places;
    while (first < end) {
      const std::size_t last = end - first < 2 * size ? end : first + size;
      Window window{Eigen::Vector3d::Zero(), 0, 0};
      for (std::size_t i = first; i < last; ++i) {
        const ScatteredPlace& at = comparison.places[i];
        window.p += at.p;
        window.measured += at.measured * at.measured;
        window.predicted += at.predicted * at.predicted;
      }
      const auto count = static_cast<double>(last - first);
      window.p /= count;
      window.measured = std::sqrt(window.measured / count);
      window.predicted = std::sqrt(window.predicted / count);
      windows.push_back(window);
      first = last;
    }
  }
  return windows;
}

Field window_field(const std::vector<Window>& windows, WindowValue what,
                   const std::string& scene) {
  Field field;
  field.scene = scene;
  field.metric = what == WindowValue::measured    ? "measured σ"
                 : what == WindowValue::predicted ? "predicted σ"
                                                  : "ratio of σ";
  field.unit = what == WindowValue::ratio ? "1" : "m";
  for (const Window& w : windows) {
    const double ratio =
        std::isfinite(w.predicted) ? w.measured / w.predicted : kInfinity;
    add_value(field, w.p,
              what == WindowValue::measured    ? w.measured
              : what == WindowValue::predicted ? w.predicted
                                               : ratio);
  }
  field.samples.parts = {{"", 0, windows.size(), ScatteredShape{}}};
  field.evaluated = windows.size();
  return field;
}

Field measured_surface(const std::vector<Window>& windows, WindowValue what,
                       const ScatteredOptions& how, const std::string& scene) {
  const Field at_windows = window_field(windows, what, scene);
  std::vector<Eigen::Vector2d> points;
  Eigen::AlignedBox2d box;
  double height = 0;
  for (const Window& w : windows) {
    points.emplace_back(w.p.head<2>());
    box.extend(points.back());
    height += w.p.z() / static_cast<double>(windows.size());
  }
  if (!(box.sizes().minCoeff() > 0))
    throw std::invalid_argument("places in one line, or one alone, span no surface");
  const ScatteredSurface surface(points, at_windows.value, how);
  const double step = box.sizes().maxCoeff() / 60;
  Field field;
  field.scene = scene;
  field.metric = at_windows.metric;
  field.unit = at_windows.unit;
  const Samples samples =
      make_samples({{"", VolumeSampling{{box.min().x(), box.min().y(), height},
                                        {box.max().x(), box.max().y(), height},
                                        Eigen::Vector3d::Constant(step)}}});
  for (const Eigen::Vector3d& p : samples.points) {
    const double value = surface.at(p.head<2>());
    add_value(field, p, std::isfinite(value) ? value : kInfinity);
  }
  field.samples.parts = samples.parts;
  field.evaluated = samples.points.size();
  return field;
}

}  // namespace delos::measured
