// A segment, and a quick test of boxes against it.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace delos {

/// The segment a→b shortened by skin metres at both ends, in doubles; nullopt where
/// nothing is left. Turning it round gives the same segment, turned round.
struct Segment {
  Eigen::Vector3d a, b;
};

inline std::optional<Segment> shortened(const Eigen::Vector3d& a,
                                        const Eigen::Vector3d& b, double skin) {
  const Eigen::Vector3d d = b - a;
  const double length = d.norm();
  if (!(length > 2 * skin)) return std::nullopt;
  if (skin == 0) return Segment{a, b};
  const Eigen::Vector3d step = (skin / length) * d;
  const Segment s{a + step, b - step};
  if (s.a == s.b) return std::nullopt;
  return s;
}

/// Whether a segment may meet a box, by its part between the box's three pairs of
/// planes. Says no only where it doesn't.
class SlabTest {
 public:
  explicit SlabTest(const Segment& s) {
    for (int i = 0; i < 3; ++i) {
      const double d = s.b[i] - s.a[i];
      low_[i] = std::min(s.a[i], s.b[i]);
      high_[i] = std::max(s.a[i], s.b[i]);
      if (std::abs(d) > 1e-300) {
        inverse_[i] = 1 / d;
        from_min_[i] = from_max_[i] = s.a[i];
      } else {
        // 1/d would overflow. Quotients that cut nothing off, and a test of its own.
        parallel_ = true;
        inverse_[i] = 1;
        from_min_[i] = 1e300;
        from_max_[i] = -1e300;
      }
    }
  }

  /// @pre min ≤ max
  bool may_meet(const std::array<double, 3>& min,
                const std::array<double, 3>& max) const {
    double enter = 0, leave = 1;
    for (int i = 0; i < 3; ++i) {
      const double t = (min[i] - from_min_[i]) * inverse_[i];
      const double u = (max[i] - from_max_[i]) * inverse_[i];
      enter = std::max(enter, std::min(t, u));
      leave = std::min(leave, std::max(t, u));
    }
    // Each quotient is off by four roundings at most, 4.5e-16 of itself.
    if (enter > leave * (1 + 2e-15)) return false;
    return !parallel_ || overlaps(min, max);
  }

 private:
  /// Whether the segment's own box overlaps it.
  bool overlaps(const std::array<double, 3>& min,
                const std::array<double, 3>& max) const {
    for (int i = 0; i < 3; ++i) {
      if (min[i] > high_[i] || max[i] < low_[i]) return false;
    }
    return true;
  }

  std::array<double, 3> from_min_, from_max_, inverse_;
  std::array<double, 3> low_, high_;
  bool parallel_ = false;  // to some axis's plane
};

}  // namespace delos
