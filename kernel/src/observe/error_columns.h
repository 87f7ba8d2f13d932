// What each constant error of a device does to its answer.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "observe/measure.h"

namespace delos {

/// Most errors of one device: of its place, how it is turned and each of its readings,
/// and as many of its parameters as are left.
inline constexpr int kMaxErrors = 64;

/// Errors that are drawn once, of one device alone or of several.
struct ErrorSource {
  const Calibration* known;
  std::span<const DoubtfulParameter> doubtful = {};  ///< of one device alone
  /// In common: along the axes and about the origin of X_WF, and one offset for all
  /// readings. Null: of one device, along its own axes, and an offset for each reading.
  const Pose* X_WF = nullptr;
};

/// What is reused from one pose to the next; stored inline, so that no loop allocates.
struct CalibrationScratch {
  template <int rows>
  using ErrorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic,
                                    Eigen::ColMajor, rows, kMaxErrors>;
  MeasureScratch measure;
  Observation beside;          ///< of a device whose parameter is a little off
  ErrorMatrix<kMaxState> G;    ///< c×k, of one device
  ErrorMatrix<kMaxState> all;  ///< c×k, of several
  ErrorMatrix<kMaxRows> J;     ///< m×k
  StateMatrix of_source;       ///< c×c
};

/// Which columns of J are of which errors; −1: not in doubt.
struct ErrorColumns {
  int place = -1, orientation = -1, params = -1, offset = -1, scale = -1, delay = -1;
  int size = 0;

  /// @param rows that the device reports of a point
  ErrorColumns(const System& system, const ErrorSource& source, int rows);
};

/// What a target that is fast in any direction, along each of three axes, goes in a
/// delay: metres, one standard deviation.
[[nodiscard]] double lag_along_an_axis(const System& system, const Calibration& known);

/// What one standard deviation of each error does to an answer. Where the device moves
/// by δ and turns by φ about a point c, the target goes the other way, and where it is
/// read τ late it was v τ behind:
///
///     p_S → p_S − δ + (p_S − c) × φ − v τ,   R_ST → exp(−φ) R_ST
///
/// @param turns whether columns 3 to 5 of H are of the target's orientation
void fill_errors(const System& system, const PlacedDevice& placed,
                 const ErrorSource& source, const ErrorColumns& columns, bool turns,
                 CalibrationScratch& scratch);

}  // namespace delos
