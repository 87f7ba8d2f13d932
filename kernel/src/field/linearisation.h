// How far devices' readings are from linear over the error of a tracked target.
#pragma once

#include <vector>

#include "delos/api.h"
#include "delos/observe/reading_model.h"
#include "observe/beacon_sightings.h"
#include "observe/unscented.h"

namespace delos {

/// How much P∞, which takes readings for linear, is to be trusted at a pose.
struct Linearisation {
  /// Of the reading that is off most, what linearising leaves out over the error before
  /// an update, root mean square, in standard deviations of the reading's noise.
  double nonlinearity = 0;
  /// After one reading of every device: √trace of the pose block by points of the
  /// covariance, over the same by linearising.
  double unscented_ratio = 1;
};

/// Works them out; one a thread.
///
/// A whitened reading with the second derivative G is off by ρ = ½ eᵀG e, of which over
/// e ~ N(0, P), P = L Lᵀ, and with M = Lᵀ G L
///
///     E[ρ²] = (½ tr M)² + ½ tr(M²)
///
/// G comes from differences of the devices' own Jacobians. Of a range of r and an error
/// s across it ρ = √(r² + s²) − r ≈ s²/2r: Eq. 52 of Allen (2007), with s for v δt.
/// Sources: Bar-Shalom, Li, Kirubarajan (2001), §10.3.3; Allen (2007), §6.1.1.
class DELOS_API LinearisationCheck {
 public:
  /// @param system kept by reference
  explicit LinearisationCheck(const System& system) : system_(system) {}

  /// @param P before an update, n×n; not finite: so is the answer
  /// @throws DeviceFault
  [[nodiscard]] Linearisation at(const TargetPose& pose, const StateMatrix& P);

 private:
  double largest_remainder(const ReadingModel& model, const TrackReading& reading,
                           const Eigen::Matrix3d& R, const StateMatrix& L);
  void update_both(const ReadingModel& model, const TrackReading& reading, double share,
                   const Eigen::Matrix3d& R);

  const System& system_;
  BeaconSearch beacons_;
  PredictedReading middle_, ahead_, behind_;
  std::vector<StateMatrix> bent_;   // M of each row
  std::vector<double> variance_;    // of each row
  StateMatrix linear_, by_points_;  // P after the readings so far
  UnscentedMoments moments_;
};

}  // namespace delos
