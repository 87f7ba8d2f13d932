// What any device measures: rows over the state, each with noise of its own.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "delos/model/state.h"

namespace delos {

/// One reading, linearised; its noise is independent of all others'.
struct StateRow {
  /// 1×c, over the pose coordinates or the whole state, in W.
  Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMaxState> h;
  double variance = 0;       ///< 0: perfect
  double share = 1;          ///< how often an update has it, in the mean
  std::uint32_t beacon = 0;  ///< of a device on the target: in its index

  [[nodiscard]] bool perfect() const { return variance == 0; }
  /// What hᵀh adds to the information of one update. @pre it isn't perfect
  [[nodiscard]] double weight() const { return share / variance; }
};

}  // namespace delos
