// Searches for devices about a target that stays in a plane.
#include "delos/optimize/problem.h"
#include "optimizers/scenes.h"

namespace delos::test {
namespace {

/// Two anchors of 10 cm, 4 m away, of which one may move past the y axis.
Scene two_anchors() {
  return parse(R"(delos: 1
motion: {type: position, state: planar, q: [0.4, 0.4]}
covariance: single
metric: sigma_position
sample: {points: [[0, 0, 0]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [4, 0, 0], params: {sigma: 10 cm}}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [2, 4, 0], params: {sigma: 10 cm}}
variables:
  - {path: devices.b.at.x, lower: -3, upper: 3}
objective: {minimize: mean}
)");
}

// tr (HᵀH)⁻¹ = 2/sin² of the angle between both ranges: √2 · 10 cm where they cross at
// a right one, less what the guess of 10 m below says besides.
TEST(PlaneSearch, TwoRangesCrossAtARightAngle) {
  const OptimizeResult found = search(two_anchors());
  EXPECT_NEAR(found.best.objective, std::sqrt(2 / (100 + 0.01)), 1e-8);
  EXPECT_NEAR(found.scene.devices[1].placement.at.x(), 0, 4e-3);
}

// A hundred times worse than what is seen as a rule: a range knows 1/σ² of its
// direction.
TEST(PlaneSearch, GuessesByTheBlockOfThePlane) {
  EXPECT_NEAR(Problem(two_anchors(), plugins(), {200, 1}).guess(), 100 * 0.1, 1e-9);
}

}  // namespace
}  // namespace delos::test
