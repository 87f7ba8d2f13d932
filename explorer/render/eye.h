// Where a picture of a room is looked at from, and where its points fall.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>

namespace delos::render {

/// A direction to look along, and from how far.
struct View {
  Eigen::Vector3d towards;  ///< from what is looked at to the eye, world, unit length
  std::optional<double> distance =
      {};  ///< metres; by default all that is looked at fits
  bool orthographic = false;
};

/// A view by its name (corner, top, below, front, back, right, left) or as "azimuth,
/// elevation[,distance]": of the eye, from x towards y and above the horizon, degrees
/// or with a unit; metres.
/// @throws session::Refusal that it is none, and which there are
[[nodiscard]] View view_of(const std::string& text);

/// What a picture is drawn on, pixels, y downwards.
struct Frame {
  int width = 0, height = 0;
  int free = 0;  ///< from the left, what no legend covers
};

/// A point of the picture.
struct Spot {
  double x = 0, y = 0;  ///< pixels
  /// Larger is nearer; straight in the picture along straight lines of the room.
  double nearness = 0;
  /// What attributes of corners are weighed with, so that they are straight in the
  /// room.
  double weight = 1;
};

/// from + t·along, world, metres; t is the distance ahead of the eye.
struct Ray {
  Eigen::Vector3d from, along;
};

class Eye {
 public:
  /// @param room what is looked at, metres, not empty
  Eye(const View& view, const Eigen::AlignedBox3d& room, const Frame& frame);

  /// A point of the world as the eye has it: right, up, and ahead; metres.
  [[nodiscard]] Eigen::Vector3d seen(const Eigen::Vector3d& world) const;
  /// A direction of the world likewise.
  [[nodiscard]] Eigen::Vector3d turned(const Eigen::Vector3d& world) const {
    return R_EW_ * world;
  }
  /// @pre seen.z ≥ nearest()
  [[nodiscard]] Spot spot(const Eigen::Vector3d& seen) const;
  /// What is nearer isn't seen, metres ahead.
  [[nodiscard]] double nearest() const { return nearest_; }
  /// The ray that falls on a spot of the eye's frame, pixels.
  [[nodiscard]] Ray ray(double x, double y) const;
  /// How far ahead something of a nearness is, metres.
  [[nodiscard]] double ahead(double nearness) const;
  /// A nearness that lies a little before another one.
  [[nodiscard]] double before(double nearness) const;

  [[nodiscard]] bool orthographic() const { return orthographic_; }
  /// Where the eye is, world, metres. @pre not orthographic()
  [[nodiscard]] Eigen::Vector3d position() const {
    return centre_ - distance_ * R_EW_.row(2).transpose();
  }

 private:
  Eigen::Matrix3d R_EW_;  // rows: right, up, ahead
  Eigen::Vector3d centre_;
  double distance_ = 1, nearest_ = 0, scale_ = 1, size_ = 1;
  double x0_, y0_;  // where it looks, pixels
  bool orthographic_;
};

}  // namespace delos::render
