// Readings written once as formulas of a point, and what is made of them.
#pragma once

#include "delos/device/device.h"
#include "delos/expression/dual.h"

namespace delos {

/// Numbers with their slopes along the coordinates of a point, and with those of the
/// slopes.
using FirstOrder = Dual<double, 3>;
using SecondOrder = Dual<FirstOrder, 3>;

/// A point or a direction in a device's frame S; T is double, FirstOrder or
/// SecondOrder.
template <class T>
struct Point {
  T x, y, z;
};

/// ‖p‖².
template <class T>
[[nodiscard]] T squared_norm(const Point<T>& p) {
  return p.x * p.x + p.y * p.y + p.z * p.z;
}

/// Coordinates that move by themselves: ∂x/∂x = 1, ∂x/∂y = 0, …
template <class S>
[[nodiscard]] Point<Dual<S, 3>> independent(const S& x, const S& y, const S& z) {
  return {Dual<S, 3>(x, 0), Dual<S, 3>(y, 1), Dual<S, 3>(z, 2)};
}

/// What a device reads of a point: rows of independent noise.
template <class T, int kRows>
struct Reading {
  static_assert(kRows >= 1 && kRows <= kMaxLaneRows);
  T z[kRows];         ///< noiseless, measurement units
  T variance[kRows];  ///< of each row's noise; 0: perfect
  /// How far inside the view the point is: at least 0 where it is seen, below 0 where
  /// it isn't.
  T inside;
};

/// As the contract has it.
template <int kRows>
void linearise(const Reading<FirstOrder, kRows>& reading, Observation& out) {
  out.z.resize(kRows);
  out.H.resize(kRows, 3);
  out.R.setZero(kRows, kRows);
  for (int r = 0; r < kRows; ++r) {
    out.z(r) = reading.z[r].value;
    for (int k = 0; k < 3; ++k) out.H(r, k) = reading.z[r].slope[k];
    out.R(r, r) = reading.variance[r].value;
  }
}

/// The Jacobian of one of many points.
template <int kRows>
void set_slopes(const Reading<FirstOrder, kRows>& reading, int lane, RowLanes& out) {
  for (int r = 0; r < kRows; ++r)
    for (int k = 0; k < 3; ++k) out.H[r][k][lane] = reading.z[r].slope[k];
}

}  // namespace delos
