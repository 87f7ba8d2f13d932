// Whether a matrix can be the intensity or covariance of noise.
#pragma once

#include <Eigen/Core>

#include "document/reader.h"

namespace delos {

/// A finding where the square matrix isn't symmetric, or not positive definite.
bool check_positive_definite(Reader& reader, const Place& at, const Eigen::MatrixXd& m);

/// A finding where the square matrix isn't symmetric, or has a negative eigenvalue.
bool check_positive_semidefinite(Reader& reader, const Place& at,
                                 const Eigen::MatrixXd& m);

}  // namespace delos
