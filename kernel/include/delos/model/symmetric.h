// Eigenvalues of symmetric matrices up to the size of the state.
#pragma once

#include "delos/api.h"
#include "delos/model/state.h"

namespace delos {

/// M = V diag(λ) Vᵀ, V orthogonal.
struct SymmetricEigen {
  StateVector values;   ///< λ, rising
  StateMatrix vectors;  ///< V, a column for each λ
};

/// @pre M = Mᵀ, of which the lower triangle is read; at least 1×1
[[nodiscard]] DELOS_API SymmetricEigen symmetric_eigen(const StateMatrix& M);

/// λ alone.
/// @pre as above
[[nodiscard]] DELOS_API StateVector symmetric_eigenvalues(const StateMatrix& M);

}  // namespace delos
