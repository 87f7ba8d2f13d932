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
#pragma once

#include <delos/device/reading.h>

#include <Eigen/Core>
#include <algorithm>
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

/// Where light falls, u and v, and whether on the photodiode.
/// @param way from the LED to the lens, c − p
template <class T>
void project(const View& view, const delos::Point<T>& way, delos::Reading<T, 2>& out) {
  const auto along = [&](const Eigen::Vector3d& e) {
    return T(way.x * e.x() + way.y * e.y() + way.z * e.z());
  };
  const T depth = -along(view.n), t = view.chord_n / depth;
  const double per_width = 1 / view.half_width;
  out.z[0] = (view.chord_u + t * along(view.e_u)) * per_width;
  out.z[1] = (view.chord_v + t * along(view.e_v)) * per_width;
  using std::abs, std::max;
  const T inside = 1 - max(abs(out.z[0]), abs(out.z[1]));
  out.inside = chosen(plain(depth) > 0, inside, T(-1));
}

}  // namespace hiball
