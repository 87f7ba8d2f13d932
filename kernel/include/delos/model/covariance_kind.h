// Which covariance of a steady state is meant.
#pragma once

namespace delos {

/// Which instant of the steady cycle a covariance describes.
enum class CovarianceKind {
  prior,      ///< predicted, just before the measurements of an update
  posterior,  ///< just after them
};

}  // namespace delos
