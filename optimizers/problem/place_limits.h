// The constraints that only the places and numbers of a scene decide.
#pragma once

#include <functional>
#include <vector>

#include "delos/geometry/region.h"
#include "delos/optimize/problem.h"

namespace delos {

/// All constraints of a scene but those on metrics, as inequalities slack ≥ 0.
class GeometryLimits {
 public:
  explicit GeometryLimits(const Design& design);

  [[nodiscard]] const std::vector<Limit>& limits() const { return limits_; }
  /// Slacks of the design as it is set, in units of the constraint, one a limit.
  void slacks(const Scene& scene, double* out) const;

 private:
  void add(std::size_t constraint, const KeepInside& keep, const Scene& scene);
  void add(std::size_t constraint, const KeepApart& keep, const Scene& scene);
  void add(std::size_t constraint, const KeepTilt& keep, const Scene& scene);
  void add(std::size_t constraint, const KeepClear& keep, const Scene& scene);
  void add(std::size_t constraint, const KeepSum& keep, const Design& design);
  void push(std::size_t constraint, double scale,
            std::function<double(const std::vector<Pose>&)> slack);

  std::vector<Limit> limits_;
  std::vector<std::function<double(const std::vector<Pose>&)>> slacks_;
};

}  // namespace delos
