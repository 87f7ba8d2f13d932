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

/// Standard deviations of a device's constant errors, which are independent of each
/// other and of other devices'. What is estimated instead is a state of the device's.
struct Calibration {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();        ///< along its axes, metres
  Eigen::Vector3d orientation = Eigen::Vector3d::Zero();  ///< about its axes, radians
  double offset = 0;  ///< of each of its readings, in their SI unit
  std::vector<std::pair<std::string, double>> params;  ///< of its parameters, SI

  /// Whether nothing is off.
  [[nodiscard]] bool exact() const {
    return place.isZero(0) && orientation.isZero(0) && offset == 0 && params.empty();
  }
  friend bool operator==(const Calibration&, const Calibration&) = default;
};

}  // namespace delos
