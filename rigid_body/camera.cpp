#include "delos/rigid_body/camera.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

namespace delos::rigid_body {

Camera looking_at(const Eigen::Vector3d& p, const Eigen::Vector3d& at,
                  const Eigen::Vector3d& up) {
  Camera camera;
  camera.p = p;
  const Eigen::Vector3d z = (at - p).normalized(), x = z.cross(up).normalized();
  camera.R_WC << x, z.cross(x), z;
  return camera;
}

std::optional<Eigen::Vector2d> image_of(const Camera& camera,
                                        const Eigen::Vector3d& p_W,
                                        Eigen::Matrix<double, 2, 3>* slope) {
  const Eigen::Vector3d c = camera.R_WC.transpose() * (p_W - camera.p);
  if (!(c.z() > 1e-6)) return std::nullopt;
  const Eigen::Vector2d on = c.head<2>() / c.z();
  const Eigen::Vector2d uv = camera.focal * on + camera.centre;
  if ((uv.array() < 0).any() || (uv.array() > camera.size.array()).any())
    return std::nullopt;
  if (slope) {
    Eigen::Matrix<double, 2, 3> of_c;
    of_c << 1, 0, -on.x(), 0, 1, -on.y();
    *slope = camera.focal / c.z() * of_c * camera.R_WC.transpose();
  }
  return uv;
}

std::optional<Eigen::Vector3d> triangulated(const std::vector<Camera>& cameras,
                                            const std::vector<Sighting>& sightings,
                                            double miss) {
  // Nearest to the rays: Σ (I − d dᵀ)(x − p) = 0.
  Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  for (const Sighting& s : sightings) {
    const Camera& camera = cameras[s.camera];
    Eigen::Vector3d d;
    d << (s.uv - camera.centre) / camera.focal, 1;
    d = (camera.R_WC * d).normalized();
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - d * d.transpose();
    N += across;
    x += across * camera.p;
  }
  const Eigen::LDLT<Eigen::Matrix3d> split(N);
  if (!(split.vectorD().minCoeff() > 1e-6)) return std::nullopt;
  x = split.solve(x);
  double squares = 0;
  for (int step = 0; step < 4; ++step) {  // the last one only measures
    N.setZero();
    squares = 0;
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (const Sighting& s : sightings) {
      Eigen::Matrix<double, 2, 3> J;
      const auto uv = image_of(cameras[s.camera], x, &J);
      if (!uv) return std::nullopt;
      const Eigen::Vector2d left = s.uv - *uv;
      squares += left.squaredNorm();
      N += J.transpose() * J;
      b += J.transpose() * left;
    }
    if (step < 3) x += N.ldlt().solve(b);
  }
  if (squares > miss * miss * 2 * static_cast<double>(sightings.size()))
    return std::nullopt;
  return x;
}

}  // namespace delos::rigid_body
