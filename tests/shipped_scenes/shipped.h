// The scenes of the source tree, loaded and evaluated.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "delos/field/evaluate.h"
#include "delos/scene/definition.h"
#include "delos/scene/io.h"

namespace delos::test {

inline PluginRegistry& plugins() {
  static PluginRegistry registry({DELOS_PLUGINS});
  return registry;
}

inline Scene load(const std::string& name, const std::vector<Override>& changes = {}) {
  Diagnostics findings;
  const auto scene = load_scene(std::string(DELOS_SCENES) + "/" + name + ".yaml",
                                changes, plugins(), findings);
  for (const Diagnostic& finding : findings) ADD_FAILURE() << to_string(finding);
  return scene.value();
}

inline Scene scene_of(const std::string& text,
                      const std::vector<Override>& changes = {}) {
  Diagnostics findings;
  const auto scene = parse_scene(text, "scene.yaml", changes, plugins(), findings);
  for (const Diagnostic& finding : findings) ADD_FAILURE() << to_string(finding);
  return scene.value();
}

/// A scene's field over samples, its own where none are given.
inline Field field_of(const Scene& scene, Samples samples = {}) {
  const System system = build_system(scene, plugins());
  if (samples.points.empty()) samples = make_samples(scene.samples);
  const auto metric = parse_metric(scene.metric, covariance_layout(scene));
  return evaluate_field(system, samples, scene.orientations, std::get<Metric>(metric),
                        {.threads = 2});
}

inline Field field_of(const std::string& name,
                      const std::vector<Override>& changes = {}) {
  return field_of(load(name, changes));
}

/// A metric of a scene at its first sample.
inline double value_of(Scene scene, const std::string& metric) {
  scene.metric = metric;
  return field_of(scene).value.at(0);
}

/// The samples at which a field is within `slack` (relative) of a value.
inline std::vector<Eigen::Vector3d> where(const Field& field, double value,
                                          double slack = 1e-9) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    if (std::abs(field.value[i] - value) <= slack * value) {
      points.push_back(field.samples.points[i]);
    }
  }
  return points;
}

/// The field at the sample nearest to a point, which must be one.
inline double value_at(const Field& field, const Eigen::Vector3d& point) {
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    if ((field.samples.points[i] - point).norm() < 1e-9) return field.value[i];
  }
  ADD_FAILURE() << "no sample at " << point.transpose();
  return NAN;
}

/// True where x and y are both at an end of [0, side].
inline bool in_corner(const Eigen::Vector3d& p, double side) {
  const auto end = [&](double c) { return c < 1e-9 || c > side - 1e-9; };
  return end(p.x()) && end(p.y());
}

}  // namespace delos::test
