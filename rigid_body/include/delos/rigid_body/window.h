// Where in the next images a marker is looked for.
#pragma once

#include <optional>

#include "delos/rigid_body/camera.h"
#include "delos/rigid_body/filter.h"
#include "delos/rigid_body/refine.h"

namespace delos::rigid_body {

/// F4: where the filter has a pose a time after the last frame, and how sure it is: by
/// the last pose's covariance and that of the motion,
///
///     t⁺ = W t + V v + A a,  R⁺ = W R,  C⁺ = J_s P J_sᵀ + J_x C J_xᵀ
///
/// of which ∂θ⁺/∂ω = V.
/// @param dt since the last frame, > 0
/// @param last the pose then
[[nodiscard]] MeasuredPose predicted_pose(const BodyFilter& filter, double dt,
                                          const MeasuredPose& last);

/// An ellipse in an image.
struct SearchWindow {
  Eigen::Vector2d centre;      ///< pixels
  Eigen::Matrix2d covariance;  ///< of what is seen about it, noise included, pixels²

  /// (uv − centre)ᵀ C⁻¹ (uv − centre): χ² of two degrees where the filter is right.
  [[nodiscard]] double distance(const Eigen::Vector2d& uv) const;
};

/// F5: the image of a marker of a predicted pose.
/// @param marker in the body, metres
/// @param sigma of a marker's image, pixels
/// @returns nothing where it leaves the image
[[nodiscard]] std::optional<SearchWindow> search_window(const Camera& camera,
                                                        const MeasuredPose& predicted,
                                                        const Eigen::Vector3d& marker,
                                                        double sigma);

}  // namespace delos::rigid_body
