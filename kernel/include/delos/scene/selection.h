// What `delos select` chooses from, and how much it may choose.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "delos/sampling/grid.h"

namespace delos {

/// Devices of the scene, each a candidate by itself.
struct CandidateDevices {
  std::vector<std::string> devices;  ///< names
  friend bool operator==(const CandidateDevices&, const CandidateDevices&) = default;
};

/// What is chosen of a set of beacons as one. Rows, columns and panels are of a grid,
/// in units of its panels: a row runs along x, a column along y.
enum class BeaconGrouping { beacon, row, column, panel };

/// The lit beacons of a set, one by one or together.
struct CandidateBeacons {
  std::string set;
  BeaconGrouping by = BeaconGrouping::beacon;
  friend bool operator==(const CandidateBeacons&, const CandidateBeacons&) = default;
};

/// Evenly spread spots of a surface, both ends included: one number on a rail, else
/// two.
struct SurfaceSpots {
  std::string surface;
  std::vector<int> counts;  ///< ≥ 1 each
  friend bool operator==(const SurfaceSpots&, const SurfaceSpots&) = default;
};

/// How copies face at every spot: each of these. At most one kind is given; none: as
/// what they are copies of.
struct Facings {
  std::vector<Eigen::Vector3d> aims;  ///< points looked at, metres
  std::vector<Eigen::Vector3d> rpy;   ///< radians
  /// Every pan with every tilt, radians: the z axis, at first along the world's x with
  /// y down, is raised by the tilt and then turned by the pan about the world's z.
  std::vector<double> pans, tilts;
  friend bool operator==(const Facings&, const Facings&) = default;
};

/// Copies of a device of the scene at spots. That device is only their pattern.
struct CandidateCopies {
  std::string of;
  std::variant<std::vector<Eigen::Vector3d>, VolumeSampling, SurfaceSpots> spots;
  Facings facings;
  bool one_per_spot = true;  ///< at most one of a spot's facings is chosen
  friend bool operator==(const CandidateCopies&, const CandidateCopies&) = default;
};

/// Some candidates, all of one cost.
struct CandidateSet {
  std::variant<CandidateDevices, CandidateBeacons, CandidateCopies> what;
  double cost = 1;  ///< of each, > 0
  friend bool operator==(const CandidateSet&, const CandidateSet&) = default;
};

/// What may be chosen, and how much. Without candidates there is nothing to choose.
struct Selection {
  std::vector<CandidateSet> candidates;
  std::optional<int> count;      ///< at most so many, kept ones included
  std::optional<double> budget;  ///< costs of what is chosen sum to at most that
  std::optional<int> cover;  ///< instead: the cheapest that see every sample so often
  std::vector<std::string> keep;       ///< names of candidates that are chosen anyway
  std::vector<std::string> leave_out;  ///< likewise, that are not
  friend bool operator==(const Selection&, const Selection&) = default;
};

}  // namespace delos
