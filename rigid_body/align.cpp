#include "delos/rigid_body/align.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <utility>

namespace delos::rigid_body {
namespace {

std::vector<Eigen::Vector3d> those(std::span<const Eigen::Vector3d> all,
                                   const std::vector<std::size_t>& which) {
  std::vector<Eigen::Vector3d> some;
  for (const std::size_t i : which) some.push_back(all[i]);
  return some;
}

/// Twice the area of the triangle is of its sides' order.
bool in_line(std::span<const Eigen::Vector3d> p, std::size_t i, std::size_t j,
             std::size_t k) {
  const Eigen::Vector3d a = p[j] - p[i], b = p[k] - p[i];
  return a.cross(b).norm() < 0.05 * a.norm() * b.norm();
}

}  // namespace

BodyPose aligned(std::span<const Eigen::Vector3d> body,
                 std::span<const Eigen::Vector3d> world) {
  Eigen::Vector3d b = Eigen::Vector3d::Zero(), w = b;
  for (std::size_t i = 0; i < body.size(); ++i) {
    b += body[i];
    w += world[i];
  }
  b /= static_cast<double>(body.size());
  w /= static_cast<double>(body.size());
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < body.size(); ++i)
    C += (world[i] - w) * (body[i] - b).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      C, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d sign(1, 1, 1);
  sign.z() = svd.matrixU().determinant() * svd.matrixV().determinant();
  BodyPose pose;
  pose.R = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  pose.t = w - pose.R * b;
  return pose;
}

std::optional<Alignment> aligned_rejecting(std::span<const Eigen::Vector3d> body,
                                           std::span<const Eigen::Vector3d> world,
                                           double within) {
  const std::size_t n = body.size();
  std::optional<Alignment> best;
  double best_squares = 0;
  const auto consider = [&](const BodyPose& pose) {
    Alignment all{pose, {}};
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double square = (pose.R * body[i] + pose.t - world[i]).squaredNorm();
      if (square > within * within) continue;
      all.kept.push_back(i);
      squares += square;
    }
    if (all.kept.size() < 3) return;
    if (best && (all.kept.size() < best->kept.size() ||
                 (all.kept.size() == best->kept.size() && squares >= best_squares)))
      return;
    best_squares = squares;
    best = std::move(all);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k) {
        if (in_line(body, i, j, k)) continue;
        const Eigen::Vector3d b[] = {body[i], body[j], body[k]},
                              w[] = {world[i], world[j], world[k]};
        consider(aligned(b, w));
      }
  if (best) best->pose = aligned(those(body, best->kept), those(world, best->kept));
  return best;
}

}  // namespace delos::rigid_body
