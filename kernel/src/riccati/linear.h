// Small linear algebra over the state. Each step is compiled once, here: what Eigen
// makes of an expression anew wherever it stands costs seconds. No heap.
#pragma once

#include <complex>

#include "delos/model/state.h"
#include "model/epsilon.h"

namespace delos::riccati {

inline StateMatrix symmetric(const StateMatrix& m) { return (m + m.transpose()) / 2; }

/// A P Aᵀ of a symmetric P, symmetric to the last bit. A may have fewer rows than P.
StateMatrix congruence(const StateMatrix& A, const StateMatrix& P);

/// W⁻¹ B of a regular W.
StateMatrix solved(const StateMatrix& W, const StateMatrix& B);

/// A = U T Uᴴ: U unitary, T upper triangular with the eigenvalues on its diagonal.
struct Schur {
  using Matrix = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic,
                               Eigen::ColMajor, kMaxState, kMaxState>;
  Matrix T, U;
};
Schur schur(const StateMatrix& A);

/// Eigenvalues of a general matrix, in no order, conjugates apart.
Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxState, 1>
eigenvalues(const StateMatrix& A);

/// Orthonormal basis of the columns of X, n×m of full rank; m may be 0.
StateMatrix orthonormal(const StateMatrix& X);

/// Orthonormal basis of what is orthogonal to the orthonormal columns of N, n×(n−m).
StateMatrix complement(const StateMatrix& N);

/// (I − N Nᵀ) P (I − N Nᵀ): P seen only along what is orthogonal to the columns of N.
StateMatrix projected_off(const StateMatrix& P, const StateMatrix& N);

/// Orthonormal basis of {x : W x = 0}: pivots up to `tolerance` count as zero.
StateMatrix null_space(const StateMatrix& W, double tolerance);

/// Lower-triangular F with F Fᵀ = P for symmetric P ≥ 0, also singular: pivots that are
/// rounding (16 n ε of their diagonal entry) leave a zero column.
StateMatrix semidefinite_factor(const StateMatrix& P);

/// Rows over the state as rows over y, where x = V y; 0×0 where there are none.
Eigen::MatrixXd in_terms_of(const StateMatrix& V, const Eigen::MatrixXd& rows);

/// Pseudo-inverse of a symmetric M ≥ 0 whose entries are sums of terms of size
/// √(scale_i scale_j): what is below 16 n ε of that is rounding and counts as zero.
struct PseudoInverse {
  StateMatrix inverse;
  StateMatrix null;  ///< n×m, the directions that were dropped
};
PseudoInverse pseudo_inverse(const StateMatrix& M, const StateVector& scale);

}  // namespace delos::riccati
