// The variables of a scene as a point of the unit cube.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "delos/plugin/registry.h"
#include "delos/scene/number.h"
#include "delos/scene/scene.h"

namespace delos {

/// A scene whose variables are set together. Linear variables run from lower at 0 to
/// upper at 1, logarithmic ones likewise in their logarithm.
class Design {
 public:
  /// @pre the scene came from load_scene()
  Design(const Scene& scene, PluginRegistry& plugins);

  [[nodiscard]] std::size_t size() const { return scene_->variables.size(); }
  [[nodiscard]] const Scene& scene() const { return *scene_; }

  /// The point of the scene as it was given; what is out of bounds is put on them.
  [[nodiscard]] const std::vector<double>& start() const { return start_; }
  /// A sentence for every variable whose value in the scene was out of bounds.
  [[nodiscard]] const std::vector<std::string>& repairs() const { return repairs_; }

  /// Set all variables, and what follows them.
  /// @param x size() numbers; not limited to [0, 1], so that differences may step over
  void set(std::span<const double> x);
  /// Set one of them.
  void set(std::size_t variable, double x);

  /// A number of the scene, by path, that follows set().
  /// @pre there is one
  [[nodiscard]] const double* number(const std::string& path) const;

  /// The value of a variable at x, SI.
  [[nodiscard]] double value(std::size_t variable, double x) const;

 private:
  struct Drive {
    double* number;
    double factor, offset;
  };
  PluginRegistry* plugins_;
  std::unique_ptr<Scene> scene_;            // numbers point into it
  std::vector<std::vector<Drive>> drives_;  // of each variable
  std::vector<double> start_;
  std::vector<std::string> repairs_;
};

}  // namespace delos
