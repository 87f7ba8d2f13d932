// Which covariance is meant.
#pragma once

namespace delos {

/// What a covariance describes: an instant of the steady cycle, or no motion at all.
enum class CovarianceKind {
  prior,      ///< predicted, just before the measurements of an update
  posterior,  ///< just after them
  single,  ///< one reading of every device and nothing known before: (HᵀR⁻¹H)⁻¹
};

}  // namespace delos
