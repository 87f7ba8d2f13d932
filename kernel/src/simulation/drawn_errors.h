// What a run's devices are off by.
#pragma once

#include <vector>

#include "delos/observe/reading_model.h"
#include "simulation/random.h"

namespace delos {

/// The devices of a system as one run has them: off by errors of calibration that are
/// drawn at its start, which its filter doesn't know of. Own and common ones, as
/// `Calibration` and `CommonError` say.
class DrawnErrors {
 public:
  DrawnErrors(const System& system, const TargetPose& about, int states);
  DrawnErrors(const DrawnErrors&) = delete;
  DrawnErrors& operator=(const DrawnErrors&) = delete;

  void draw(RunRandom& random);

  /// What a device that is off would read, noiseless.
  /// @param seen memory
  /// @returns false where that device doesn't see the target
  [[nodiscard]] bool read(const TrackReading& reading, const StateVector& x,
                          const Eigen::Matrix3d& R, PredictedReading& seen,
                          decltype(Observation::z)& z);

 private:
  /// Of one device.
  struct Drawn {
    std::vector<double> params;  ///< deviations of its doubtful parameters
    decltype(Observation::z) offsets;
    double scale = 0, delay = 0;
  };
  void draw_own(PlacedDevice& placed, Drawn& drawn, RunRandom& random);
  void draw_common(std::size_t number, RunRandom& random);

  const System& system_;
  System errant_;  ///< its devices stand where they stand in truth
  ReadingModel model_;
  std::vector<Drawn> drawn_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  ///< of the target
  PredictedReading beside_;
};

}  // namespace delos
