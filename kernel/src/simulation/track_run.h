// One run: a target, its readings, a filter, and its errors.
#pragma once

#include <optional>
#include <vector>

#include "delos/simulation/filter.h"
#include "simulation/motion_steps.h"
#include "simulation/reading_draws.h"
#include "simulation/tally.h"

namespace delos {

/// Runs one after another; reentrant with a Memory a thread.
class TrackRuns {
 public:
  /// @param start root of the covariance that filters begin with, N×N
  /// @param given where the target is, or null, as TargetDraws::draw()
  TrackRuns(const System& system, const TargetPose& about, const Expectation& expected,
            const MotionSteps& steps, std::size_t instants, const StateMatrix& start,
            const TrackFilter& filter, std::uint64_t seed,
            const std::vector<StateVector>* given);

  struct Memory {
    Tally own;  ///< of one run, until it is known whether it is lost
    DrawnPath path = {};
    std::vector<TrackReading> readings = {};
    ReadingScratch scratch = {};
    std::optional<DrawnErrors> errors = {};  ///< made in the first run
    TrackEstimate estimate = {};
    std::vector<StateMatrix> looked = {};
  };

  /// @throws DeviceFault
  /// @param[in,out] sums of runs before
  void run(std::uint64_t number, Memory& memory, Tally& sums) const;

 private:
  void tally_instant(const StateVector& error, const TrackEstimate& estimate,
                     InstantTally& out) const;
  void look(std::size_t slot, bool prior, const StateVector& error,
            const TrackEstimate& estimate, Memory& memory, Tally& tally) const;
  [[nodiscard]] StateVector error_of(const StateVector& x, const Eigen::Matrix3d& R,
                                     const TrackEstimate& estimate) const;

  const System& system_;
  TargetPose about_;
  ReadingModel model_;
  const Expectation& expected_;
  const MotionSteps& steps_;
  TargetDraws targets_;
  std::size_t instants_;
  const StateMatrix& start_;
  const TrackFilter& filter_;
  std::uint64_t seed_;
  const std::vector<StateVector>* given_;
  bool draws_errors_;  ///< of calibration
  int n_;
};

}  // namespace delos
