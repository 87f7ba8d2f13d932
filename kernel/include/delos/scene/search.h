// What a search may change, what it must keep and what it makes small.
#pragma once

#include <Eigen/Core>
#include <string>
#include <variant>
#include <vector>

#include "delos/device/parameters.h"
#include "delos/scene/robustness.h"

namespace delos {

/// A number of the scene that follows a variable: factor·v + offset.
struct Follower {
  std::string path;
  double factor = 1;
  double offset = 0;  ///< in the number's SI unit
  friend bool operator==(const Follower&, const Follower&) = default;
};

/// A number of the scene that a search may change.
struct VariableEntry {
  std::string path;                       ///< "devices.s1.at.z"
  double lower = 0;                       ///< SI
  double upper = 0;                       ///< SI, > lower
  ParamScale scale = ParamScale::linear;  ///< log needs lower > 0
  std::vector<Follower> followers;        ///< numbers that change with it
  friend bool operator==(const VariableEntry&, const VariableEntry&) = default;
};

/// How the costs of all samples become one number.
enum class Reduction {
  mean,
  p_norm,      ///< (mean of c^p)^(1/p)
  soft_max,    ///< (M/s) log mean exp(s c/M), M the mean of c, s = sharpness
  maximum,     ///< the greatest
  percentile,  ///< the value that a part `level` of the samples stays below
  cvar,        ///< mean of the worst 1 − level of the samples
  fraction,    ///< part of the samples that miss `limit`
};

/// A sample set that an objective is about, and how much it counts.
struct WeightedSet {
  std::string name;
  double weight = 1;  ///< > 0
  friend bool operator==(const WeightedSet&, const WeightedSet&) = default;
};

/// One term of what a search makes small.
struct ObjectiveTerm {
  Reduction reduction = Reduction::mean;
  std::string metric;             ///< empty: the scene's
  bool maximize = false;          ///< for metrics of which more is better
  double weight = 1;              ///< of the term in the sum, > 0
  double power = 8;               ///< p of p_norm, ≥ 1
  double sharpness = 20;          ///< of soft_max, > 0
  double level = 0.95;            ///< of percentile and cvar, in (0, 1)
  double limit = 0;               ///< of fraction, in the metric's SI unit
  std::vector<WeightedSet> over;  ///< empty: all samples alike
  friend bool operator==(const ObjectiveTerm&, const ObjectiveTerm&) = default;
};

/// What a search makes small: a weighted sum of terms.
struct Objective {
  std::vector<ObjectiveTerm> terms;  ///< empty: the mean of the scene's metric
  /// Standard deviation, metres and radians, of a guess that every update adds to each
  /// coordinate of the pose: what no device sees has a finite cost by it. 0: a hundred
  /// times as bad as what one device tells, typically, in the scene as it stands.
  double guess = 0;
  Robustness robust;
  friend bool operator==(const Objective&, const Objective&) = default;
};

/// Constraints, each about devices by name; `devices` is never empty where it stands.
struct KeepInside {  ///< in the region, or outside, at least `margin` metres from it
  std::vector<std::string> devices;
  std::string region;
  bool outside = false;
  double margin = 0;
  friend bool operator==(const KeepInside&, const KeepInside&) = default;
};
struct KeepApart {  ///< any two at least so far apart
  std::vector<std::string> devices;
  double distance = 0;  ///< metres
  friend bool operator==(const KeepApart&, const KeepApart&) = default;
};
struct KeepTilt {  ///< the z axis at most so far from a direction
  std::vector<std::string> devices;
  Eigen::Vector3d from = -Eigen::Vector3d::UnitZ();  ///< world, any length but 0
  double angle = 0;                                  ///< radians
  friend bool operator==(const KeepTilt&, const KeepTilt&) = default;
};
struct KeepClear {  ///< devices at least so far from a sight line
  std::vector<std::string> devices;
  Eigen::Vector3d from, to;  ///< world, metres
  double distance = 0;       ///< metres
  friend bool operator==(const KeepClear&, const KeepClear&) = default;
};
struct KeepSum {  ///< Σ factor·number ≤ limit: money, cable, rates
  std::vector<std::pair<std::string, double>> factors;  ///< of numbers' paths
  double limit = 0;
  friend bool operator==(const KeepSum&, const KeepSum&) = default;
};
struct KeepMetric {  ///< at most so large at every sample of a set
  std::string metric;
  std::string in;    ///< a sample set; empty: all
  double limit = 0;  ///< SI; of metrics of which more is better: at least
  friend bool operator==(const KeepMetric&, const KeepMetric&) = default;
};

/// Something that a search must keep.
struct ConstraintEntry {
  std::string name;  ///< never empty
  std::variant<KeepInside, KeepApart, KeepTilt, KeepClear, KeepSum, KeepMetric> what;
  friend bool operator==(const ConstraintEntry&, const ConstraintEntry&) = default;
};

}  // namespace delos
