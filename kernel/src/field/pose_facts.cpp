#include "field/pose_facts.h"

#include <algorithm>
#include <cmath>

#include "delos/model/infinity.h"
#include "delos/model/metric_expression.h"

namespace delos {

PoseFacts facts_of(const System& system, const LayerBlock& block, int lane,
                   const TargetPose& pose, bool with_footprint,
                   const Eigen::Vector3d& normal) {
  PoseFacts facts{0, kInfinity, pose.p};
  for (std::size_t i = 0; i < block.seen.size(); ++i) {
    if (!(block.seen[i] >> lane & 1)) continue;
    ++facts.seen;
    const PlacedDevice& placed = system.devices[i];
    if (!with_footprint || placed.carried()) continue;
    const Pose& X_WS = placed.X_WS();
    const Eigen::Vector3d line = pose.p - X_WS.p;
    const double own = placed.device->footprint(X_WS.R.transpose() * line);
    if (!(own > 0)) continue;
    // A surface is as much longer as it leans away from the sight line.
    const double facing = normal.isZero() ? 1 : std::abs(normal.dot(line.normalized()));
    facts.footprint = std::min(facts.footprint, own / facing);
  }
  return facts;
}

bool reads_linearisation(const Metric& metric) {
  return reads(metric, MetricKind::nonlinearity) ||
         reads(metric, MetricKind::unscented_ratio);
}

void add_linearisation(const FusedState& state, const TargetPose& pose,
                       LinearisationCheck& check, PoseFacts& facts) {
  if (state.status != RiccatiStatus::converged) return;  // has no value anyway
  const Linearisation at =
      check.at(pose, state.worst_prior.size() > 0 ? state.worst_prior : state.prior);
  facts.nonlinearity = at.nonlinearity;
  facts.unscented_ratio = at.unscented_ratio;
}

}  // namespace delos
