// The front of a scene's objective against one of its limits, while somebody watches.
#pragma once

#include <string>
#include <vector>

#include "delos/optimize/tradeoff.h"
#include "session/job.h"
#include "session/scene_changes.h"

namespace delos::session {

/// `delos tradeoff --limit` (delos/optimize/tradeoff.h). Stopped, it has the best so
/// far; resumed, it begins anew.
class FrontRun final : public Job {
 public:
  /// @param levels of the limit, SI, one or more
  /// @param options their evaluations, starts, seed, samples and threads are used
  /// @throws std::invalid_argument there is no such constraint, or it has no limit
  FrontRun(Scene scene, std::string constraint, std::vector<double> levels,
           OptimizeOptions options, PluginRegistry& plugins);

  /// The values of a point, from the loosest limit on.
  /// @throws std::invalid_argument there is none
  [[nodiscard]] VariableValues point(std::size_t index) const;

  /// {kind: front, phase, message, done, of, front: front_json() once it is there}
  [[nodiscard]] Json json(const Heard& heard) const override;

 private:
  bool advance() override;

  Scene scene_;
  const std::string constraint_;
  const std::vector<double> levels_;
  OptimizeOptions options_;
  PluginRegistry& plugins_;
  // What follows is told: under the mutex.
  std::size_t done_ = 0, of_ = 0;
  Json front_;
  std::vector<VariableValues> points_;
};

}  // namespace delos::session
