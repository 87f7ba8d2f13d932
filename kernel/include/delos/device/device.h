// The device contract: what a plugin author implements.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/model/lanes.h"
#include "delos/model/state.h"

namespace delos {

/// Most rows that one device reports in one update.
inline constexpr int kMaxRows = 30;

/// What a device's readings depend on: the columns of its Jacobian.
enum class Span {
  point,  ///< 3: the position of a point, δp. The kernel knows how it moves with the
          ///< pose.
  pose,   ///< 6: the target's pose, [δp, δθ]
  motion,  ///< 18: pose, its velocity and acceleration, [δp, δθ, δv, δω, δa, δα]
  state,  ///< n: the filter's state itself, in the order of StateLayout::names()
};

/// The thing being tracked, as one device sees it.
struct Target {
  /// Where the observed point or the target is, metres, in the device's frame S. A
  /// device that the target carries, and that doesn't see points, measures how it moves
  /// itself: it is at the origin.
  Eigen::Vector3d p_ST = Eigen::Vector3d::Zero();
  /// The target's orientation in S. Identity for Span::point, which sees a bare point.
  Eigen::Matrix3d R_ST = Eigen::Matrix3d::Identity();
  /// [v, ω] in S, m/s and rad/s. Fields are linearised about rest: zero there.
  Eigen::Matrix<double, 6, 1> velocity = Eigen::Matrix<double, 6, 1>::Zero();
  /// [a, α] in S, m/s² and rad/s². Zero in fields.
  Eigen::Matrix<double, 6, 1> acceleration = Eigen::Matrix<double, 6, 1>::Zero();
  /// Deviation of the whole state from the point of linearisation, n×1, SI. Zero in
  /// fields; the contract test moves it.
  StateVector state;
  /// The device's own states. Zero in fields; the contract test moves them.
  StateVector own;
  /// Which way the observed point faces, a unit vector in S: a beacon's normal. Zero
  /// where it faces no way: markers, and beacons that radiate all around.
  Eigen::Vector3d n_ST = Eigen::Vector3d::Zero();
};

/// A state of a device's own, which its readings depend on and the filter estimates
/// besides the motion: a bias, a drift. A first-order Gauss–Markov process,
///
///     db/dt = −b/T + w,   w white with spectral density q
///
/// and a random walk where T is infinite.
struct OwnState {
  std::string name;  ///< snake_case; the filter's state is called DEVICE_name
  std::string unit;  ///< SI
  double time_constant = std::numeric_limits<double>::infinity();  ///< T, s, > 0
  double density = 0;  ///< q, unit²/s, ≥ 0; 0 at an infinite T: a constant
};

/// What a device measures of a target, linearised there. Stored inline.
struct Observation {
  /// The noiseless reading, m×1, measurement units. P∞ never needs it; simulated
  /// readings are made of it, and the contract test checks H by its differences.
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxRows, 1> z;
  /// Jacobian ∂z/∂(the columns of Span, then the device's own states), m×c, in the
  /// device's frame S.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxRows,
                kMaxState>
      H;
  /// Covariance of z, m×m, symmetric ≥ 0, measurement units squared. Singular: perfect.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxRows,
                kMaxRows>
      R;
};

/// Up to kLanes points in a device's frame S.
struct PointLanes {
  int count = 0;        ///< how many of them are asked for; the rest hold any number
  double p[3][kLanes];  ///< x, y, z, metres
};

/// Up to kLanes beacons in the frame S of a device on the target.
struct BeaconLanes {
  int count = 0;        ///< how many there are; the rest hold any number
  double p[3][kLanes];  ///< x, y, z, metres
  double n[3][kLanes];  ///< which way they face, unit vectors; zero: they face no way
};

/// Most rows that a device may report of many points at once.
inline constexpr int kMaxLaneRows = 3;

/// What a device measures of up to kLanes points or beacons: rows of independent noise.
struct RowLanes {
  int rows = 0;  ///< of every point
  /// 1: the point is seen; 0: it isn't, and what stands below is never read.
  double seen[kLanes];
  double H[kMaxLaneRows][3][kLanes];      ///< Jacobian with respect to the point, in S
  double variance[kMaxLaneRows][kLanes];  ///< of each row's noise; 0: perfect
};

/// What a device would measure of a point if its view had no edge: rows of independent
/// noise, with their slopes. For gradient searches, which need edges that are soft.
struct SmoothRows {
  int rows = 0;
  /// How far the point is inside the view, as an angle in radians or a part of its
  /// distance: above 0 where observe() sees it, below 0 where it doesn't. Continuous.
  double margin = 0;
  Eigen::Vector3d margin_slope = Eigen::Vector3d::Zero();  ///< ∂margin/∂p, 1/m
  Eigen::Matrix3d H;               ///< row i: Jacobian of reading i with respect to p
  Eigen::Vector3d variance;        ///< of each row's noise, > 0
  Eigen::Matrix3d H_slope[3];      ///< ∂H/∂p_k
  Eigen::Matrix3d variance_slope;  ///< row i: ∂variance_i/∂p
};

/// Where something is with respect to what a device can see.
enum class View {
  outside,   ///< all of it is unseen
  inside,    ///< all of it is in view
  crossing,  ///< some of it may be, some not
  unknown,   ///< the device doesn't say
};

/// A cone of directions, in the frame of whoever holds it.
struct ViewCone {
  Eigen::Vector3d apex = Eigen::Vector3d::Zero();   ///< where it looks from, metres
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< unit vector
  double half_angle = 3.15;  ///< between axis and edge, radians; π or more: all around
  double range = std::numeric_limits<double>::infinity();  ///< reach, metres
};

/// A sensor or beacon. Knows its own frame S and nothing of the world: the kernel
/// places it, tests the line of sight and turns H into the world frame.
///
/// Instances are immutable; observe() is called from many threads at once.
class DELOS_API Device {
 public:
  virtual ~Device();

  /// What the columns of H are.
  [[nodiscard]] virtual Span span() const { return Span::point; }
  /// Number of columns for Span::state; the loader compares it with the state's size.
  [[nodiscard]] virtual int state_size() const { return 0; }

  /// States of its own, which readings depend on besides the target; none, as here.
  [[nodiscard]] virtual std::vector<OwnState> states() const { return {}; }

  /// Linearise the measurement of the target.
  /// @returns false when it is out of reach or view; `out` is then unspecified.
  [[nodiscard]] virtual bool observe(const Target& target, Observation& out) const = 0;

  /// After how much a row of z comes back to itself: 2π of an angle that is read all
  /// around, so that readings near π and −π are neighbours. What is left of such a
  /// reading is the least that leads there.
  /// @param row of observe()
  /// @returns 0, as here, where it doesn't
  [[nodiscard]] virtual double period(int row) const;

  /// The part of each row's variance that all points seen in one update have in common,
  /// as the jitter of a rotor that sweeps over them: of row r, two points' readings
  /// have this covariance. observe()'s R, of one point, holds it, and is diagonal then.
  /// @returns of the rows of a Span::point, measurement units squared, ≥ 0 and less
  /// than
  ///          the variance itself; zero, as here: points have nothing in common
  [[nodiscard]] virtual Eigen::Vector3d shared_variance() const;

  /// observe() of many points at once: a faster way, for Span::point, of rows whose
  /// noise is independent and that depend on the point alone. Best written as loops
  /// over all kLanes, which compilers turn into vector instructions.
  /// @returns false where the device has no such way, as here: observe() is asked then.
  [[nodiscard]] virtual bool observe_lanes(const PointLanes& points,
                                           RowLanes& out) const;

  /// What the device would measure of a point if its view had no edge. Where the point
  /// is in view, H and the noise are those of observe(); elsewhere anything that goes
  /// on smoothly, finite everywhere but at the origin.
  /// @param p in S, metres
  /// @returns false where the device has no such entry, as here: searches then take
  ///          differences of observe() and feel no pull at the edges of its view.
  [[nodiscard]] virtual bool observe_smoothly(const Eigen::Vector3d& p,
                                              SmoothRows& out) const;

  /// Where a ball of points is with respect to the field of view and reach: what spares
  /// looking at them one by one. Outside and inside must hold for every point of it.
  /// @param center in S, metres
  /// @param radius metres, ≥ 0
  [[nodiscard]] virtual View view_of_ball(const Eigen::Vector3d& center,
                                          double radius) const;

  /// How many openings the device looks through: lenses over photodiodes, cameras in
  /// one housing. Only devices that the target carries are asked, view by view.
  [[nodiscard]] virtual int views() const { return 1; }
  /// A cone in S outside of which a view sees nothing; sight lines end at its apex.
  /// @param view 0 to views() − 1, as below
  [[nodiscard]] virtual ViewCone view_cone(int view) const;
  /// What messages call a view.
  [[nodiscard]] virtual std::string view_name(int view) const;
  /// observe() through one view; observe() itself answers for the first that sees.
  [[nodiscard]] virtual bool observe_view(int view, const Target& target,
                                          Observation& out) const;
  /// The same for many beacons at once, as observe_lanes(). There are few as a rule, so
  /// that loops should run to their count.
  /// @returns false where the device has no such way, as here
  [[nodiscard]] virtual bool observe_view_lanes(int view, const BeaconLanes& beacons,
                                                RowLanes& out) const;

  /// Where in S the sight lines of one reading end, metres: a pair of cameras, or a
  /// projector with its camera, has two, and a point is seen where all of them are
  /// clear. Only devices that stand in the world are asked.
  [[nodiscard]] virtual std::vector<Eigen::Vector3d> lenses() const {
    return {Eigen::Vector3d::Zero()};
  }

  /// The length on a target at p, across the sight line, that one pixel covers, metres;
  /// the smaller, the more is told apart.
  /// @param p in S, metres, in view
  /// @returns 0 where the device has no pixels, as here
  [[nodiscard]] virtual double footprint(const Eigen::Vector3d& p) const;

  /// Whether what stands between the device's lenses and the point hides it. By
  /// default, devices that see points need to see them.
  [[nodiscard]] virtual bool needs_sight() const { return span() == Span::point; }
};

}  // namespace delos
