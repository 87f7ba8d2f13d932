// What a calibration of cameras says, whichever program wrote it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "delos/model/pose.h"
#include "imports/value.h"

namespace delos::imports {

/// How a lens bends; the models of delos/device/camera_model.h.
enum class Lens { brown_conrady, rational, fisheye };

/// A camera as it was calibrated. Pixels count as OpenCV has it: the middle of the
/// first one is 0.
struct CalibratedCamera {
  std::string name;
  Eigen::Vector2d size = Eigen::Vector2d::Zero();  ///< pixels; 0: the file doesn't say
  Eigen::Vector2d f = Eigen::Vector2d::Zero();     ///< focal lengths, pixels
  Eigen::Vector2d c = Eigen::Vector2d::Zero();     ///< where the axis meets the image
  double skew = 0;                                 ///< of K, pixels
  Lens lens = Lens::brown_conrady;
  std::array<double, 6> k{};  ///< k1 … k6
  std::array<double, 2> p{};  ///< p1, p2
  /// X_WC: the camera's frame, x right, y down, z forward, in the world, metres;
  /// nullopt: the file doesn't say where it is.
  std::optional<Pose> X_WC;
  std::string residual;  ///< as the file has it: "0.402 (avg-residual)"; may be empty
  int line = 0;          ///< where it stands
};

/// What the user says of a file that the file doesn't.
struct ImportOptions {
  std::optional<double> unit;                 ///< of lengths, metres
  std::optional<Eigen::Vector2d> resolution;  ///< of all images, pixels
  std::string up;  ///< which way is up in the file: "z", "y", "-y"; empty: as known
  std::string subject;           ///< of files with several set-ups
  bool mirrored = false;         ///< principal points count from the opposite corner
  std::optional<double> height;  ///< of rooms, metres
};

/// A whole calibration.
struct Calibration {
  /// How the file has it, in sentences: units, axes, what was made of it.
  std::vector<std::string> facts;
  std::vector<CalibratedCamera> cameras;
  std::string up = "z";  ///< of the world that X_WC is in
};

/// The coefficients as OpenCV orders them: k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 s2 s3 s4 [τ_x
/// τ_y]]]], or k1 … k4 of a fisheye. The camera's are left at 0 where there is an
/// error.
void set_distortion(CalibratedCamera& camera, const std::vector<double>& coefficients,
                    bool fisheye, const Value& at, Source& source);

/// K, row by row.
void set_matrix(CalibratedCamera& camera, const std::vector<double>& K, const Value& at,
                Source& source);

/// A rotation of nine numbers, row by row. What was rounded is made a rotation.
/// @returns nullopt, with an error: a mirror, or far from any rotation
[[nodiscard]] std::optional<Eigen::Matrix3d> rotation_of(const std::vector<double>& R,
                                                         const Value& at,
                                                         Source& source);
/// A rotation by a vector along its axis, as long as its angle (Rodrigues), or by nine
/// numbers.
[[nodiscard]] std::optional<Eigen::Matrix3d> rotation_in(const Value& map,
                                                         std::string_view name,
                                                         Source& source);

/// X_WC of a camera whose file has p_C = R p_W + t.
[[nodiscard]] inline Pose from_world_to_camera(const Eigen::Matrix3d& R,
                                               const Eigen::Vector3d& t) {
  return Pose{R, t}.inverse();
}

/// The unit of lengths that the user says.
/// @returns nullopt, with an error that asks for it
[[nodiscard]] std::optional<double> asked_unit(const ImportOptions& options,
                                               Source& source);

/// Images' sizes from the options where the file has none, the world turned so that z
/// is up, and what can't be: errors. What is hardly meant: warnings. Camera by camera,
/// so that all are told at once.
void check(Calibration& calibration, const ImportOptions& options, Source& source);

}  // namespace delos::imports
