// Cameras that see a body's markers: F1, back to space, and F5, forth to the images.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace delos::rigid_body {

/// A camera without distortion, at p in the world; x right, y down, z ahead.
struct Camera {
  double focal = 800;                                  ///< pixels
  Eigen::Vector2d centre = {320, 240};                 ///< pixels
  Eigen::Vector2d size = {640, 480};                   ///< pixels
  Eigen::Matrix3d R_WC = Eigen::Matrix3d::Identity();  ///< p_W = R_WC p_C + p
  Eigen::Vector3d p = Eigen::Vector3d::Zero();         ///< metres
};

/// A camera at p that looks at a point, upright as far as can be.
/// @pre up isn't along the sight line
[[nodiscard]] Camera looking_at(const Eigen::Vector3d& p, const Eigen::Vector3d& at,
                                const Eigen::Vector3d& up = {0, 0, 1});

/// F5: the image of a point, and ∂(u, v)/∂p_W where asked for.
/// @returns nothing behind the camera or outside its image
[[nodiscard]] std::optional<Eigen::Vector2d> image_of(
    const Camera& camera, const Eigen::Vector3d& p_W,
    Eigen::Matrix<double, 2, 3>* slope = nullptr);

/// What a camera saw of a point.
struct Sighting {
  std::size_t camera;
  Eigen::Vector2d uv;  ///< pixels
};

/// F1: the point that two or more sightings are of: nearest to their rays, then by
/// Gauss–Newton nearest to their images.
/// @returns nothing where the rays are parallel, meet behind a camera, or miss each
///          other by more than `miss` pixels, root mean square
/// Source: Hartley, Zisserman (2000), Multiple view geometry, ch. 11.
[[nodiscard]] std::optional<Eigen::Vector3d> triangulated(
    const std::vector<Camera>& cameras, const std::vector<Sighting>& sightings,
    double miss);

}  // namespace delos::rigid_body
