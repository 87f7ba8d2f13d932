// The variances of readings that take time, against a million drawn paths.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "delos/model/exposure_model.h"

namespace delos {
namespace {

constexpr int kPaths = 1'000'000;
constexpr double kTime = 0.7;

/// A chain of order k with its integral as one more state, from rest at the window's
/// begin to its middle and to its end: steps by Allen (2007), Eqs. 21–25, of k + 1.
template <int k>
class Path {
 public:
  using State = Eigen::Matrix<double, k + 1, 1>;

  Path() {
    const double h = kTime / 2;
    Eigen::Matrix<double, k + 1, k + 1> Q;
    for (int i = 0; i <= k; ++i)
      for (int j = 0; j <= k; ++j) {
        const int p = 2 * k + 1 - i - j;
        A_(i, j) = j < i ? 0 : std::pow(h, j - i) / std::tgamma(j - i + 1.0);
        Q(i, j) =
            std::pow(h, p) / (p * std::tgamma(k + 1.0 - i) * std::tgamma(k + 1.0 - j));
      }
    L_ = Q.llt().matrixL();
  }
  void draw(std::mt19937_64& random) {
    const auto step = [&](const State& from) -> State {
      State w;
      for (double& v : w) v = normal_(random);
      return A_ * from + L_ * w;
    };
    middle = step(State::Zero());
    end = step(middle);
  }

  State middle, end;  // integral, position, velocity, acceleration

 private:
  Eigen::Matrix<double, k + 1, k + 1> A_, L_;
  std::normal_distribution<double> normal_;
};

template <int k>
void expect_variances_of_paths() {
  std::mt19937_64 random(17 + k);
  Path<k> path;
  // What a state at the end or in the middle says of the mean: moments of the way.
  double of_end[k], of_middle[k];
  for (int j = 0; j < k; ++j) {
    of_end[j] = std::pow(-kTime, j) / std::tgamma(j + 2.0);
    of_middle[j] = j % 2 ? 0 : std::pow(kTime / 2, j) / std::tgamma(j + 2.0);
  }
  double begin_known = 0, end_known = 0, middle_known = 0, displaced = 0;
  for (int i = 0; i < kPaths; ++i) {
    path.draw(random);
    const double mean = path.end(0) / kTime;
    double by_end = 0, by_middle = 0;
    for (int j = 0; j < k; ++j) {
      by_end += of_end[j] * path.end(j + 1);
      by_middle += of_middle[j] * path.middle(j + 1);
    }
    begin_known += mean * mean / kPaths;
    end_known += std::pow(mean - by_end, 2) / kPaths;
    middle_known += std::pow(mean - by_middle, 2) / kPaths;
    displaced += path.end(1) * path.end(1) / kPaths;
  }
  // Five standard deviations of a variance of so many.
  const double off = 5 * std::sqrt(2.0 / kPaths);
  const auto of = [](ExposureModel model) { return motion_variance(model, k, kTime); };
  EXPECT_NEAR(end_known / of(ExposureModel::exact), 1, off);
  EXPECT_NEAR(begin_known / of(ExposureModel::exact), 1, off)
      << "as seen from its begin";
  EXPECT_NEAR(displaced / of(ExposureModel::instantaneous), 1, off);
  EXPECT_NEAR(displaced / 4 / of(ExposureModel::averaged), 1, off);
  EXPECT_NEAR(begin_known * kTime * kTime / of(ExposureModel::integrated), 1, off);
  // Two halves of the window, of which each is seen from an end: a quarter each.
  EXPECT_NEAR(middle_known / (of(ExposureModel::exact) / std::pow(4.0, k)), 1, off)
      << "P qτ/12, PV qτ³/320";
}

TEST(DrawnPaths, OfPHaveTheVariancesOfReadings) { expect_variances_of_paths<1>(); }
TEST(DrawnPaths, OfPvHaveTheVariancesOfReadings) { expect_variances_of_paths<2>(); }
TEST(DrawnPaths, OfPvaHaveTheVariancesOfReadings) { expect_variances_of_paths<3>(); }

}  // namespace
}  // namespace delos
