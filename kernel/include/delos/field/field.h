// A metric over the samples of a scene.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/sampling/samples.h"
#include "delos/scene/definition.h"

namespace delos {

/// A metric's value at every sample point.
struct Field {
  std::string scene;              ///< the scene's name
  std::string metric;             ///< the metric's name
  std::string unit;               ///< its SI unit
  Definition definition;          ///< what it is a metric of
  bool larger_is_better = false;  ///< which way the metric is better
  Samples samples;                ///< where
  std::vector<double> value;      ///< one a point; +∞ where it has no finite value
  std::vector<unsigned char>
      observable;  ///< one a point; 1: every direction is observed
  /// One a point: how many directions of the pose aren't observed; the most, of several
  /// orientations. One: one more reading there would do.
  std::vector<unsigned char> lost;
  /// One a point, or empty where no solid is near; 1: within a solid, where no target
  /// can be. Such points are in no statistics.
  std::vector<unsigned char> inside;
  /// One a point, or empty where all count alike: the volume that it stands for, m³.
  std::vector<double> weight;
  /// Of adaptive samples: values at points that are spread over the volume for its
  /// statistics, with weights. Points 2k and 2k + 1 were drawn evenly from one box.
  std::shared_ptr<const Field> spread;
  /// Of adaptive samples: 95th percentile over held-back points of |field/true − 1|.
  std::optional<double> discretization_error;
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

/// What part of a volume is observable, and how sure statistics over it are: errors are
/// the half-widths of 95 % intervals.
struct VolumeStatistics {
  double observable = 0;  ///< part of the volume outside solids
  double observable_error = 0;
  double one_short = 0, one_short_error = 0;  ///< likewise: one direction isn't
  double mean_error = 0, median_error = 0, p95_error = 0;  ///< of FieldStatistics
  /// No larger part of the volume is below the least value, or above the greatest.
  double beyond = 0;
  std::size_t points = 0;  ///< that the statistics are over
};

/// Summary of a field over the samples at which the metric is finite.
struct FieldStatistics {
  bool larger_is_better = false;  ///< as the field
  std::size_t samples = 0;        ///< all outside solids
  std::size_t inside = 0;         ///< within solids: left out
  std::size_t observable = 0;     ///< every direction is observed
  std::size_t one_short = 0;      ///< one direction isn't
  std::size_t finite = 0;  ///< the metric is finite: what the numbers below are over
  Extreme min, max;        ///< the first one where several are equal
  /// By volume, where samples have weights. Percentiles interpolate linearly. 95 % of
  /// the samples are at least as good as p95: where more is better, the 5th percentile.
  double mean = 0, median = 0, p95 = 0;
  /// Of adaptive samples: mean, median and p95 are those of Field::spread, min and max
  /// of both; counts are of the octree's nodes.
  std::optional<VolumeStatistics> volume;

  [[nodiscard]] const Extreme& best() const { return larger_is_better ? max : min; }
  [[nodiscard]] const Extreme& worst() const { return larger_is_better ? min : max; }
};

/// @returns all zero but `samples` where no value is finite.
[[nodiscard]] DELOS_API FieldStatistics summarize(const Field& field);

}  // namespace delos
