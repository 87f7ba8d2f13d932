// How the target is expected to move between measurements.
#pragma once

#include <variant>
#include <vector>

#include "delos/api.h"
#include "delos/model/state.h"

namespace delos {

/// One step of the motion: x⁺ = A x + w, w ~ N(0, Q).
struct MotionStep {
  StateMatrix A;  ///< transition, n×n
  StateMatrix Q;  ///< process noise, n×n, squared state units
};

/// An integrator chain per pose coordinate, driven by white noise: P, PV or PVA.
///
///     dx_i/dt = x_{i+1},  dx_{k−1}/dt = noise of spectral density q
///
/// Source: Allen (2007), dissertation, Eqs. 21–25.
struct ChainMotion {
  CoordinateMatrix q;  ///< d×d, symmetric > 0, (m or rad)²/s^(2k−1)
  friend bool operator==(const ChainMotion& a, const ChainMotion& b) {
    return same_matrix(a.q, b.q);
  }
};

/// A given discrete model of one update; it has no continuous-time form.
struct CustomMotion {
  StateMatrix A;  ///< n×n
  StateMatrix Q;  ///< n×n, symmetric ≥ 0
  friend bool operator==(const CustomMotion& a, const CustomMotion& b) {
    return same_matrix(a.A, b.A) && same_matrix(a.Q, b.Q);
  }
};

/// How a state of a device's own changes, whatever the target does: dx/dt = −x/T + w.
struct GaussMarkov {
  double time_constant = 0;  ///< T, seconds, > 0; infinite: a random walk
  double density = 0;        ///< of w, squared state units per second, ≥ 0
  friend bool operator==(const GaussMarkov&, const GaussMarkov&) = default;
};

/// A given model in continuous time: dx/dt = A x + w, w white of spectral density Q.
struct ContinuousMotion {
  StateMatrix A;  ///< drift, n×n, state units over seconds
  StateMatrix Q;  ///< n×n, symmetric ≥ 0, squared state units over seconds
  friend bool operator==(const ContinuousMotion& a, const ContinuousMotion& b) {
    return same_matrix(a.A, b.A) && same_matrix(a.Q, b.Q);
  }
};

/// The motion model of a scene.
struct MotionModel {
  StateLayout layout;
  std::variant<ChainMotion, CustomMotion, ContinuousMotion> dynamics;
  std::vector<GaussMarkov> own = {};  ///< of the last states of the layout

  /// True for P, PV and PVA, for which exact closed forms exist.
  [[nodiscard]] bool is_chain() const {
    return std::holds_alternative<ChainMotion>(dynamics);
  }
  /// Whether it is known over any time, and not over one update alone.
  [[nodiscard]] bool in_continuous_time() const {
    return !std::holds_alternative<CustomMotion>(dynamics);
  }
  friend bool operator==(const MotionModel&, const MotionModel&) = default;
};

/// A and Q over a time dt. For chains of order k, with i, j from 0:
///
///     A_ij = dt^(j−i)/(j−i)!
///     Q_ij = q dt^(2k−1−i−j) / ((2k−1−i−j) (k−1−i)! (k−1−j)!)
///
/// and for the devices' own states, exp(−dt/T) and (1 − exp(−2dt/T)) q T/2, or 1 and
/// q dt where T is infinite. Of a ContinuousMotion as model/van_loan.h has it. A custom
/// model is one update whatever dt is.
/// @param dt seconds, > 0
[[nodiscard]] DELOS_API MotionStep discretize(const MotionModel& motion, double dt);

/// The model as dx/dt = A x + w, with Q the noise's spectral density, n×n.
/// @pre motion.in_continuous_time()
[[nodiscard]] DELOS_API MotionStep continuous_form(const MotionModel& motion);

}  // namespace delos
