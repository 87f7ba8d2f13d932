// A metric over the samples of a scene.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/sampling/samples.h"

namespace delos {

/// A metric's value at every sample point.
struct Field {
  std::string scene;          ///< the scene's name
  std::string metric;         ///< the metric's name
  std::string unit;           ///< its SI unit
  Samples samples;            ///< where
  std::vector<double> value;  ///< one a point; +∞ where it has no finite value
  std::vector<unsigned char>
      observable;               ///< one a point; 1: every direction is observed
  std::size_t evaluations = 0;  ///< poses at which the equation was solved
  int threads = 1;
  double seconds = 0;  ///< wall time of the evaluation
  bool cancelled =
      false;  ///< true: points from `evaluated` on were not reached, value +∞
  std::size_t evaluated = 0;  ///< points that were reached, from the front
};

/// Where and what an extreme value is.
struct Extreme {
  double value = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< world, metres
};

/// Summary of a field over the samples at which the metric is finite.
struct FieldStatistics {
  std::size_t samples = 0;     ///< all
  std::size_t observable = 0;  ///< every direction is observed
  std::size_t finite = 0;  ///< the metric is finite: what the numbers below are over
  Extreme min, max;        ///< the first one where several are equal
  double mean = 0, median = 0, p95 = 0;  ///< percentiles interpolate linearly
};

/// @returns all zero but `samples` where no value is finite.
[[nodiscard]] DELOS_API FieldStatistics summarize(const Field& field);

}  // namespace delos
