// Joint against apart: the paper's open question, in pixels of augmented points.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "delos/rigid_body/camera.h"
#include "delos/rigid_body/filter.h"

namespace delos::rigid_body {

/// A way that a body may move. @param t seconds; @param phase of what swings, radians
struct ComparedMotion {
  std::string name, what;
  BodyPose (*at)(double t, double phase);
  /// Where the coordinates that the joint filter works in have their origin, in W.
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};
/// Swinging from a joint, with the origin on the floor and at the joint; a head that
/// looks about, spinning on a round, shaking.
[[nodiscard]] const std::vector<ComparedMotion>& compared_motions();

/// Two cameras of 640 × 480 pixels 1.1 m to the left and right, 90° apart; and the
/// markers of a body.
[[nodiscard]] std::vector<Camera> stereo_rig();
[[nodiscard]] std::vector<Eigen::Vector3d> marker_body();

/// How readings are drawn.
struct ReadingNoise {
  double image = 0.3;           ///< of a marker in an image, pixels
  double gyroscope = 0.005;     ///< rad/s
  double accelerometer = 0.05;  ///< m/s²
  int reflections = 2;          ///< false markers in every image
};

/// Images of a body: its markers with noise, and false ones anywhere, in a drawn order.
/// @param seed of this frame
[[nodiscard]] std::vector<std::vector<Eigen::Vector2d>> drawn_images(
    const std::vector<Camera>& cameras, const BodyPose& pose, const ReadingNoise& noise,
    std::uint64_t seed);

/// What a tracker measured of a motion, and what was to be shown.
struct MeasuredRun {
  double dt, lag;  ///< seconds
  /// Of each frame.
  std::vector<BodyPose> measured, shown;  ///< shown: the true pose a lag later
  std::vector<Eigen::Vector3d> omega, acceleration;  ///< of an inertial sensor, in W
  double turn, place;    ///< variance of a measured pose about and along an axis
  std::size_t lost = 0;  ///< frames without a pose, which are left out
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the motion
};
/// Measured by BodyTracker from drawn images.
[[nodiscard]] MeasuredRun measured_run(const ComparedMotion& motion, double rate,
                                       double lag, double seconds, std::uint64_t seed,
                                       const ReadingNoise& noise = {});

enum class Formulation {
  none,              ///< the last measured pose
  apart,             ///< ApartFilter
  joint,             ///< BodyFilter about the coordinates' origin, as in the paper
  joint_about_body,  ///< BodyFilter about where the body's origin was
};
[[nodiscard]] const char* to_string(Formulation formulation);

/// Variances that a formulation is told: of ω, v and a at every frame, and of the
/// inertial sensor's readings.
struct Tuning {
  std::array<double, 5> log10 = {-2, -3, -1, -3, -1};
};

/// Root mean square, after half a second, of how far the corners of a cube of 30 cm
/// about the body are off in a display of 1000 pixels focal length 1.2 m before it.
[[nodiscard]] double pixel_error(const MeasuredRun& run, Formulation formulation,
                                 bool inertial, const Tuning& tuning);

/// The tuning with the least mean square over some runs, by steps of a factor along one
/// variance after another, down to 1.8.
[[nodiscard]] Tuning tuned(const std::vector<MeasuredRun>& runs,
                           Formulation formulation, bool inertial);

}  // namespace delos::rigid_body
