#include "delos/rigid_body/motion.h"

#include <cmath>

namespace delos::rigid_body {
namespace {

/// Σ_k (−1)^k x^2k / (2k + m)!, the even series that all coefficients are made of: its
/// quotients have no digits left near 0.
///
///     S_m(x) = 1/m! − x²/(m+2)! + x⁴/(m+4)! − …
///
/// so that S_1 = sin x/x, S_2 = (1 − cos x)/x², S_3 = (x − sin x)/x³,
/// S_4 = (x²/2 − 1 + cos x)/x⁴, and S_m = 1/m! − x² S_{m+2}.
double even_series(int m, double x) {
  double term = 1;
  for (int i = 2; i <= m; ++i) term /= i;
  double sum = term;
  for (int k = 1; k < 40; ++k) {
    term *= -x * x / ((2 * k + m - 1) * (2 * k + m));
    sum += term;
    if (std::abs(term) <= 1e-18 * std::abs(sum)) break;
  }
  return sum;
}

/// Of which the largest term, x^2k/(2k)!, is below 30 up to here: 14 digits remain.
constexpr double kMostBySeries = 4;

/// S_1 to S_6, in [1] to [6].
struct Coefficients {
  explicit Coefficients(double x) {
    if (std::abs(x) <= kMostBySeries) {
      for (int m = 1; m <= 6; ++m) S[m] = even_series(m, x);
      return;
    }
    S[1] = std::sin(x) / x;
    S[2] = (1 - std::cos(x)) / (x * x);
    double factorial = 1;
    for (int m = 3; m <= 6; ++m) {
      factorial *= m - 2;
      S[m] = (1 / factorial - S[m - 2]) / (x * x);
    }
  }
  /// (dS_m/dx)/x, by x S_m′ = S_{m−1} − m S_m, whose difference is another series:
  ///
  ///     S_m′/x = −Σ_k (−1)^k 2(k + 1) x^2k / (2k + m + 2)! = m S_{m+2} − S_{m+1}
  [[nodiscard]] double slope(int m) const { return m * S[m + 2] - S[m + 1]; }

  double S[7];
};

/// c₁ and c₂ of F, with their slopes over θ.
Eigen::Matrix3d slope_of(const Eigen::Vector3d& w, const Eigen::Vector3d& p, double c1,
                         double c2, double slope1, double slope2) {
  const Eigen::Matrix3d wx = skew(w);
  const Eigen::Vector3d wp = wx * p;
  return -c1 * skew(p) +
         c2 * (-skew(wp) + w.dot(p) * Eigen::Matrix3d::Identity() - p * w.transpose()) +
         slope1 * wp * w.transpose() + slope2 * (wx * wp) * w.transpose();
}

}  // namespace

Eigen::Matrix3d skew(const Eigen::Vector3d& w) {
  Eigen::Matrix3d m;
  m << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return m;
}

BodyMotion body_motion(const Eigen::Vector3d& w, double dt) {
  const Coefficients c(w.norm() * dt);
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity(), x = skew(w) * dt, xx = x * x;
  return {I + c.S[1] * x + c.S[2] * xx, dt * (I + c.S[2] * x + c.S[3] * xx),
          dt * dt * (I / 2 + c.S[3] * x + c.S[4] * xx)};
}

BodyMotionSlopes body_motion_slopes(const Eigen::Vector3d& w, double dt,
                                    const Eigen::Vector3d& of_W,
                                    const Eigen::Vector3d& of_V,
                                    const Eigen::Vector3d& of_A) {
  const Coefficients c(w.norm() * dt);
  // F = Δt^j (… + S_m ωΔt~ + S_{m+1} ωΔt~²) with x = θΔt, so that by ω: one Δt more.
  const auto of = [&](const Eigen::Vector3d& p, int j) -> Eigen::Matrix3d {
    const Eigen::Vector3d turn = w * dt;
    return std::pow(dt, j + 1) *
           slope_of(turn, p, c.S[j + 1], c.S[j + 2], c.slope(j + 1), c.slope(j + 2));
  };
  return {of(of_W, 0), of(of_V, 1), of(of_A, 2)};
}

}  // namespace delos::rigid_body
