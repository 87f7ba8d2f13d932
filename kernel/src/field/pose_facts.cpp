#include "field/pose_facts.h"

#include <algorithm>

#include "delos/model/infinity.h"

namespace delos {

PoseFacts facts_of(const System& system, const LayerBlock& block, int lane,
                   const TargetPose& pose, bool with_footprint) {
  PoseFacts facts{0, kInfinity, pose.p};
  for (std::size_t i = 0; i < block.seen.size(); ++i) {
    if (!(block.seen[i] >> lane & 1)) continue;
    ++facts.seen;
    const PlacedDevice& placed = system.devices[i];
    if (!with_footprint || placed.carried()) continue;
    const Pose& X_WS = placed.X_WS();
    const double own = placed.device->footprint(X_WS.R.transpose() * (pose.p - X_WS.p));
    if (own > 0) facts.footprint = std::min(facts.footprint, own);
  }
  return facts;
}

}  // namespace delos
