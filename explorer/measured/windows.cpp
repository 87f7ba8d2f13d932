#include "measured/windows.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "delos/model/infinity.h"
#include "delos/sampling/sets.h"

namespace delos::measured {

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

const char* to_string(ScatteredMethod method) {
  switch (method) {
    case ScatteredMethod::nearest:
      return "nearest";
    case ScatteredMethod::linear:
      return "linear";
    case ScatteredMethod::natural_neighbour:
      return "natural-neighbour";
    case ScatteredMethod::inverse_distance:
      return "inverse-distance";
    case ScatteredMethod::minimum_curvature:
      return "minimum-curvature";
  }
  return "";
}

Field measured_surface(const std::vector<Window>& windows, ScatteredMethod method,
                       const std::string& scene) {
  std::vector<Eigen::Vector2d> points;
  std::vector<double> values;
  Eigen::AlignedBox2d box;
  double height = 0;
  for (const Window& w : windows) {
    points.emplace_back(w.p.head<2>());
    values.push_back(w.measured);
    box.extend(points.back());
    height += w.p.z() / static_cast<double>(windows.size());
  }
  if (!(box.sizes().minCoeff() > 0))
    throw std::invalid_argument("places in one line, or one alone, span no surface");
  const ScatteredSurface surface(points, values, method);
  const double step = box.sizes().maxCoeff() / 60;
  Field field;
  field.scene = scene;
  field.metric = "measured scatter";
  field.unit = "m";
  field.samples =
      make_samples({{"", VolumeSampling{{box.min().x(), box.min().y(), height},
                                        {box.max().x(), box.max().y(), height},
                                        Eigen::Vector3d::Constant(step)}}});
  for (const Eigen::Vector3d& p : field.samples.points) {
    const double value = surface.at(p.head<2>());
    field.value.push_back(std::isfinite(value) ? value : kInfinity);
    field.observable.push_back(std::isfinite(value));
    field.lost.push_back(0);
  }
  field.evaluated = field.samples.points.size();
  return field;
}

}  // namespace delos::measured
