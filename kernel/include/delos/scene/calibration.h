// How well a device is known: constant errors that no filter removes unless it
// estimates them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

namespace delos {

/// Which part of an error is meant. Scatter is what P∞ says; bias is what constant
/// errors of calibration do to the estimate, as a covariance over all rigs that could
/// have been built so; total is their sum.
enum class ErrorPart { total, scatter, bias };

/// Standard deviations of constant errors, which are independent of each other. What is
/// estimated instead is a state of the device's.
struct Calibration {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();        ///< along its axes, metres
  Eigen::Vector3d orientation = Eigen::Vector3d::Zero();  ///< about its axes, radians
  double offset = 0;  ///< of each of its readings, in their SI unit
  double scale = 0;   ///< of all its readings, as a part of each: a speed of sound
  double delay = 0;   ///< by how much they are older than taken for, seconds
  std::vector<std::pair<std::string, double>> params;  ///< of its parameters, SI

  /// Whether nothing is off.
  [[nodiscard]] bool exact() const {
    return place.isZero(0) && orientation.isZero(0) && offset == 0 && scale == 0 &&
           delay == 0 && params.empty();
  }
  friend bool operator==(const Calibration&, const Calibration&) = default;
};

/// Errors that several devices have in common: a rig put up wrong as one, one clock,
/// one speed of sound.
struct CommonError {
  std::string name;
  std::vector<std::string> devices;  ///< in the world; empty: all, or the group's
  /// About whose origin they are turned, and along whose axes `of` is; empty: the
  /// world's.
  std::string group;
  Calibration of;  ///< without `params`; one offset is that of every reading
  friend bool operator==(const CommonError&, const CommonError&) = default;
};

}  // namespace delos
