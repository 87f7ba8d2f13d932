#include "imports/calibration.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "delos/text/format.h"
#include "delos/text/units.h"
#include "delos/text/words.h"

namespace delos::imports {
namespace {

/// Takes what was up to z, and keeps the world right-handed: y to z by a quarter turn
/// about x, -y to z by the opposite one.
std::optional<Eigen::Matrix3d> turn_to_z_up(const std::string& up) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  if (up == "y") R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (up == "-y") R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return up == "z" || up == "y" || up == "-y" ? std::optional(R) : std::nullopt;
}

void check_lens(CalibratedCamera& camera, const ImportOptions& options,
                Source& source) {
  const std::string who = "'" + camera.name + "': ";
  if (!(camera.size.array() > 0).all() && options.resolution)
    camera.size = *options.resolution;
  if (!(camera.size.array() >= 1).all()) {
    source.error(camera.line, who +
                                  "its file doesn't say how large images are; give "
                                  "--resolution WIDTHxHEIGHT, such as 1280x1024");
    return;
  }
  constexpr double kLargest = 1e5;  // px
  if (!(camera.size.array() <= kLargest).all())
    source.error(camera.line, who + "an image of " + shortest(camera.size.x()) + " x " +
                                  shortest(camera.size.y()) +
                                  " pixels can't be; which unit is it in?");
  const double longer = camera.size.maxCoeff();
  for (const double f : camera.f)
    if (!(f > 0) || f > 10 * longer || f < longer / 10) {
      source.error(camera.line,
                   who + "a focal length of " + shortest(f) + " px doesn't go with " +
                       "images of " + shortest(camera.size.x()) + " x " +
                       shortest(camera.size.y()) +
                       " px: more than ten times off; which unit is it in?");
      return;
    }
  const bool outside = camera.c.x() <= 0 || camera.c.y() <= 0 ||
                       camera.c.x() >= camera.size.x() ||
                       camera.c.y() >= camera.size.y();
  if (outside)
    source.warning(camera.line, who +
                                    "its optical axis meets the image outside of it, "
                                    "at (" +
                                    shortest(camera.c.x()) + ", " +
                                    shortest(camera.c.y()) + ")");
  if (std::abs(camera.skew) > 1e-6 * longer)
    source.warning(camera.line, who + "its image is skewed by " +
                                    shortest(camera.skew) +
                                    " px, which Delos's camera isn't; left out");
}

void check_places(const Calibration& calibration, Source& source) {
  Eigen::AlignedBox3d box;
  double farthest = 0;
  for (const CalibratedCamera& camera : calibration.cameras)
    if (camera.X_WC) {
      if (!(camera.X_WC->p.array().abs() < 1e9).all())
        source.error(camera.line, "'" + camera.name + "' is nowhere that can be");
      box.extend(camera.X_WC->p);
      farthest = std::max(farthest, camera.X_WC->p.norm());
    }
  if (box.isEmpty() || calibration.cameras.size() < 2) return;
  const double wide = box.diagonal().norm();
  constexpr double kHall = 200, kHead = 0.02;  // metres
  if (wide > kHall)
    source.warning(0, "cameras are " + format_quantity(wide, "m") +
                          " apart; are lengths in millimetres? --unit mm says so");
  if (wide < kHead && calibration.cameras.size() > 2)
    source.warning(0, "cameras are only " + format_quantity(wide, "m") +
                          " apart; are lengths in metres? --unit m says so");
}

}  // namespace

void set_distortion(CalibratedCamera& camera, const std::vector<double>& coefficients,
                    bool fisheye, const Value& at, Source& source) {
  const std::size_t n = coefficients.size();
  const auto has = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, n); ++i)
      if (coefficients[i] != 0) return true;
    return false;
  };
  if (fisheye) {
    if (n > 4 && has(4, n)) {
      source.error(at,
                   "a fisheye has 4 coefficients, and these are " + std::to_string(n));
      return;
    }
    camera.lens = Lens::fisheye;
    std::copy_n(coefficients.begin(), std::min<std::size_t>(n, 4), camera.k.begin());
    return;
  }
  constexpr std::size_t kKnown[] = {0, 1, 2, 4, 5, 8, 12, 14};
  if (std::find(std::begin(kKnown), std::end(kKnown), n) == std::end(kKnown)) {
    source.error(at, std::to_string(n) +
                         " coefficients of distortion are of no model that is known: "
                         "4, 5, 8, 12 or 14 are");
    return;
  }
  if (has(8, n)) {
    source.error(at,
                 "thin prisms and tilted sensors (coefficients from the ninth on) "
                 "aren't known; calibrate without them");
    return;
  }
  std::array<double, 8> all{};
  std::copy_n(coefficients.begin(), std::min<std::size_t>(n, 8), all.begin());
  camera.lens = has(5, 8) ? Lens::rational : Lens::brown_conrady;
  camera.k = {all[0], all[1], all[4], all[5], all[6], all[7]};
  camera.p = {all[2], all[3]};
}

void set_matrix(CalibratedCamera& camera, const std::vector<double>& K, const Value& at,
                Source& source) {
  if (K[8] == 0 || K[3] != 0 || K[6] != 0 || K[7] != 0) {
    source.error(at,
                 "isn't a camera's matrix [[f_x, s, c_x], [0, f_y, c_y], [0, 0, 1]]");
    return;
  }
  camera.f = {K[0] / K[8], K[4] / K[8]};
  camera.c = {K[2] / K[8], K[5] / K[8]};
  camera.skew = K[1] / K[8];
}

std::optional<Eigen::Matrix3d> rotation_of(const std::vector<double>& numbers,
                                           const Value& at, Source& source) {
  const Eigen::Matrix3d given =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data());
  if (given.determinant() < -0.5) {
    source.error(at, "has the determinant " + shortest(given.determinant()) +
                         ": it mirrors, which no camera does; an axis is the wrong way "
                         "round");
    return std::nullopt;
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      given, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d R = svd.matrixU() * svd.matrixV().transpose();
  constexpr double kRounded = 0.02;  // two digits of each entry
  if (!((R - given).norm() < kRounded) || R.determinant() < 0) {
    source.error(at,
                 "isn't a rotation: its rows must be of length 1 and at right "
                 "angles");
    return std::nullopt;
  }
  // A file with all digits is taken as it is.
  return (R - given).norm() < 1e-12 ? given : R;
}

std::optional<Eigen::Matrix3d> rotation_in(const Value& map, std::string_view name,
                                           Source& source) {
  const Value* value = map.find(name);
  const auto all = value ? numbers_in(*value) : std::nullopt;
  if (all && all->size() == 9) return rotation_of(*all, *value, source);
  const auto vector = numbers(map, name, 3, source);
  if (!vector) return std::nullopt;
  const Eigen::Map<const Eigen::Vector3d> w(vector->data());
  const double angle = w.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, w / angle).toRotationMatrix();
}

std::optional<double> asked_unit(const ImportOptions& options, Source& source) {
  if (!options.unit)
    source.error(0,
                 "lengths of this format have no unit in the file; say which by "
                 "--unit mm, --unit m, or, of a scale of its own, --unit '0.35 m'");
  return options.unit;
}

void check(Calibration& calibration, const ImportOptions& options, Source& source) {
  if (calibration.cameras.empty() && source.errors() == 0)
    source.error(0, "has no camera");
  if (calibration.cameras.size() > 1000) source.error(0, "has more than 1000 cameras");
  for (CalibratedCamera& camera : calibration.cameras)
    check_lens(camera, options, source);
  check_places(calibration, source);
  const std::string up = options.up.empty() ? calibration.up : options.up;
  const auto turn = turn_to_z_up(up);
  if (!turn) {
    source.error(0, "'" + up + "' is no axis that is up: z, y or -y is");
    return;
  }
  if (up != "z") {
    for (CalibratedCamera& camera : calibration.cameras)
      if (camera.X_WC)
        camera.X_WC = Pose{*turn, Eigen::Vector3d::Zero()} * *camera.X_WC;
    calibration.facts.push_back("turned so that z is up, which was " + up);
  }
}

}  // namespace delos::imports
