#include "delos/model/symmetric.h"

#include <Eigen/Eigenvalues>

namespace delos {

SymmetricEigen symmetric_eigen(const StateMatrix& M) {
  const Eigen::SelfAdjointEigenSolver<StateMatrix> eigen(M);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

StateVector symmetric_eigenvalues(const StateMatrix& M) {
  return Eigen::SelfAdjointEigenSolver<StateMatrix>(M, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

}  // namespace delos
