// A body's pose out of images of its markers, frame by frame: F1 to F5.
#pragma once

#include <optional>
#include <vector>

#include "delos/rigid_body/camera.h"
#include "delos/rigid_body/filter.h"
#include "delos/rigid_body/refine.h"

namespace delos::rigid_body {

struct TrackerOptions {
  double sigma = 0.3;        ///< noise of a marker's image, pixels
  double tolerance = 0.004;  ///< of distances between markers, metres
  double arm = 0.1;          ///< of the virtual points from the body's origin, metres
  double gate = 14;          ///< χ² of a search window, two degrees: 0.999
  int coast = 5;             ///< frames without a pose before the filter begins anew
  BodyNoise noise = {};
};

/// What one frame gave.
struct TrackedFrame {
  std::optional<MeasuredPose> measured;  ///< nothing: it wasn't found
  std::size_t markers = 0;               ///< that the pose is of
  bool by_windows = false;  ///< found in search windows, else in the whole images
  double window_area = 0;   ///< part of the images that windows cover, in the mean
};

/// Follows one body.
///
/// Each frame's images are searched where the filter expects the markers, and where
/// that fails all over: every two images of two cameras that may be of one point make a
/// cloud, in which the body is found by its distances. What is found is triangulated
/// (F1), aligned with the body, false matches rejected (F2), and refined on the images;
/// three virtual points of the pose (F3) go to the filter, whose prediction (F4) is
/// projected (F5). Source: Dorfmüller-Ulhaas (2003), §3, Figs. 5, 6.
class BodyTracker {
 public:
  /// @param cameras two or more
  /// @param body its markers, three or more and not in one line, metres
  BodyTracker(std::vector<Camera> cameras, std::vector<Eigen::Vector3d> body,
              const TrackerOptions& options = {});

  /// @param dt since the frame before, > 0
  /// @param images what looks like a marker, of each camera, pixels
  TrackedFrame frame(double dt,
                     const std::vector<std::vector<Eigen::Vector2d>>& images);

  /// Where the body is going to be a time after the last frame; nothing before it was
  /// found.
  [[nodiscard]] std::optional<BodyPose> predicted(double lag) const;
  [[nodiscard]] const BodyFilter& filter() const { return filter_; }

 private:
  using Images = std::vector<std::vector<Eigen::Vector2d>>;
  std::optional<MeasuredPose> look_in_windows(double dt, const Images& images,
                                              TrackedFrame& frame) const;
  std::optional<MeasuredPose> look_all_over(const Images& images,
                                            TrackedFrame& frame) const;
  std::optional<MeasuredPose> pose_of(const std::vector<std::vector<Sighting>>& seen,
                                      TrackedFrame& frame) const;

  std::vector<Camera> cameras_;
  std::vector<Eigen::Vector3d> body_;
  TrackerOptions options_;
  BodyFilter filter_;
  std::optional<MeasuredPose> last_;
  int frames_ = 0;    // in a row, that the filter knows of
  int coasting_ = 0;  // frames since the last one
  double dt_ = 0;
};

}  // namespace delos::rigid_body
