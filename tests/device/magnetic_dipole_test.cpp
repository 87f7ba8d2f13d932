// On the source's axis the information has a closed form. With c = µ0 moment/4π and
// p = r e_z, in units of c²/(sigma² r⁸), c²/(sigma² r⁶) and c²/(sigma² r⁷) it is
//
//   positions 18, 18, 54; angles 5, 5, 2; x with pitch −9, y with roll 9; else 0
//
// from B = c/r³ diag(−1, −1, 2), ∂B/∂x = 3c/r⁴ (e_x e_zᵀ + e_z e_xᵀ) and
// ∂B/∂z = 3c/r⁴ diag(1, 1, −2).
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "device/devices.h"

namespace delos::test {
namespace {

constexpr double kMoment = 3, kSigma = 2e-10, kC = 1e-7 * kMoment;

std::shared_ptr<const Device> tracker() {
  return device("magnetic_dipole", "{moment: 3, sigma: 2e-10, reach: 5}");
}

Eigen::Matrix<double, 6, 6> information(const Target& target) {
  Observation out;
  EXPECT_TRUE(tracker()->observe(target, out));
  return out.H.transpose() * out.H / out.R(0, 0);
}

TEST(MagneticDipole, KnowsOnItsAxisWhatTheClosedFormSays) {
  for (const double r : {0.3, 1.0, 2.5}) {
    Target target;
    target.p_ST = {0, 0, r};
    target.R_ST =
        Eigen::Quaterniond(0.3, -0.2, 0.8, 0.5).normalized().toRotationMatrix();
    const double scale = kC * kC / (kSigma * kSigma * std::pow(r, 6));
    Eigen::Matrix<double, 6, 6> expected = Eigen::Matrix<double, 6, 6>::Zero();
    expected.diagonal() << 18 / (r * r), 18 / (r * r), 54 / (r * r), 5, 5, 2;
    expected(0, 4) = expected(4, 0) = -9 / r;
    expected(1, 3) = expected(3, 1) = 9 / r;
    expected *= scale;
    EXPECT_LT((information(target) - expected).norm(), 1e-13 * expected.norm()) << r;
    // What is left of a place where the orientation is unknown: 18 − 81/5 = 1.8.
    const double sigma_x = std::sqrt(information(target).inverse()(0, 0));
    EXPECT_NEAR(sigma_x, kSigma * std::pow(r, 4) / (kC * std::sqrt(1.8)),
                1e-12 * sigma_x);
  }
}

/// The nine readings, from the potential m·p/r³ of a dipole by differences of its
/// gradient: knows nothing of the plugin's formulas.
Eigen::Matrix<long double, 9, 1> readings(const Eigen::Matrix<long double, 3, 1>& p,
                                          const Eigen::Matrix3d& R) {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  constexpr long double h = 1e-6L;
  const auto potential = [](const Vector& at, int axis) {
    return at(axis) / std::pow(at.norm(), 3.0L);
  };
  Eigen::Matrix<long double, 9, 1> all;
  for (int axis = 0; axis < 3; ++axis) {
    Vector B;
    for (int i = 0; i < 3; ++i) {
      const Vector step = h * Vector::Unit(i);
      B(i) = -static_cast<long double>(kC) *
             (8 * (potential(p + step, axis) - potential(p - step, axis)) -
              (potential(p + 2 * step, axis) - potential(p - 2 * step, axis))) /
             (12 * h);
    }
    all.segment<3>(3 * axis) = R.transpose().cast<long double>() * B;
  }
  return all;
}

TEST(MagneticDipole, KnowsAnywhereWhatThePotentialSays) {
  Target target;
  target.p_ST = {0.7, -0.4, 0.5};
  target.R_ST = Eigen::Quaterniond(0.9, 0.1, -0.3, 0.2).normalized().toRotationMatrix();
  const Eigen::Matrix<long double, 3, 1> p = target.p_ST.cast<long double>();
  constexpr double kStep = 1e-4;
  Eigen::Matrix<double, 9, 6> H;
  for (int k = 0; k < 6; ++k) {
    const auto moved = [&](double by) {
      Eigen::Matrix<long double, 3, 1> at = p;
      Eigen::Matrix3d R = target.R_ST;
      if (k < 3)
        at(k) += by;
      else
        R = Eigen::AngleAxisd(by, Eigen::Vector3d::Unit(k - 3)) * R;
      return readings(at, R);
    };
    H.col(k) =
        ((8 * (moved(kStep) - moved(-kStep)) - (moved(2 * kStep) - moved(-2 * kStep))) /
         (12 * kStep))
            .cast<double>();
  }
  const Eigen::Matrix<double, 6, 6> expected = H.transpose() * H / (kSigma * kSigma);
  EXPECT_LT((information(target) - expected).norm(), 1e-8 * expected.norm());
}

TEST(MagneticDipole, SeesThroughBodiesBetweenNearAndReach) {
  EXPECT_FALSE(tracker()->needs_sight());
  Observation out;
  Target target;
  for (const auto& [z, seen] :
       {std::pair{0.049, false}, {0.051, true}, {5.0, true}, {5.01, false}}) {
    target.p_ST = {0, 0, z};
    EXPECT_EQ(tracker()->observe(target, out), seen) << z;
  }
}

}  // namespace
}  // namespace delos::test
