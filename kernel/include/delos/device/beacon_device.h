// Devices on the target that see beacons through openings, written once.
#pragma once

#include "delos/device/reading.h"
#include "delos/model/wide.h"

namespace delos {

/// A device that looks through openings, and whose readings are formulas of a beacon's
/// place. Model derives from it and has
///
///     Opening opening(int view) const;   // what read() and noise() need of a view
///
///     template <class T>                 // z and inside, whose sign alone matters
///     void read(const Opening&, const Point<T>& p, const Point<double>& n,
///               Reading<T, kRows>& out) const;
///
///     // of what is seen: the variance of each row
///     void noise(const Opening&, const Point<double>& p, const Point<double>& n,
///                const double (&z)[kRows], double (&variance)[kRows]) const;
///
/// besides views() and view_cone(); p and n are a beacon's place and the way that it
/// faces, as Target has them. read() is worked out with T = FirstOrder.
template <class Model, class Opening, int kRows>
class BeaconDevice : public Device {
 public:
  [[nodiscard]] bool observe(const Target& target, Observation& out) const override {
    for (int view = 0; view < views(); ++view)
      if (observe_view(view, target, out)) return true;
    return false;
  }

  [[nodiscard]] bool observe_view(int view, const Target& target,
                                  Observation& out) const override {
    const Opening opening = model().opening(view);
    const Point<double> p = of(target.p_ST), n = of(target.n_ST);
    Reading<FirstOrder, kRows> reading;
    model().read(opening, independent(p.x, p.y, p.z), n, reading);
    if (!(reading.inside.value >= 0)) return false;
    double z[kRows], variance[kRows];
    for (int r = 0; r < kRows; ++r) z[r] = reading.z[r].value;
    model().noise(opening, p, n, z, variance);
    for (int r = 0; r < kRows; ++r) reading.variance[r] = variance[r];
    linearise(reading, out);
    return true;
  }

  [[nodiscard]] bool observe_view_lanes(int view, const BeaconLanes& beacons,
                                        RowLanes& out) const override {
    out.rows = kRows;
    in_wide_vectors([&] {
      // A copy that no store can change: so that the loop becomes vector instructions.
      const Opening opening = model().opening(view);
      for (int l = 0; l < beacons.count; ++l) {
        Reading<FirstOrder, kRows> reading;
        model().read(opening,
                     independent(beacons.p[0][l], beacons.p[1][l], beacons.p[2][l]),
                     lane_of(beacons.n, l), reading);
        out.seen[l] = reading.inside.value >= 0 ? 1 : 0;
        set_slopes(reading, l, out);
        // Here for now: GCC makes vectors of the loop if `out` alone is stored to.
        for (int r = 0; r < kRows; ++r) out.variance[r][l] = reading.z[r].value;
      }
    });
    const Opening& opening = model().opening(view);
    for (int l = 0; l < beacons.count; ++l) {
      if (out.seen[l] == 0) continue;
      double read[kRows], variance[kRows];
      for (int r = 0; r < kRows; ++r) read[r] = out.variance[r][l];
      model().noise(opening, lane_of(beacons.p, l), lane_of(beacons.n, l), read,
                    variance);
      for (int r = 0; r < kRows; ++r) out.variance[r][l] = variance[r];
    }
    return true;
  }

 private:
  [[nodiscard]] const Model& model() const { return static_cast<const Model&>(*this); }

  static Point<double> of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
  static Point<double> lane_of(const double (&v)[3][kLanes], int lane) {
    return {v[0][lane], v[1][lane], v[2][lane]};
  }
};

}  // namespace delos
