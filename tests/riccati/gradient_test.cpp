// Adjoint derivatives against central differences of the solution itself.
//
// J(S) = tr(Y P(S)) for a random symmetric Y over the full covariance. Four evaluations
// with Richardson's extrapolation leave (h/λmin)⁴ ~ 1e-16 and rounding ~1e-11: the
// tolerance of 1e-6 of ‖∂J/∂S‖ ‖dS‖ is far above both.
#include <gtest/gtest.h>

#include "riccati/systems.h"

namespace delos {
namespace {

using testing::Draw;
using testing::embed;
using testing::informed;

/// (J(S + h dS) − J(S − h dS))/(2h), extrapolated.
template <class Objective>
double slope(Objective J, const Eigen::MatrixXd& S, const Eigen::MatrixXd& dS,
             double h) {
  return (8 * (J(S + h * dS) - J(S - h * dS)) -
          (J(S + 2 * h * dS) - J(S - 2 * h * dS))) /
         (12 * h);
}

Eigen::MatrixXd symmetric(Draw& draw, int n) {
  const Eigen::MatrixXd m = draw.matrix(n, n);
  return m + m.transpose();
}

/// Information at which LᵀSL has random, nearly equal or exactly equal eigenvalues.
Eigen::MatrixXd information(Draw& draw, const Eigen::MatrixXd& q, int spread) {
  const int d = static_cast<int>(q.rows());
  if (spread == 0) return draw.spd(d);
  const Eigen::MatrixXd S = draw.decades(-1, 1) * q.inverse();
  const double apart = spread == 1 ? 0 : std::pow(10, -spread);
  const Eigen::MatrixXd other = symmetric(draw, d);
  return (S + S.transpose()) / 2 + apart * S.norm() * other / other.norm();
}

// spread: 0 random, 1 all equal, 3 … 8 apart by 10^−spread: on both sides of the switch
// between the divided difference and f′.
TEST(SpectralGradient, MatchesDifferences) {
  Draw draw(1);
  const int spreads[] = {0, 1, 3, 4, 5, 6, 8};
  for (int i = 0; i < 210; ++i) {
    const int d = i % 2 == 0 ? 3 : 6, k = 1 + i % 3, n = d * k;
    const Sampling sampling{i % 5 == 0, 0.3};
    const CovarianceKind kind =
        i % 4 < 2 ? CovarianceKind::prior : CovarianceKind::posterior;
    const Eigen::MatrixXd q = draw.spd(d), S = information(draw, q, spreads[i % 7]);
    const CoordinateMatrix L = testing::cholesky(q);
    const StateMatrix Y = symmetric(draw, n);
    const auto J = [&](const Eigen::MatrixXd& at) {
      return spectral_covariance(spectral_form(L, at), k, sampling, kind)
          .cwiseProduct(Y)
          .sum();
    };
    const CoordinateMatrix G =
        spectral_gradient(spectral_form(L, S), k, sampling, kind, Y);
    for (int direction = 0; direction < 3; ++direction) {
      const Eigen::MatrixXd dS = symmetric(draw, d);
      const double h = 1e-4 * testing::smallest_eigenvalue(S) / dS.norm();
      ASSERT_NEAR(G.cwiseProduct(dS).sum(), slope(J, S, dS, h),
                  1e-6 * G.norm() * dS.norm())
          << "case " << i << " d=" << d << " k=" << k;
    }
  }
}

TEST(GeneralGradient, MatchesDifferences) {
  Draw draw(2);
  for (int i = 0; i < 200; ++i) {
    const int n = 2 + i % 6;
    const bool posterior = i % 2 == 0;
    const MotionStep motion{0.7 * draw.matrix(n, n), draw.spd(n)};
    const Eigen::MatrixXd S = draw.spd(n);
    const StateMatrix Y = symmetric(draw, n);
    const auto J = [&](const Eigen::MatrixXd& at) {
      const SteadyState s = solve_doubling(motion, informed(at));
      return (posterior ? s.posterior : s.prior).cwiseProduct(Y).sum();
    };
    const StateMatrix G = riccati_gradient(
        motion, informed(S), solve_doubling(motion, informed(S)), Y, posterior);
    const Eigen::MatrixXd dS = symmetric(draw, n);
    const double h = 1e-4 * testing::smallest_eigenvalue(S) / dS.norm();
    ASSERT_NEAR(G.cwiseProduct(dS).sum(), slope(J, S, dS, h),
                1e-6 * G.norm() * dS.norm())
        << "case " << i;
  }
}

// The two adjoints know nothing of each other.
TEST(Gradient, SpectralAndGeneralAgree) {
  Draw draw(3);
  for (int i = 0; i < 60; ++i) {
    const int d = i % 2 == 0 ? 3 : 6, k = 1 + i % 3, n = d * k;
    const bool posterior = i % 4 < 2;
    const Eigen::MatrixXd q = draw.spd(d), S = information(draw, q, i % 3 == 0 ? 6 : 0);
    const StateMatrix Y = symmetric(draw, n), full = embed(S, n);
    const MotionStep motion = discretize(testing::chain_model(k, q), 0.2);
    const CoordinateMatrix a = spectral_gradient(
        spectral_form(testing::cholesky(q), S), k, {false, 0.2},
        posterior ? CovarianceKind::posterior : CovarianceKind::prior, Y);
    const StateMatrix b = riccati_gradient(
        motion, informed(full), solve_doubling(motion, informed(full)), Y, posterior);
    ASSERT_LT(testing::relative(b.topLeftCorner(d, d), a), 1e-8) << "case " << i;
  }
}

}  // namespace
}  // namespace delos
