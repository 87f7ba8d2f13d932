// Bases, factors and pseudo-inverses over the state.
#include "riccati/linear.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "delos/model/symmetric.h"

namespace delos::riccati {
namespace {

using QR = Eigen::ColPivHouseholderQR<StateMatrix>;

/// The orthogonal factor, n×n.
StateMatrix rotation(const QR& qr) {
  StateMatrix Q = StateMatrix::Identity(qr.rows(), qr.rows());
  Q.applyOnTheLeft(qr.householderQ());
  return Q;
}

}  // namespace

StateMatrix congruence(const StateMatrix& A, const StateMatrix& P) {
  const StateMatrix AP = A * P;
  return symmetric(AP * A.transpose());
}

StateMatrix solved(const StateMatrix& W, const StateMatrix& B) {
  return Eigen::PartialPivLU<StateMatrix>(W).solve(B);
}

Schur schur(const StateMatrix& A) {
  const Eigen::ComplexSchur<StateMatrix> split(A);
  return {split.matrixT(), split.matrixU()};
}

Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxState, 1>
eigenvalues(const StateMatrix& A) {
  return Eigen::ComplexSchur<StateMatrix>(A, false).matrixT().diagonal();
}

StateMatrix orthonormal(const StateMatrix& X) {
  if (X.cols() == 0) return X;
  return rotation(QR(X)).leftCols(X.cols());
}

StateMatrix complement(const StateMatrix& N) {
  const Eigen::Index n = N.rows(), m = N.cols();
  if (m == 0) return StateMatrix::Identity(n, n);
  return rotation(QR(N)).rightCols(n - m);
}

StateMatrix projected_off(const StateMatrix& P, const StateMatrix& N) {
  const StateMatrix keep =
      StateMatrix::Identity(N.rows(), N.rows()) - N * N.transpose();
  return congruence(keep, P);
}

StateMatrix null_space(const StateMatrix& W, double tolerance) {
  // W x = 0 ⇔ x ⊥ range(Wᵀ): the columns of Q behind the rank of Wᵀ Π = Q R.
  const Eigen::Index n = W.cols();
  if (W.rows() == 0) return StateMatrix::Identity(n, n);
  const QR qr(W.transpose());
  Eigen::Index rank = 0;
  const Eigen::Index most = std::min(n, W.rows());
  while (rank < most && std::abs(qr.matrixQR()(rank, rank)) > tolerance) ++rank;
  return rotation(qr).rightCols(n - rank);
}

StateMatrix semidefinite_factor(const StateMatrix& P) {
  const Eigen::Index n = P.rows();
  StateMatrix F = StateMatrix::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double pivot = P(j, j) - F.row(j).head(j).squaredNorm();
    if (!(pivot > 16 * n * kEps * P(j, j))) continue;
    F(j, j) = std::sqrt(pivot);
    for (Eigen::Index i = j + 1; i < n; ++i)
      F(i, j) = (P(i, j) - F.row(i).head(j).dot(F.row(j).head(j))) / F(j, j);
  }
  return F;
}

Eigen::MatrixXd in_terms_of(const StateMatrix& V, const Eigen::MatrixXd& rows) {
  return rows.rows() == 0 ? Eigen::MatrixXd() : Eigen::MatrixXd(rows * V);
}

PseudoInverse pseudo_inverse(const StateMatrix& M, const StateVector& scale) {
  // Eigenvalues of D M D, D = scale^(−1/2), have absolute errors of n ε.
  const Eigen::Index n = M.rows();
  StateVector D(n);
  for (Eigen::Index i = 0; i < n; ++i)
    D[i] = scale[i] > 0 ? 1 / std::sqrt(scale[i]) : 1;
  const SymmetricEigen eigen = symmetric_eigen(D.asDiagonal() * M * D.asDiagonal());
  const StateVector& lambda = eigen.values;
  Eigen::Index rank = 0;
  StateVector inverse = StateVector::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!(lambda[i] > 16 * n * kEps)) continue;
    inverse[i] = 1 / lambda[i];
    ++rank;
  }
  const StateMatrix V = D.asDiagonal() * eigen.vectors;
  return {congruence(V, StateMatrix(inverse.asDiagonal())), V.leftCols(n - rank)};
}

}  // namespace delos::riccati
