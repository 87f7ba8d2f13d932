#include "delos/field/existence.h"

#include <algorithm>

#include "delos/riccati/existence.h"
#include "delos/scene/places.h"
#include "delos/steady/steady_solver.h"
#include "delos/text/words.h"
#include "rig/sight.h"

namespace delos {
namespace {

/// States of which a direction has more than a rounding's part.
std::vector<std::string> states_of(const StateMatrix& directions,
                                   const StateLayout& layout) {
  constexpr double kPart = 1e-6;
  const std::vector<std::string> all = layout.names();
  std::vector<std::string> some;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (directions.row(static_cast<Eigen::Index>(i)).cwiseAbs().maxCoeff() > kPart)
      some.push_back(all[i]);
  return some;
}

}  // namespace

Existence existence(const Scene& scene, const System& system, std::size_t most) {
  Existence found;
  if (system.fusion == Fusion::artemis) return found;
  std::vector<TargetPose> poses = spread_poses(scene, most);
  std::erase_if(
      poses, [&](const TargetPose& pose) { return deep_inside_solid(system, pose.p); });
  const auto solver = make_steady_solver(system);
  const InformationLayers layers(system, poses);
  SteadyEquation equation = solver->equation();
  FusedState state;
  LayerBlock scratch;
  for (std::size_t b = 0; b < layers.block_count(); ++b) {
    const LayerBlock& block = layers.block(b, scratch);
    for (int lane = 0; lane < block.lanes; ++lane) {
      const auto l = static_cast<std::size_t>(lane);
      solver->read(block, lane, poses[b * kLanes + l], equation);
      solver->solve(equation, {}, state);
      ++found.places;
      if (state.unobservable.cols() == 0) ++found.detectable;
    }
  }

  // A motion is driven or not whatever the time between updates is.
  const double period = system.devices.empty() ? 1 : system.devices.front().period;
  const UndrivenModes modes = undriven_modes(discretize(system.motion, period));
  found.stabilizable = modes.directions.cols() == 0;
  found.on_circle = modes.on_circle;
  if (!found.stabilizable)
    found.undriven = states_of(modes.directions, system.motion.layout);
  return found;
}

std::string to_string(const Existence& e) {
  if (e.places == 0) return "";
  const double share =
      static_cast<double>(e.detectable) / static_cast<double>(e.places);
  const std::string text = "detectable at " +
                           (e.detectable == e.places ? std::string("all")
                            : e.detectable == 0      ? std::string("none of the")
                                                     : percent(share) + " of the") +
                           " places tried (" + std::to_string(e.places) + ")";
  if (e.stabilizable) return text + ", stabilizable";
  return text + ", not stabilizable: no noise drives " + listed(e.undriven) +
         (e.on_circle ? ", whose variance goes to 0 ever more slowly"
                      : ", whose variance ends at what the readings leave");
}

}  // namespace delos
