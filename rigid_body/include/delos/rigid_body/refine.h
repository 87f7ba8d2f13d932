// A pose refined on the images, and how sure it is.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "delos/rigid_body/camera.h"
#include "delos/rigid_body/filter.h"

namespace delos::rigid_body {

/// A marker's image.
struct MarkerImage {
  std::size_t marker;
  Sighting seen;
};

/// A pose with the covariance of its error [δt, δθ], R_true = exp(δθ) R, t_true = t +
/// δt.
struct MeasuredPose {
  BodyPose pose;
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/// exp(δθ): the rotation by ‖δθ‖ about δθ; and its inverse, the turn of a rotation.
[[nodiscard]] Eigen::Matrix3d turned_by(const Eigen::Vector3d& turn);
[[nodiscard]] Eigen::Vector3d turn_of(const Eigen::Matrix3d& R);

/// The pose that is nearest to marker images, Σ‖uv − image of R b + t‖², by
/// Gauss–Newton from a pose nearby; its covariance is that of images with independent
/// noise of `sigma` pixels.
/// @returns nothing where a marker leaves the images or the markers don't fix the pose
[[nodiscard]] std::optional<MeasuredPose> refined(const BodyPose& from,
                                                  std::span<const Eigen::Vector3d> body,
                                                  const std::vector<Camera>& cameras,
                                                  std::span<const MarkerImage> images,
                                                  double sigma);

}  // namespace delos::rigid_body
