// Filters that follow a simulated target, and what they are told.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "delos/api.h"
#include "delos/observe/reading_model.h"

namespace delos {

/// What a filter believes. A state x is the deviation from a pose X_WT that the
/// simulation is about: its position coordinates from there, its derivatives from rest;
/// behind the n states of the motion stand the means that exposing devices read, as
/// steady/windows.h has them.
struct TrackEstimate {
  StateVector x;  ///< N×1, SI
  /// R_WT. Turns are kept here; those in x are only ever added to.
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  StateMatrix P;  ///< N×N, of the error, of turns [δθ] with R_true = exp(δθ) R
};

/// What an update made of its readings.
struct Innovation {
  /// Σ νᵀ S⁻¹ ν of the readings, S = H P Hᵀ + R by the P before them: χ² with `rows`
  /// degrees of freedom where the filter is right.
  double nis = 0;
  int rows = 0;     ///< that were used
  int dropped = 0;  ///< readings that the estimate has out of view
};

/// How a filter takes in readings.
class DELOS_API TrackFilter {
 public:
  virtual ~TrackFilter();
  /// The update of one instant. Reentrant; nothing from the heap.
  [[nodiscard]] virtual Innovation update(const ReadingModel& model,
                                          std::span<const TrackReading> readings,
                                          TrackEstimate& estimate) const = 0;
};

/// The filters that there are.
enum class FilterKind {
  extended,    ///< all readings linearised at the predicted state
  iterated,    ///< the same about their own result: Gauss–Newton, at most 8 times
  sequential,  ///< one reading after another, each linearised at the latest state
  unscented,   ///< one after another, by 2N + 1 points of the covariance
};

[[nodiscard]] DELOS_API const char* to_string(FilterKind kind);

/// Sources: Jazwinski (1970), Stochastic processes and filtering theory, ch. 8
/// (extended); Bell, Cathey (1993), IEEE TAC 38(2), 294–297, doi:10.1109/9.250476
/// (iterated); Welch, Bishop (1997), SCAAT, SIGGRAPH '97, doi:10.1145/258734.258876
/// (sequential); Julier, Uhlmann (2004), Proc. IEEE 92(3), 401–422,
/// doi:10.1109/JPROC.2003.823141 (unscented).
[[nodiscard]] DELOS_API std::unique_ptr<const TrackFilter> make_filter(FilterKind kind);

}  // namespace delos
