// The motion from instant to instant of a simulation, for targets and for filters.
#pragma once

#include <span>
#include <vector>

#include "delos/rig/schedule.h"
#include "delos/rig/system.h"
#include "delos/simulation/filter.h"
#include "simulation/random.h"

namespace delos {

/// What leads to one instant of the cycle, and who reports there.
struct SimulatedSlot {
  MotionStep motion;  ///< N×N
  StateMatrix root;   ///< L, L Lᵀ = Q
  double interval;    ///< seconds
  std::vector<int> devices;
  std::vector<StateBlock> blocks;  ///< what each of them reads
};

/// Predict an estimate over a step of the motion.
///
/// States that turn in space go on by R ← exp(Δθ) R with Δθ what the motion adds to θ,
/// noise included. An error δθ, R_true = exp(δθ) R, is turned with the estimate:
///
///     δθ⁺ = exp(Δθ) δθ + J δ(Δθ),   J = I + [Δθ]/2 + [Δθ]²/6 + O(Δθ³)
///
/// which at rest is A again.
void predict_state(const StateLayout& layout, const MotionStep& motion,
                   TrackEstimate& estimate);

/// A cycle of instants.
class MotionSteps {
 public:
  /// @throws std::invalid_argument as ExposureWindows
  MotionSteps(const System& system, std::span<const UpdateSlot> slots);

  [[nodiscard]] const SimulatedSlot& slot(std::size_t instant) const {
    return slots_[instant % slots_.size()];
  }
  [[nodiscard]] std::size_t slots() const { return slots_.size(); }
  [[nodiscard]] double cycle() const { return cycle_; }  ///< seconds
  [[nodiscard]] int states() const { return states_; }   ///< N

  /// Predict over the interval that leads to an instant.
  void predict(std::size_t instant, TrackEstimate& estimate) const {
    predict_state(layout_, slot(instant).motion, estimate);
  }

 private:
  std::vector<SimulatedSlot> slots_;
  double cycle_ = 0;
  int states_ = 0;
  StateLayout layout_;
};

/// A target at each instant, from before the first one: state and R_WT.
struct DrawnPath {
  std::vector<StateVector> x;
  std::vector<Eigen::Matrix3d> R;
};

/// Draws targets that move by a system's motion.
class TargetDraws {
 public:
  /// @param instants how many a path has, besides its start
  TargetDraws(const System& system, const TargetPose& about, const MotionSteps& steps,
              std::size_t instants);
  /// @param given the target is there, at t seconds from the start of every instant;
  /// null: its motion is drawn
  void draw(RunRandom& random, const std::vector<StateVector>* given,
            DrawnPath& path) const;

 private:
  const System& system_;
  TargetPose about_;
  const MotionSteps& steps_;
  std::size_t instants_;
  int target_states_;          // those that no device owns
  bool ends_at_pose_;          // else it begins there
  StateMatrix back_to_start_;  // Φ⁻¹ of all steps, of those states
};

}  // namespace delos
