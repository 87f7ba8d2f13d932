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

/// What the readings h x + v, v ~ N(0, 1), of the rows h make of a covariance, one
/// after another: with m = h H hᵀ + 1 and the gain k = H hᵀ/m,
///
///     H ← (I − k h) H (I − k h)ᵀ + k kᵀ
///
/// @param gained visit(h, k, m), before H is changed
template <class Visit>
void read_rows(const Eigen::MatrixXd& rows, StateMatrix& H, Visit&& gained) {
  const Eigen::Index n = H.rows();
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const StateVector h = rows.row(i).transpose(), Hh = H * h;
    const double m = std::max(h.dot(Hh), 0.0) + 1;
    const StateVector k = Hh / m;
    gained(h, k, m);
    const StateMatrix keep = StateMatrix::Identity(n, n) - k * h.transpose();
    H = congruence(keep, H) + k * k.transpose();
  }
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

StateMatrix kept_by_rows(const StateMatrix& before, const Eigen::MatrixXd& rows) {
  const Eigen::Index n = before.rows();
  StateMatrix H = before, kept = StateMatrix::Identity(n, n);
  read_rows(rows, H, [&](const StateVector& h, const StateVector& k, double) {
    kept -= k * (h.transpose() * kept).eval();
  });
  return kept;
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

  // A row adds hᵀh/m as A sees it: G ← G + Aᵀ hᵀ h A/m,  A ← (I − k h) A.
  read_rows(measurement.rows, map.H,
            [&](const StateVector& h, const StateVector& k, double m) {
              const StateVector seen = map.A.transpose() * h;
              map.G += seen * seen.transpose() / m;
              map.A -= k * seen.transpose();
            });

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

StateMatrix kept(const StateMatrix& prior, const Measurement& measurement) {
  const Eigen::Index n = prior.rows();
  const StateMatrix I = StateMatrix::Identity(n, n);
  StateMatrix M = solved(I + prior * measurement.information, I);
  if (measurement.rows.rows() > 0)
    M = kept_by_rows(symmetric(M * prior), measurement.rows) * M;
  if (measurement.exact.rows() > 0) {
    const StateMatrix& E = measurement.exact;
    const StateMatrix seen = E * M;
    M -= exact_gain(M * prior, E).L * seen;
  }
  return M;
}

StateMatrix update(const StateMatrix& prior, const Measurement& measurement) {
  // P = F Fᵀ: Π = F (I + Fᵀ S F)⁻¹ Fᵀ, symmetric and ≥ 0 by construction.
  const Eigen::Index n = prior.rows();
  const StateMatrix F = semidefinite_factor(prior);
  const Eigen::LLT<StateMatrix> W(StateMatrix::Identity(n, n) +
                                  congruence(F.transpose(), measurement.information));
  const StateMatrix half = W.matrixL().solve(StateMatrix(F.transpose()));
  StateMatrix posterior = half.transpose() * half;
  read_rows(measurement.rows, posterior, [](const auto&...) {});
  const StateMatrix& C = measurement.exact;
  if (C.rows() == 0) return posterior;
  return condition(posterior, exact_gain(posterior, C).L, C);
}

}  // namespace delos::riccati
