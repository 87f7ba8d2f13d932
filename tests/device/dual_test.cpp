// Numbers that carry their slopes.
#include "delos/expression/dual.h"

#include <gtest/gtest.h>

#include "delos/device/reading.h"

namespace delos::test {
namespace {

/// A formula of a point with all that Dual has in it.
struct Everything {
  template <class T>
  T operator()(const Point<T>& p) const {
    using std::abs, std::atan2, std::cos, std::exp, std::log, std::log10, std::max,
        std::min, std::pow, std::sin, std::sqrt;
    const T a = p.x * p.y - 2.0 / (p.z + 3) + (1.5 - p.x) / p.y + p.z * 0.3 - 0.1;
    const T b = sqrt(squared_norm(p)) * sin(a) + exp(p.y / 4) * cos(p.z) - log(p.x);
    return -atan2(b, T(2 + p.x)) + abs(a) / 7 + min(T(p.x / 5), T(p.z * b)) +
           max(b, T(p.x * p.z)) / 3 + pow(T(2 + p.y), T(a / 5)) + log10(T(3 + p.x)) +
           chosen(plain(p.y) > 0, b, a);
  }
};

/// Places where nothing has a kink.
constexpr double kPlaces[][3] = {
    {1.1, 0.7, 2.3}, {0.4, -1.9, 0.6}, {3.2, 1.4, -0.9}, {2.5, -0.3, 5}};

// First derivatives against central differences of the plain formula, second ones
// against central differences of the first.
TEST(Dual, HasTheSlopesOfDifferences) {
  const Everything f;
  for (const auto& place : kPlaces) {
    const auto at = [&](int k, double h) {
      double p[3] = {place[0], place[1], place[2]};
      if (k >= 0) p[k] += h;
      return independent(p[0], p[1], p[2]);
    };
    const auto value = [&](int k, double h) {
      const auto p = at(k, h);
      return f(Point<double>{p.x.value, p.y.value, p.z.value});
    };
    const FirstOrder once = f(at(-1, 0));
    const Point<FirstOrder> p = at(-1, 0);
    const SecondOrder twice = f(independent(p.x, p.y, p.z));
    EXPECT_EQ(once.value, value(-1, 0));
    EXPECT_EQ(plain(twice), once.value);
    const double h = 1e-5;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(once.slope[i], (value(i, h) - value(i, -h)) / (2 * h),
                  1e-7 * (1 + std::abs(once.slope[i])));
      EXPECT_EQ(twice.value.slope[i], once.slope[i]);
      for (int k = 0; k < 3; ++k) {
        const double slope = (f(at(k, h)).slope[i] - f(at(k, -h)).slope[i]) / (2 * h);
        EXPECT_NEAR(twice.slope[k].slope[i], slope, 1e-6 * (1 + std::abs(slope)))
            << i << " " << k;
        EXPECT_NEAR(twice.slope[k].slope[i], twice.slope[i].slope[k],
                    1e-12 * (1 + std::abs(slope)));
      }
    }
  }
}

// ∇²‖p‖ = (I − p pᵀ/‖p‖²)/‖p‖
TEST(Dual, HasTheHessianOfADistance) {
  const Point<FirstOrder> once = independent(1.0, -2.0, 2.0);
  const auto r = sqrt(squared_norm(independent(once.x, once.y, once.z)));
  const double p[] = {1, -2, 2};
  EXPECT_EQ(plain(r), 3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(r.value.slope[i], p[i] / 3);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(r.slope[k].slope[i], ((i == k) - p[i] * p[k] / 9) / 3, 1e-15);
  }
}

}  // namespace
}  // namespace delos::test
