// What each candidate of a selection knows of the target, pose by pose.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "delos/api.h"
#include "delos/rig/system.h"
#include "delos/scene/candidates.h"

namespace delos {

/// A row that a candidate measures without noise.
struct ExactRow {
  int candidate;  ///< −1: measured whatever is chosen
  Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMaxState> h;
};

/// Information of one update, or its rate under continuous fusion. At a pose
///
///     S(w) = always + Σ w_c information_c
///
/// over the pose's entries; matrices are packed as model/lanes.h says, without lanes.
struct CandidateInformation {
  int columns = 0;                 ///< of S: information_size()
  std::vector<double> always;      ///< poses × packed, the prior included
  std::vector<std::size_t> first;  ///< poses + 1: where the entries of a pose begin
  std::vector<std::int32_t> candidate;   ///< of each entry, ascending within a pose
  std::vector<double> information;       ///< entries × packed
  std::vector<std::size_t> first_exact;  ///< poses + 1
  std::vector<ExactRow> exact;
  std::vector<std::size_t> first_reading;  ///< poses + 1; or empty: not asked for
  std::vector<std::int32_t> reader;  ///< of each reading; −1: whatever is chosen
  std::vector<double> readings;      ///< readings × columns: R^(−1/2) H

  [[nodiscard]] std::size_t poses() const { return first.size() - 1; }
};

/// Observe with every candidate at every pose.
/// @param readings whether to keep the readings that the information is of
/// @pre `system` was built of all.scene
/// @throws std::invalid_argument one sentence: a device shares its updates among
///         candidates, so that information isn't a sum over them
/// @throws std::invalid_argument one sentence: a device and the beacons that it sees
/// are
///         candidates
/// @throws std::invalid_argument one sentence: rows without noise, continuous fusion
[[nodiscard]] DELOS_API CandidateInformation candidate_information(
    const System& system, const CandidateScene& all, std::span<const TargetPose> poses,
    int threads = 0, bool readings = false);

/// Which poses each candidate sees.
struct CandidateViews {
  std::vector<std::size_t> first;    ///< candidates + 1
  std::vector<std::int32_t> poses;   ///< ascending within a candidate
  std::vector<std::int32_t> always;  ///< poses: how many devices see it anyway
};

/// Ask every candidate about every pose; about whole boxes of them, where a device or
/// the bodies that hide can tell.
/// @param go_on asked now and then, from the calling thread, with the part of the
///        candidates that was asked, 0 to 1; false: stop
/// @returns nothing, without even a `first`, where go_on said no
/// @pre `system` was built of all.scene; fewer than 2³¹ poses
/// @throws DeviceFault
[[nodiscard]] DELOS_API CandidateViews candidate_views(
    const System& system, const CandidateScene& all, std::span<const TargetPose> poses,
    int threads = 0, const std::function<bool(double)>& go_on = {});

}  // namespace delos
