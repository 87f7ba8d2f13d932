#include "view.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace hiball {

using Eigen::Vector3d;

double angle(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

std::optional<View> view_of(const Opening& opening) {
  const double focal = opening.focal, half_width = opening.half_width;
  View w;
  w.n = opening.diode;
  w.lens_p = focal / 2 * opening.lens;
  w.half_width = half_width;
  // Horizontal where that is a direction.
  const Vector3d level = Vector3d::UnitZ().cross(w.n);
  w.e_u = level.norm() > 1e-9 ? level.normalized() : Vector3d::UnitX();
  w.e_v = w.n.cross(w.e_u);
  // Opposite axes put the lens on the photodiode: nothing is seen through it.
  const Vector3d chord = w.lens_p + focal / 2 * w.n;
  if (chord.norm() < 1e-6 * focal) return {};
  w.chord_n = chord.dot(w.n);
  w.chord_u = chord.dot(w.e_u);
  w.chord_v = chord.dot(w.e_v);
  w.cone.apex = w.lens_p;
  w.cone.axis = chord.normalized();
  w.cone.half_angle = 0;
  for (const double u : {-half_width, half_width}) {
    for (const double v : {-half_width, half_width}) {
      const Vector3d corner = chord - u * w.e_u - v * w.e_v;
      w.cone.half_angle = std::max(w.cone.half_angle, angle(corner, chord) + 1e-9);
    }
  }
  return w;
}

}  // namespace hiball
