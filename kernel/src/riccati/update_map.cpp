// Filter updates as maps: construction, composition and application.
#include "riccati/update_map.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "riccati/linear.h"

namespace delos::riccati {
namespace {

/// (I − LC) H (I − LC)ᵀ: Joseph's form, which stays ≥ 0.
StateMatrix condition(const StateMatrix& H, const StateMatrix& L,
                      const StateMatrix& C) {
  const StateMatrix keep = StateMatrix::Identity(H.rows(), H.cols()) - L * C;
  return congruence(keep, H);
}

}  // namespace

ExactGain exact_gain(const StateMatrix& H, const StateMatrix& C) {
  // Rounding of M_ii is relative to the sum of magnitudes that make it up.
  const StateVector scale = congruence(C.cwiseAbs(), H.cwiseAbs()).diagonal();
  ExactGain gain{{}, pseudo_inverse(congruence(C, H), scale)};
  const StateMatrix HC = H * C.transpose();
  gain.L = HC * gain.M.inverse;
  return gain;
}

UpdateMap one_update(const MotionStep& motion, const Measurement& measurement,
                     bool& regular) {
  const StateMatrix &A = motion.A, &Q = motion.Q, &S = measurement.information;
  const Eigen::Index n = A.rows();
  const StateMatrix I = StateMatrix::Identity(n, n);

  // A_s = (I + QS)⁻¹ A,  G_s = Aᵀ S (I + QS)⁻¹ A,  H_s = (I + QS)⁻¹ Q
  const Eigen::PartialPivLU<StateMatrix> W(I + Q * S);
  UpdateMap map;
  map.A = W.solve(A);
  const StateMatrix SA = S * map.A;
  map.G = symmetric(A.transpose() * SA);
  map.H = symmetric(W.solve(Q));

  // Condition on the exact rows: G gains A_sᵀ Cᵀ M⁺ C A_s.
  regular = true;
  const StateMatrix& C = measurement.exact;
  if (C.rows() > 0) {
    const ExactGain gain = exact_gain(map.H, C);
    const StateMatrix seen = C * map.A;
    // What M⁺ drops must not be seen by the rows through the motion either.
    const double dropped = (gain.M.null.transpose() * seen).norm();
    regular = dropped <= 1e-12 * gain.M.null.norm() * seen.norm();
    map.G += congruence(seen.transpose(), gain.M.inverse);
    map.A -= gain.L * seen;
    map.H = condition(map.H, gain.L, C);
  }
  return map;
}

StateMatrix predict(const MotionStep& motion, const StateMatrix& posterior) {
  return congruence(motion.A, posterior) + motion.Q;
}

StateMatrix update(const StateMatrix& prior, const Measurement& measurement) {
  // P = F Fᵀ: Π = F (I + Fᵀ S F)⁻¹ Fᵀ, symmetric and ≥ 0 by construction.
  const Eigen::Index n = prior.rows();
  const StateMatrix F = semidefinite_factor(prior);
  const Eigen::LLT<StateMatrix> W(StateMatrix::Identity(n, n) +
                                  congruence(F.transpose(), measurement.information));
  const StateMatrix half = W.matrixL().solve(StateMatrix(F.transpose()));
  const StateMatrix posterior = half.transpose() * half;
  const StateMatrix& C = measurement.exact;
  if (C.rows() == 0) return posterior;
  return condition(posterior, exact_gain(posterior, C).L, C);
}

}  // namespace delos::riccati
