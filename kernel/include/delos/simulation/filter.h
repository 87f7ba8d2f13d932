// Filters that follow a simulated target, and what they are told.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "delos/api.h"
#include "delos/device/device.h"
#include "delos/rig/system.h"

namespace delos {

/// What a filter believes. A state x is the deviation from a pose X_WT that the
/// simulation is about: its position coordinates from there, its derivatives from rest;
/// behind the n states of the motion stand the means that exposing devices read, as
/// steady/windows.h has them.
struct TrackEstimate {
  StateVector x;  ///< N×1, SI
  /// R_WT. Turns are kept here; those in x are only ever added to.
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  StateMatrix P;  ///< N×N, of the error, of turns [δθ] with R_true = exp(δθ) R
};

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

  [[nodiscard]] const System& system() const { return system_; }
  [[nodiscard]] int states() const { return states_; }

 private:
  bool predict_motion(const PlacedDevice& placed, const TargetPose& X_WT,
                      const StateVector& x, PredictedReading& out) const;

  const System& system_;
  TargetPose about_;
  int states_;
};

/// What an update made of its readings.
struct Innovation {
  /// Σ νᵀ S⁻¹ ν of the readings, S = H P Hᵀ + R by the P before them: χ² with `rows`
  /// degrees of freedom where the filter is right.
  double nis = 0;
  int rows = 0;     ///< that were used
  int dropped = 0;  ///< readings that the estimate has out of view
};

/// How a filter takes in readings.
class DELOS_API TrackFilter {
 public:
  virtual ~TrackFilter();
  /// The update of one instant. Reentrant; nothing from the heap.
  [[nodiscard]] virtual Innovation update(const ReadingModel& model,
                                          std::span<const TrackReading> readings,
                                          TrackEstimate& estimate) const = 0;
};

/// The filters that there are.
enum class FilterKind {
  extended,    ///< all readings linearised at the predicted state
  iterated,    ///< the same about their own result: Gauss–Newton, at most 8 times
  sequential,  ///< one reading after another, each linearised at the latest state
  unscented,   ///< one after another, by 2N + 1 points of the covariance
};

[[nodiscard]] DELOS_API const char* to_string(FilterKind kind);

/// Sources: Jazwinski (1970), Stochastic processes and filtering theory, ch. 8
/// (extended); Bell, Cathey (1993), IEEE TAC 38(2), 294–297, doi:10.1109/9.250476
/// (iterated); Welch, Bishop (1997), SCAAT, SIGGRAPH '97, doi:10.1145/258734.258876
/// (sequential); Julier, Uhlmann (2004), Proc. IEEE 92(3), 401–422,
/// doi:10.1109/JPROC.2003.823141 (unscented).
[[nodiscard]] DELOS_API std::unique_ptr<const TrackFilter> make_filter(FilterKind kind);

}  // namespace delos
