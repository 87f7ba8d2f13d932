// A jointed arm against its forward equations.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "device/devices.h"
#include "device/look.h"

namespace delos::test {
namespace {

constexpr double kUpper = 0.4, kFore = 0.35;

/// The tip by its angles, and its slopes by hand.
Eigen::Vector3d tip(double a, double s, double e, Eigen::Matrix3d* slopes = nullptr) {
  const double rho = kUpper * std::cos(s) + kFore * std::cos(s + e),
               z = kUpper * std::sin(s) + kFore * std::sin(s + e);
  const Eigen::Vector3d out(std::cos(a), std::sin(a), 0),
      around(-std::sin(a), std::cos(a), 0), up = Eigen::Vector3d::UnitZ();
  if (slopes != nullptr) {
    slopes->col(0) = rho * around;
    slopes->col(1) = -z * out + rho * up;
    slopes->col(2) = kFore * (-std::sin(s + e) * out + std::cos(s + e) * up);
  }
  return rho * out + z * up;
}

TEST(Linkage, ReadsTheAnglesThatPutItsTipThere) {
  const auto arm = device("linkage", "{upper: 0.4, fore: 0.35, sigma: 1e-3}");
  for (const double a : {-2.5, -0.3, 0.0, 1.9})
    for (const double s : {0.2, 0.9, 1.4})
      for (const double e : {-0.4, -1.2, -2.2}) {
        Eigen::Matrix3d J;
        const Eigen::Vector3d p = tip(a, s, e, &J);
        if (std::hypot(p.x(), p.y()) < 0.02 ||
            p.x() * std::cos(a) + p.y() * std::sin(a) < 0)
          continue;  // too near its waist, or reached from behind it
        const auto at = look(*arm, p);
        ASSERT_TRUE(at) << a << ' ' << s << ' ' << e;
        EXPECT_LT((at->z - Eigen::Vector3d(a, s, e)).norm(), 1e-12);
        EXPECT_LT((at->H * J - Eigen::Matrix3d::Identity()).norm(), 1e-11);
        const Eigen::Matrix3d P =
            (at->H.transpose() * at->R.inverse() * at->H).inverse();
        EXPECT_LT((P - 1e-6 * J * J.transpose()).norm(), 1e-11 * P.norm() + 1e-18);
      }
}

// Straight at 0.75 m, folded at 0.05 m; 0.3 rad short of both.
TEST(Linkage, EndsWhereItIsStraightOrFolded) {
  const auto arm = device("linkage", "{upper: 0.4, fore: 0.35, counts: 4096}");
  const auto reach = [](double cosine) {
    return std::sqrt(0.16 + 0.1225 + 2 * 0.14 * cosine);
  };
  const double far = reach(std::cos(0.3)), near = reach(-std::cos(0.3));
  EXPECT_TRUE(look(*arm, {far - 1e-9, 0, 0}));
  EXPECT_FALSE(look(*arm, {far + 1e-9, 0, 0}));
  EXPECT_TRUE(look(*arm, {near + 1e-9, 0, 0}));
  EXPECT_FALSE(look(*arm, {near - 1e-9, 0, 0}));
  EXPECT_FALSE(look(*arm, {0.019, 0, 0.4}));
  EXPECT_TRUE(look(*arm, {0.021, 0, 0.4}));
  // 2π/(4096 √12)
  EXPECT_NEAR(std::sqrt(look(*arm, {0.5, 0, 0})->R(1, 1)), 4.4282211e-4, 1e-10);
}

TEST(Linkage, RefusesWhatSaysNothingOfItsNoise) {
  EXPECT_EQ(refusal("linkage", "{upper: 0.4, fore: 0.35}"),
            "how well are angles read? give either sigma or counts");
  EXPECT_EQ(refusal("linkage", "{upper: 0.4, fore: 0.35, sigma: 1e-3, counts: 99}"),
            "how well are angles read? give either sigma or counts");
}

}  // namespace
}  // namespace delos::test
