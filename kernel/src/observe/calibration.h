// What constant errors of the devices' calibration do to their readings.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "observe/measure.h"

namespace delos {

/// How an estimate weighs readings: by their information, as the best does, or all
/// alike, as plain least squares does.
enum class RowWeights { information, plain };

/// Most errors of one device: of its place, how it is turned and each of its readings,
/// and as many of its parameters as are left.
inline constexpr int kMaxErrors = 64;

/// What is reused from one pose to the next; stored inline, so that no loop allocates.
struct CalibrationScratch {
  template <int rows>
  using ErrorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic,
                                    Eigen::ColMajor, rows, kMaxErrors>;
  MeasureScratch measure;
  Observation beside;        ///< of a device whose parameter is a little off
  ErrorMatrix<kMaxState> G;  ///< c×k
  ErrorMatrix<kMaxRows> J;   ///< m×k
  StateMatrix of_device;     ///< c×c
};

/// G C Gᵀ of one device at one pose, where its readings are off by J c, c ~ N(0, C),
///
///     G = w Σ Hᵀ R⁻¹ J,   w = information_weight()
///
/// over all rows that it measures there: its k errors are the same in all of them.
/// Where it stands and how it is turned needs no help from plugins: moving a device is
/// moving the target the other way. A parameter's slope is the difference of two
/// noiseless readings.
/// @param weights plain: G = Σ Hᵀ J of one reading
/// @param[out] scratch.of_device c×c with c = information_size(); 0 where it sees
///             nothing
/// @throws DeviceFault
void find_calibration(const System& system, const PlacedDevice& placed,
                      const TargetPose& X_WT, CalibrationScratch& scratch,
                      RowWeights weights = RowWeights::information);

/// The same of all devices, whose errors are independent: D = Σ G C Gᵀ, c×c.
[[nodiscard]] StateMatrix calibration_spread(
    const System& system, const TargetPose& X_WT, CalibrationScratch& scratch,
    RowWeights weights = RowWeights::information);

}  // namespace delos
