// The turning LED of Welch, Allen, Ilie and Bishop (2007), section 4, as a simulation:
// readings of an LED on an arm, smeared by the shutter and noisy, and circles fitted to
// them (docs/sample-time.md).
//
// Published: an arm of 15 cm, a turn in 10 s, 30 frames a second, cameras of 810.81 px
// at 35 and 65 cm. Derived: noise c/√τ, with c of the two published optima. Assumed: a
// reading is anywhere in its smear, as likely here as there.
#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

namespace {

constexpr double kArm = 0.15, kTurn = 10, kRate = 30, kFocal = 810.81;
constexpr double kOmega = 2 * std::numbers::pi / kTurn;

struct View {
  double distance, noise;  // m; c, px √s
};

struct Circle {
  Eigen::Vector2d middle;
  double radius;
};

/// The circle of least squared distances: algebraic, then by Gauss and Newton.
/// Source: I. Kasa, IEEE Trans. Instrumentation and Measurement 25(1), 8-14, 1976; W.
/// Gander, G. H. Golub, R. Strebel, BIT 34, 558-578, 1994.
Circle fitted(const std::vector<Eigen::Vector2d>& points) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd A(n, 3);
  Eigen::VectorXd b(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d& p = points[static_cast<std::size_t>(i)];
    A.row(i) << 2 * p.x(), 2 * p.y(), 1;
    b(i) = p.squaredNorm();
  }
  const Eigen::Vector3d k = A.colPivHouseholderQr().solve(b);
  Circle circle{k.head<2>(), std::sqrt(k(2) + k.head<2>().squaredNorm())};
  for (int step = 0; step < 10; ++step) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Vector2d way = points[static_cast<std::size_t>(i)] - circle.middle;
      A.row(i) << -way.x() / way.norm(), -way.y() / way.norm(), -1;
      b(i) = circle.radius - way.norm();
    }
    const Eigen::Vector3d change = A.colPivHouseholderQr().solve(b);
    circle.middle += change.head<2>();
    circle.radius += change(2);
  }
  return circle;
}

/// Scatter across the circle that is fitted, and along it, px.
Eigen::Vector2d scatter(const View& view, double shutter, int turns, unsigned seed) {
  const double scale = kFocal / view.distance;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> part;
  double across = 0, along = 0, count = 0;
  for (int turn = 0; turn < turns; ++turn) {
    std::vector<Eigen::Vector2d> points;
    std::vector<double> angles;
    for (int frame = 0; frame < kRate * kTurn; ++frame) {
      // In the middle of its exposure.
      angles.push_back(kOmega * frame / kRate);
      const double at = angles.back() + kOmega * shutter * (part(random) - 0.5);
      const double noise = view.noise / std::sqrt(shutter);
      points.emplace_back(scale * kArm * std::cos(at) + noise * normal(random),
                          scale * kArm * std::sin(at) + noise * normal(random));
    }
    const Circle circle = fitted(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d way = points[i] - circle.middle;
      const double turned = std::remainder(std::atan2(way.y(), way.x()) - angles[i],
                                           2 * std::numbers::pi);
      across += std::pow(way.norm() - circle.radius, 2);
      along += std::pow(circle.radius * turned, 2);
      ++count;
    }
  }
  return {std::sqrt(across / count), std::sqrt(along / count)};
}

}  // namespace

int main() {
  const View views[] = {{0.35, 0.003493}, {0.65, 0.005320}};
  std::printf(
      "shutter   at 35 cm: sum, across, along   at 65 cm: sum, across, along\n");
  for (const double ms : {0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0}) {
    const double shutter = ms / 1000;
    std::printf("%4.1f ms ", ms);
    for (const View& view : views) {
      const double blur = kOmega * kArm * kFocal / view.distance * shutter;
      const Eigen::Vector2d s = scatter(view, shutter, 20, 7);
      std::printf("   %.4f  %.4f  %.4f px    ", view.noise / std::sqrt(shutter) + blur,
                  s(0), s(1));
    }
    std::printf("\n");
  }
}
