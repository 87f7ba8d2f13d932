// A metric at places where the target is tried in several orientations.
#pragma once

#include <span>
#include <vector>

#include "delos/model/pose.h"
#include "delos/sampling/sets.h"
#include "field/block_evaluator.h"
#include "layers/block.h"

namespace delos {

/// R_WT of each orientation.
[[nodiscard]] inline std::vector<Eigen::Matrix3d> rotations(
    const Orientations& orientations) {
  std::vector<Eigen::Matrix3d> turns;
  turns.reserve(orientations.rpy.size());
  for (const Eigen::Vector3d& rpy : orientations.rpy)
    turns.push_back(rotation_from_rpy(rpy));
  return turns;
}

/// Evaluates up to kLanes places at a time; one a thread.
class PlaceEvaluator {
 public:
  /// What is passed is kept by reference.
  PlaceEvaluator(const SteadySolver& solver, const System& system, const Metric& metric,
                 OrientationRule rule, std::size_t turns)
      : evaluate_(solver, system, metric),
        rule_(rule),
        larger_is_better_(metric.larger_is_better),
        turns_(turns),
        shape_(system),
        all_(turns * kLanes) {}

  /// @param layers(turn) the places' layers at one orientation, by reference
  /// @param poses(turn) the places' poses, in the same order
  /// @param[out] values one a place
  /// @param normals one a place, see facts_of(); null: none
  template <class Layers, class Poses>
  void operator()(std::size_t places, Layers&& layers, Poses&& poses, PoseValue* values,
                  const Eigen::Vector3d* normals = nullptr) {
    if (rule_ == OrientationRule::information) {
      clear_block(shape_, static_cast<int>(places), mean_);
      for (std::size_t t = 0; t < turns_; ++t) add_to_mean(layers(t));
      sum_layers(shape_, mean_);
      evaluate_(mean_, poses(0), values, normals);
      return;
    }
    for (std::size_t t = 0; t < turns_; ++t) {
      const LayerBlock& block = layers(t);
      evaluate_(block, poses(t), of_turn_, normals);
      for (std::size_t l = 0; l < places; ++l) all_[l * turns_ + t] = of_turn_[l];
    }
    for (std::size_t l = 0; l < places; ++l) {
      values[l] = combined(&all_[l * turns_], turns_, rule_, larger_is_better_);
    }
  }

 private:
  // E[S] = Σ_t S_t / turns: what is seen in half of the orientations informs half as
  // much. Source: Chen (2002), Design of many-camera tracking systems, Stanford, who
  // models self-occlusion so.
  void add_to_mean(const LayerBlock& block) {
    const double share = 1 / static_cast<double>(turns_);
    for (std::size_t e = 0; e < mean_.layers.size(); ++e) {
      mean_.layers[e] += share * block.layers[e];
    }
    for (std::size_t i = 0; i < mean_.seen.size(); ++i) {
      mean_.seen[i] |= block.seen[i];
      mean_.perfect[i] |= block.perfect[i];
    }
  }

  BlockEvaluator evaluate_;
  OrientationRule rule_;
  bool larger_is_better_;
  std::size_t turns_;
  LayerShape shape_;
  LayerBlock mean_;
  PoseValue of_turn_[kLanes];
  std::vector<PoseValue> all_;
};

}  // namespace delos
