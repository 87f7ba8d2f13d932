// The thin plate through values at points of a plane.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace delos {

/// v(p) = c₀ + c·p + Σ wᵢ φ(‖p − pᵢ‖), φ(r) = r² log r, which of all surfaces through
/// the values has the least ∫ v_xx² + 2 v_xy² + v_yy². Lengths are scaled to 1.
/// Source: Duchon (1977), LNM 571, 85–100.
class ThinPlate {
 public:
  static constexpr std::size_t kMostPoints = 3000;

  /// @pre points differ
  /// @throws std::invalid_argument one sentence: more than kMostPoints
  ThinPlate(const std::vector<Eigen::Vector2d>& points,
            const std::vector<double>& values);

  [[nodiscard]] double at(const Eigen::Vector2d& place) const;

 private:
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
  double scale_ = 1;         ///< metres of a length 1
  Eigen::Matrix2Xd points_;  ///< scaled
  Eigen::VectorXd weights_;  ///< w, then c₀, c
};

/// Whether points lie in one line, or nearly, so that no plane through them is the one.
[[nodiscard]] bool in_one_line(const std::vector<Eigen::Vector2d>& points);

}  // namespace delos
