// Devices in the world that see points, written once.
#pragma once

#include "delos/device/reading.h"
#include "delos/model/wide.h"

namespace delos {

/// A device whose readings are formulas of a point. Model derives from it and has
///
///     template <class T>
///     void read(const Point<T>& p, Reading<T, kRows>& out) const;
///
/// which fills in all of `out`, with `inside` in metres: it changes by no more than the
/// metres that the point moves. It is worked out with T = double (is a ball in view?),
/// FirstOrder (what is read, and H) and SecondOrder (and the slopes of H). The last is
/// also asked about points out of view: a formula that doesn't go on smoothly there
/// needs an observe_smoothly() of its own. A point at the device itself is never seen.
template <class Model, int kRows>
class PointDevice : public Device {
 public:
  [[nodiscard]] bool observe(const Target& target, Observation& out) const override {
    const Eigen::Vector3d& p = target.p_ST;
    Reading<FirstOrder, kRows> reading;
    if (!seen(p.x(), p.y(), p.z(), reading)) return false;
    linearise(reading, out);
    return true;
  }

  [[nodiscard]] bool observe_lanes(const PointLanes& points,
                                   RowLanes& out) const override {
    out.rows = kRows;
    in_wide_vectors([&] {
      for (int l = 0; l < kLanes; ++l) {
        Reading<FirstOrder, kRows> reading;
        out.seen[l] =
            seen(points.p[0][l], points.p[1][l], points.p[2][l], reading) ? 1 : 0;
        set_slopes(reading, l, out);
        for (int r = 0; r < kRows; ++r) out.variance[r][l] = reading.variance[r].value;
      }
    });
    return true;
  }

  /// @returns false at the device itself, and where a row is perfect
  [[nodiscard]] bool observe_smoothly(const Eigen::Vector3d& p,
                                      SmoothRows& out) const override {
    using T = SecondOrder;
    if (p.isZero(0)) return false;
    const Point<FirstOrder> once = independent(p.x(), p.y(), p.z());
    const Point<T> twice = independent(once.x, once.y, once.z);
    Reading<T, kRows> reading;
    model().read(twice, reading);
    const T margin = reading.inside / sqrt(squared_norm(twice));
    out.rows = kRows;
    out.margin = margin.value.value;
    for (int k = 0; k < 3; ++k) out.margin_slope(k) = margin.value.slope[k];
    for (int r = 0; r < kRows; ++r) {
      const T &z = reading.z[r], &variance = reading.variance[r];
      out.variance(r) = variance.value.value;
      if (!(out.variance(r) > 0)) return false;
      for (int i = 0; i < 3; ++i) {
        out.variance_slope(r, i) = variance.value.slope[i];
        out.H(r, i) = z.value.slope[i];
        for (int k = 0; k < 3; ++k) out.H_slope[k](r, i) = z.slope[k].slope[i];
      }
    }
    return true;
  }

  [[nodiscard]] View view_of_ball(const Eigen::Vector3d& center,
                                  double radius) const override {
    Reading<double, kRows> reading;
    model().read(Point<double>{center.x(), center.y(), center.z()}, reading);
    const double distance = center.norm(), inside = reading.inside;
    // Rounding may not turn a touch into a certainty.
    const double sure = radius + 1e-9 * distance;
    if (inside < -sure) return View::outside;
    return inside > sure && distance > sure ? View::inside : View::crossing;
  }

 private:
  [[nodiscard]] const Model& model() const { return static_cast<const Model&>(*this); }

  /// @returns whether the point is in view
  bool seen(double x, double y, double z, Reading<FirstOrder, kRows>& out) const {
    model().read(independent(x, y, z), out);
    return (out.inside.value >= 0) & (x * x + y * y + z * z > 0);
  }
};

}  // namespace delos
