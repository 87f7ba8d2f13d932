// A photodiode that looks through a lens: where the light of an LED falls.
//
// Lens j stands at (f/2) n_j and photodiode i at −(f/2) n_i, facing along its axis n_i.
// View (i, j) is photodiode i through lens j. Light of an LED at p goes straight
// through the lens's centre c and falls on the photodiode's plane at
//
//   q = c + t (c − p),   t = −(c + (f/2) n_i)·n_i / ((c − p)·n_i)
//
// which the photodiode reads in half-widths w = f tan(field/2) along its axes e_u, e_v:
//
//   u = (q + (f/2) n_i)·e_u / w,   v = (q + (f/2) n_i)·e_v / w,   seen for |u|, |v| ≤ 1
//   ∂q/∂p = −t I + (c − p) (∂t/∂p)ᵀ,   ∂t/∂p = t n_i / ((c − p)·n_i)
#pragma once

#include <delos/device/device.h>

#include <Eigen/Core>
#include <cmath>
#include <optional>

namespace hiball {

struct View {
  Eigen::Vector3d n;                 ///< the photodiode's axis
  Eigen::Vector3d lens_p;            ///< c
  Eigen::Vector3d e_u, e_v;          ///< the photodiode's axes
  double chord_n, chord_u, chord_v;  ///< c + (f/2) n along the three
  double half_width;                 ///< w, metres
  delos::ViewCone cone;
};

/// What a view is made of.
struct Opening {
  const Eigen::Vector3d &diode, &lens;  ///< n_i, n_j
  double focal, half_width;             ///< metres
};

/// Nothing where the lens stands on the photodiode.
[[nodiscard]] std::optional<View> view_of(const Opening& opening);

/// Between two directions, radians.
[[nodiscard]] double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Where light falls.
struct Spot {
  bool seen;
  double u, v;
  /// ∂u/∂p = scale (e_u + lean_u n); likewise v
  double scale, lean_u, lean_v;
};

/// @param x, y, z the way from the LED to the lens, c − p
[[nodiscard]] inline Spot project(const View& view, double x, double y, double z) {
  const auto along = [&](const Eigen::Vector3d& e) {
    return x * e.x() + y * e.y() + z * e.z();
  };
  const double depth = -along(view.n);
  const double per_depth = 1 / depth, per_width = 1 / view.half_width;
  const double t = view.chord_n * per_depth;
  const double way_u = along(view.e_u), way_v = along(view.e_v);
  const double u = (view.chord_u + t * way_u) * per_width;
  const double v = (view.chord_v + t * way_v) * per_width;
  const bool seen = (depth > 0) & (std::abs(u) <= 1) & (std::abs(v) <= 1);
  return {seen, u, v, -t * per_width, way_u * per_depth, way_v * per_depth};
}

}  // namespace hiball
