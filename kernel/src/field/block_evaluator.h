// A metric at the poses of one block of layers.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "delos/steady/state_metric.h"
#include "delos/steady/steady_solver.h"
#include "field/linearisation.h"
#include "field/pose_facts.h"
#include "steady/bias.h"

namespace delos {

/// Metric and observability at one pose.
struct PoseValue {
  double value = std::numeric_limits<double>::infinity();
  bool observable = false;
  int lost = 0;  ///< directions of the pose that aren't observed
};

/// Evaluates the poses of one block; one a thread.
class BlockEvaluator {
 public:
  /// What is passed is kept by reference.
  BlockEvaluator(const SteadySolver& solver, const System& system,
                 const Metric& metric);

  /// @param poses, values block.lanes each
  /// @param normals of the surfaces that the poses are on, see facts_of(); null: none
  void operator()(const LayerBlock& block, const TargetPose* poses, PoseValue* values,
                  const Eigen::Vector3d* normals = nullptr);

 private:
  PoseValue solved_value(const LayerBlock& block, int lane, const TargetPose& pose,
                         const Eigen::Vector3d& normal);

  const SteadySolver& solver_;
  const System& system_;
  const Metric& metric_;
  MetricNeed need_;
  bool with_facts_, with_footprint_;  // what lanes need besides P
  SteadyRequest request_;
  SteadyEquation equation_;
  std::vector<double> P_;
  double value_[kLanes] = {};
  PoseFacts facts_[kLanes];
  int lost_[kLanes] = {};
  FusedState state_;
  std::optional<BiasSolver> bias_;  // where numbers count it
  StateMatrix information_;         // of the pose, which solving may divide into rows
  std::optional<LinearisationCheck> linearisation_;  // where the metric reads it
};

/// The values of several orientations at one point become one.
/// @param values `turns` of them, ≥ 1
[[nodiscard]] PoseValue combined(const PoseValue* values, std::size_t turns,
                                 OrientationRule rule, bool larger_is_better);

}  // namespace delos
