// What was measured beside what is predicted there.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "delos/rig/system.h"
#include "measured/readings.h"

namespace delos::measured {

/// One way of the target, as a tracker had it.
struct MeasuredPath {
  std::string name;
  std::vector<double> t;               ///< seconds, rising
  std::vector<Eigen::Vector3d> p;      ///< metres, finite
  std::vector<Eigen::Vector3d> truth;  ///< of each, or empty
};

/// A path: bias and scatter apart, in metres along x, y and z.
struct PathComparison {
  std::string name;
  std::size_t places = 0;
  /// Of the difference to the truth the curve's root mean square; nothing without one.
  std::optional<Eigen::Vector3d> bias;
  Eigen::Vector3d scatter;    ///< about the curve, of the difference or of the path
  Eigen::Vector3d predicted;  ///< root mean square of P∞'s, where it is finite
  std::size_t blind = 0;      ///< places without a finite P∞, in neither
};

/// A place, and how far off the curve it is.
struct ScatteredPlace {
  Eigen::Vector3d p;
  double measured;   ///< ‖scatter‖, metres
  double predicted;  ///< σ of the position by P∞; +∞ where it has none
};

struct PosesComparison {
  std::vector<PathComparison> paths;
  Eigen::Vector3d scatter, predicted;  ///< root mean square over all places
  std::vector<ScatteredPlace> places;
};

/// Fit a curve along each path, and hold what scatters against P∞ at its places.
/// @param degree of the curves
/// @param rpy the target's orientation, radians
/// @returns it, or a sentence that says why not
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] std::variant<PosesComparison, std::string> compare_poses(
    const System& system, const std::vector<MeasuredPath>& paths, int degree,
    const Eigen::Vector3d& rpy = Eigen::Vector3d::Zero());

/// What a device's readings are off by, in its own unit, in their first row.
struct DeviceComparison {
  std::string name;
  std::size_t readings = 0;
  double rate = 0;         ///< 1 / their median interval; 0 of fewer than two
  double scene_rate = 0;   ///< what the scene says
  double bias = 0;         ///< mean of z − h(truth)
  double scatter = 0;      ///< about that mean
  double predicted = 0;    ///< √ of the mean R there
  double correlation = 0;  ///< of neighbours; of white noise within 2/√readings of 0
};

/// A filter over the readings beside the truth.
struct TrackComparison {
  Eigen::Vector3d bias, scatter;  ///< of its places, metres
  Eigen::Vector3d predicted;  ///< P∞'s σ there, root mean square; NaN where blind
  Eigen::Vector3d filter;     ///< its own σ
  double nees = 0;            ///< of the estimated positions, in the mean
  double nees_expected = 0;   ///< their number
};

struct ReadingsComparison {
  std::vector<DeviceComparison> devices;  ///< in the order of the scene
  std::optional<TrackComparison> track;   ///< where the truth is known
  double nis = 0;  ///< νᵀ S⁻¹ ν a row of the readings, of which 1 is expected
  std::size_t instants = 0, with_truth = 0;
  std::size_t dropped = 0;  ///< readings out of the estimate's view
  double longest_gap = 0;   ///< seconds without a reading
};

/// @param at where the target is thought to be before the first reading, and how it is
///        turned; where the truth is known there, it is taken instead
/// @param skip seconds of the beginning that the track's numbers leave out
/// @param debias take each device's mean off its readings first
/// @returns it, or a sentence that says why not
/// @throws std::invalid_argument as make_steady_solver(), track_readings()
[[nodiscard]] std::variant<ReadingsComparison, std::string> compare_readings(
    const System& system, const Eigen::Vector3d& at, const Eigen::Vector3d& rpy,
    const Readings& readings, const TrackFilter& filter, double skip, bool debias);

}  // namespace delos::measured
