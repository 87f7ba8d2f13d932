// What constant errors of the devices' calibration do to their readings.
#pragma once

#include "observe/error_columns.h"

namespace delos {

/// How an estimate weighs readings: by their information, as the best does, or all
/// alike, as plain least squares does.
enum class RowWeights { information, plain };

/// G C Gᵀ of one device's own errors at one pose, where its readings are off by J c,
/// c ~ N(0, C),
///
///     G = w Σ Hᵀ R⁻¹ J,   w = information_weight()
///
/// over all rows that it measures there: its k errors are the same in all of them.
/// Where it stands and how it is turned needs no help from plugins: moving a device is
/// moving the target the other way, as a delay is. A parameter's slope is the
/// difference of two noiseless readings.
/// @param weights plain: G = Σ Hᵀ J of one reading
/// @param[out] scratch.of_source c×c with c = information_size(); 0 where it sees
///             nothing
/// @throws DeviceFault
void find_calibration(const System& system, const PlacedDevice& placed,
                      const TargetPose& X_WT, CalibrationScratch& scratch,
                      RowWeights weights = RowWeights::information);

/// The same of errors that devices have in common, whose G add up before they are
/// squared.
/// @param number which of the system's
void find_common_error(const System& system, std::size_t number, const TargetPose& X_WT,
                       CalibrationScratch& scratch,
                       RowWeights weights = RowWeights::information);

/// g gᵀ of what readings without sight are late by, g = w Σ Hᵀ R⁻¹ b of all devices:
/// they don't know of it, and are late together.
void find_lateness(const System& system, const TargetPose& X_WT,
                   CalibrationScratch& scratch,
                   RowWeights weights = RowWeights::information);

/// All of these, which are independent: D = Σ G C Gᵀ, c×c.
[[nodiscard]] StateMatrix calibration_spread(
    const System& system, const TargetPose& X_WT, CalibrationScratch& scratch,
    RowWeights weights = RowWeights::information);

}  // namespace delos
