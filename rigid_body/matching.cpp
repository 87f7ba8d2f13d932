#include "delos/rigid_body/matching.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

namespace delos::rigid_body {
namespace {

constexpr int kMostTries = 10'000'000;

class Search {
 public:
  Search(std::span<const Eigen::Vector3d> body, std::span<const Eigen::Vector3d> cloud,
         double tolerance, const std::vector<std::vector<bool>>& may)
      : body_(body),
        cloud_(cloud),
        tolerance_(tolerance),
        may_(may),
        now_(body.size()),
        used_(cloud.size()) {}

  Matches run() {
    go(0, 0, 0);
    return most_ < 3 ? Matches{} : best_;
  }

 private:
  void go(std::size_t marker, std::size_t found, double squares) {
    // Even if all the others are found: no more, or worse ones.
    if (found + (body_.size() - marker) < most_) return;
    if (marker == body_.size()) {
      const bool better = found > most_ || (found == most_ && squares < least_);
      if (!better || found < 3 || mirrored()) return;
      most_ = found;
      least_ = squares;
      best_ = now_;
      return;
    }
    for (std::size_t k = 0; k < cloud_.size(); ++k) {
      if (used_[k] || (!may_.empty() && !may_[marker][k])) continue;
      const auto off = distances_off(marker, k);
      if (!off) continue;
      used_[k] = true;
      now_[marker] = k;
      go(marker + 1, found + 1, squares + *off);
      now_[marker].reset();
      used_[k] = false;
    }
    go(marker + 1, found, squares);
  }

  /// How far distances to the markers so far are off, squared; nothing beyond the
  /// tolerance.
  std::optional<double> distances_off(std::size_t marker, std::size_t k) {
    double squares = 0;
    for (std::size_t i = 0; i < marker; ++i) {
      if (!now_[i]) continue;
      if (++tries_ > kMostTries)
        throw std::length_error("too many points to find a body in by its distances");
      const double off =
          (cloud_[*now_[i]] - cloud_[k]).norm() - (body_[i] - body_[marker]).norm();
      if (!(std::abs(off) <= tolerance_)) return std::nullopt;
      squares += off * off;
    }
    return squares;
  }

  /// Whether four of the markers span the other hand's tetrahedron, by more than the
  /// tolerance: mirrored bodies have the same distances.
  [[nodiscard]] bool mirrored() const {
    std::vector<Eigen::Vector3d> b, c;
    for (std::size_t i = 0; i < body_.size(); ++i)
      if (now_[i]) {
        b.push_back(body_[i]);
        c.push_back(cloud_[*now_[i]]);
      }
    double sum = 0;
    for (std::size_t i = 3; i < b.size(); ++i) {
      const auto volume = [i](const std::vector<Eigen::Vector3d>& p) {
        return (p[1] - p[0]).cross(p[2] - p[0]).dot(p[i] - p[0]);
      };
      sum += volume(b) * volume(c);
    }
    return sum < 0;
  }

  std::span<const Eigen::Vector3d> body_, cloud_;
  double tolerance_;
  const std::vector<std::vector<bool>>& may_;
  Matches now_, best_;
  std::vector<bool> used_;
  std::size_t most_ = 0;
  double least_ = 0;
  int tries_ = 0;
};

}  // namespace

Matches matched(std::span<const Eigen::Vector3d> body,
                std::span<const Eigen::Vector3d> cloud, double tolerance,
                const std::vector<std::vector<bool>>& may) {
  return Search(body, cloud, tolerance, may).run();
}

}  // namespace delos::rigid_body
