// Sight segments.
#pragma once

#include <Eigen/Core>
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

}  // namespace delos
