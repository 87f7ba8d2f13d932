#include "session/ellipsoids.h"

#include "delos/geometry/occluders.h"
#include "delos/layers/layers.h"
#include "delos/model/symmetric.h"
#include "delos/steady/steady_solver.h"
#include "session/description.h"
#include "session/drawn_field.h"

namespace delos::session {
namespace {

/// Parts of a lost direction below which it leaves the position alone.
constexpr double kNoPart = 1e-6;

bool in_space(const StateLayout& layout) {
  return layout.pose == PoseState::position || layout.pose == PoseState::pose;
}

/// Points of a lattice over the samples' box.
Samples lattice_over(const Scene& scene, std::size_t most) {
  const Eigen::AlignedBox3d box = sample_box(scene);
  return make_samples({{"", grid_over(box.min(), box.max(), most)}});
}

}  // namespace

Json ellipsoid_json(const System& system, const FusedState& state) {
  if (!in_space(system.motion.layout) || state.status != RiccatiStatus::converged)
    return {};
  const StateMatrix& P = state.covariance(system.covariance == CovarianceKind::prior
                                              ? CovarianceKind::prior
                                              : CovarianceKind::posterior);
  if (P.rows() < 3) return {};
  const SymmetricEigen axes = symmetric_eigen(P.topLeftCorner(3, 3));
  return {{"sigma", numbers(axes.values.cwiseMax(0).cwiseSqrt())},
          {"axes", rows(axes.vectors.transpose())}};
}

Json lost_json(const System& system, const FusedState& state) {
  Json lost = Json::array();
  if (!in_space(system.motion.layout)) return lost;
  for (Eigen::Index i = 0; i < state.unobservable.cols(); ++i) {
    const Eigen::Vector3d p = state.unobservable.col(i).head<3>();
    if (p.norm() > kNoPart) lost.push_back(numbers(p.normalized()));
  }
  return lost;
}

Json lattice_json(const LoadedScene& loaded, std::size_t most,
                  const FieldOptions& options) {
  const System& system = loaded.system;
  const Samples samples = lattice_over(loaded.scene, most);
  // Which of them are within solids, a field knows.
  const Field field = evaluate_field(system, samples, loaded.scene.orientations,
                                     loaded.metric, options);
  const std::vector<TargetPose> poses =
      field_poses(samples, {{loaded.scene.orientations.rpy.front()}});
  const InformationLayers layers(system, poses);
  const auto solver = make_steady_solver(system);
  SteadyEquation equation = solver->equation();
  LayerBlock storage;
  Json all = Json::array();
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    if (options.cancel && *options.cancel) break;
    if (!field.inside.empty() && field.inside[i]) continue;
    const LayerBlock& block = layers.block(i / kLanes, storage);
    FusedState state;
    solver->read(block, static_cast<int>(i % kLanes), poses[i], equation);
    solver->solve(equation, {}, state);
    all.push_back({{"at", numbers(samples.points[i])},
                   {"ellipsoid", ellipsoid_json(system, state)},
                   {"lost", lost_json(system, state)}});
  }
  return all;
}

}  // namespace delos::session
