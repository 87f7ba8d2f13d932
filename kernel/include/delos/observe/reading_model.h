// What devices read of a target in any state, and what its state's errors do to it.
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "delos/api.h"
#include "delos/device/device.h"
#include "delos/rig/system.h"

namespace delos {

/// Add a small change to an estimate, or an error to a truth: x + δ, exp(δθ) R.
DELOS_API void move_state(const StateLayout& layout, const StateVector& change,
                          StateVector& x, Eigen::Matrix3d& R);

/// One answer of a device about one marker or beacon, with its noise.
struct TrackReading {
  int device = 0;
  int view = 0;                ///< of a device that sees beacons
  std::size_t of = 0;          ///< which marker, or which beacon of the device's index
  StateBlock block;            ///< the states that the pose that it is of begins with
  decltype(Observation::z) z;  ///< m×1, measurement units
  bool without_sight = false;  ///< it came through what stands in its way
};

/// A reading as a state has it.
struct PredictedReading {
  decltype(Observation::z) z;  ///< m×1, noiseless
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMaxRows,
                kMaxState>
      H;                       ///< m×N, ∂z/∂(state)
  decltype(Observation::R) R;  ///< m×m
  Target target;               ///< what the device was asked about
  Observation answer;          ///< what it said
};

/// What devices would read of a target in any state: z and its Jacobian.
///
/// Of sensors of motion on the target, which fields know at rest alone, with what its
/// turning adds: v + ω×l and a + α×l + ω×(ω×l) at an arm l, along axes that turn.
class DELOS_API ReadingModel {
 public:
  /// @param system kept by reference
  /// @param about X_WT that states deviate from
  /// @param states N
  ReadingModel(const System& system, const TargetPose& about, int states)
      : system_(system), about_(about), states_(states) {}

  /// Ask a reading's device about a state. Sight isn't tested.
  /// @param reading its z isn't read
  /// @returns false where that state is out of the device's view
  /// @throws DeviceFault
  [[nodiscard]] bool predict(const TrackReading& reading, const StateVector& x,
                             const Eigen::Matrix3d& R, PredictedReading& out) const;

  /// The target's pose that a reading is of.
  [[nodiscard]] TargetPose pose_of(const StateBlock& block, const StateVector& x,
                                   const Eigen::Matrix3d& R) const;

  /// What a reading differs by from another of its device, a − b: of rows that come
  /// back to themselves the least that leads there.
  /// @param a, b m×1, measurement units
  [[nodiscard]] decltype(Observation::z) difference(
      int device, const decltype(Observation::z)& a,
      const decltype(Observation::z)& b) const;

  [[nodiscard]] const System& system() const { return system_; }
  [[nodiscard]] int states() const { return states_; }

 private:
  bool predict_motion(const PlacedDevice& placed, const TargetPose& X_WT,
                      const StateVector& x, PredictedReading& out) const;

  const System& system_;
  TargetPose about_;
  int states_;
};

}  // namespace delos
