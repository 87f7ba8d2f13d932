#include "delos/observe/reading_model.h"

#include <Eigen/Geometry>
#include <cmath>

#include "observe/answers.h"
#include "observe/lever.h"
#include "observe/measure.h"

namespace delos {
namespace {

/// The turn in a block of pose coordinates, about the world's axes.
Eigen::Vector3d turn_in(const StateLayout& layout, const StateVector& x, int first) {
  const int at = first + layout.positions();
  switch (layout.turns()) {
    case 3:
      return x.segment<3>(at);
    case 1:
      return {0, 0, x(at)};
    default:
      return Eigen::Vector3d::Zero();
  }
}

/// [δp, δθ] of a block of coordinates; those that aren't estimated are 0.
Eigen::Matrix<double, 6, 1> six_of(const StateLayout& layout, const StateVector& x,
                                   int first) {
  Eigen::Matrix<double, 6, 1> six = Eigen::Matrix<double, 6, 1>::Zero();
  for (const int coordinate : estimated(layout.pose)) six(coordinate) = x(first++);
  return six;
}

/// How a sensor on the target moves, at l from its origin: all in W.
struct SensorMotion {
  Eigen::Vector3d l, omega, alpha;
  Eigen::Vector3d v, a;  ///< of the sensor
};

/// What turning adds to a row over [δp, δθ, δv, δω, δa, δα] in S that was worked out at
/// rest, g its parts in W. Of δv_s = … + ω×(δθ×l), δa_s = … + α×(δθ×l) + ω×(ω×(δθ×l))
/// + δω×(ω×l) + ω×(δω×l), and of axes that turn, −δθ×(what is measured):
///
///     δθ:  l×(g_v×ω) − v_s×g_v − ω×g_ω
///          + l×(g_a×α) + l×((g_a×ω)×ω) − a_s×g_a − α×g_α
///     δω:  (ω×l)×g_a + l×(g_a×ω)
template <class Row>
void add_turning(const StateLayout& layout, const Eigen::Matrix3d& R_WS,
                 const SensorMotion& m, const Row& in_S, StateRow& out) {
  const auto g = [&](int column) -> Eigen::Vector3d {
    return R_WS * in_S.template segment<3>(column).transpose();
  };
  const Eigen::Vector3d gv = g(6), gw = g(9), ga = g(12), gal = g(15);
  const Eigen::Vector3d of_turn = m.l.cross(gv.cross(m.omega)) - m.v.cross(gv) -
                                  m.omega.cross(gw) + m.l.cross(ga.cross(m.alpha)) +
                                  m.l.cross(ga.cross(m.omega).cross(m.omega)) -
                                  m.a.cross(ga) - m.alpha.cross(gal);
  const Eigen::Vector3d of_rate =
      m.omega.cross(m.l).cross(ga) + m.l.cross(ga.cross(m.omega));
  int at = 0;
  for (const int coordinate : estimated(layout.pose)) {
    if (coordinate >= 3) {
      out.h(at) += of_turn(coordinate - 3);
      if (layout.order >= 2)
        out.h(layout.coordinates() + at) += of_rate(coordinate - 3);
    }
    ++at;
  }
}

void check_reading(const PlacedDevice& placed, const Observation& answer) {
  if (answer.z.size() != answer.H.rows() || !answer.z.allFinite())
    blame(placed, "answers with a z that isn't finite or doesn't fit H");
}

}  // namespace

void move_state(const StateLayout& layout, const StateVector& change, StateVector& x,
                Eigen::Matrix3d& R) {
  x += change;
  if (layout.turns() == 0) return;
  const Eigen::Vector3d turn = turn_in(layout, change, 0);
  const double angle = turn.norm();
  if (angle > 0) R = (Eigen::AngleAxisd(angle, turn / angle) * R).eval();
}

TargetPose ReadingModel::pose_of(const StateBlock& block, const StateVector& x,
                                 const Eigen::Matrix3d& R) const {
  const StateLayout& layout = system_.motion.layout;
  TargetPose pose{R, about_.p};
  for (int i = 0; i < layout.positions(); ++i) pose.p(i) += x(block.first + i);
  // A mean's turn, of a state that turns about one axis alone.
  if (block.first > 0 && layout.turns() == 1)
    pose.R = Eigen::AngleAxisd(x(block.first + layout.positions()),
                               Eigen::Vector3d::UnitZ()) *
             about_.R;
  return pose;
}

bool ReadingModel::predict_motion(const PlacedDevice& placed, const TargetPose& X_WT,
                                  const StateVector& x, PredictedReading& out) const {
  const StateLayout& layout = system_.motion.layout;
  const Span span = placed.device->span();
  const int d = layout.coordinates();
  const TargetMount* carried = placed.carried();
  const Pose X_WS = carried ? X_WT * carried->X_TS : placed.X_WS();
  SensorMotion m;
  m.l = carried ? Eigen::Vector3d(X_WS.p - X_WT.p) : Eigen::Vector3d::Zero().eval();
  const auto block = [&](int k) -> Eigen::Matrix<double, 6, 1> {
    if (k >= layout.order) return Eigen::Matrix<double, 6, 1>::Zero();
    return six_of(layout, x, k * d);
  };
  const Eigen::Matrix<double, 6, 1> velocity = block(1), acceleration = block(2);
  m.omega = velocity.tail<3>();
  m.alpha = acceleration.tail<3>();
  m.v = velocity.head<3>() + m.omega.cross(m.l);
  m.a = acceleration.head<3>() + m.alpha.cross(m.l) + m.omega.cross(m.omega.cross(m.l));

  Target& target = out.target;
  target.p_ST = carried ? Eigen::Vector3d::Zero().eval()
                        : seen_at(X_WS, X_WT.p, Eigen::Vector3d::Zero());
  if (carried)
    target.R_ST.setIdentity();
  else
    target.R_ST.noalias() = X_WS.R.transpose() * X_WT.R;
  const auto in_S = [&](const Eigen::Vector3d& linear, const Eigen::Vector3d& angular) {
    Eigen::Matrix<double, 6, 1> both;
    both << X_WS.R.transpose() * linear, X_WS.R.transpose() * angular;
    return both;
  };
  target.velocity = in_S(m.v, m.omega);
  target.acceleration = in_S(m.a, m.alpha);
  const int n = layout.size() - static_cast<int>(system_.motion.own.size());
  if (span == Span::state)
    target.state = x.head(n);
  else
    target.state.resize(0);
  const int of_span = span == Span::pose ? 6 : span == Span::motion ? 18 : n;
  if (!observe_target(placed, of_span + placed.own.size, target, out.answer))
    return false;

  StateRow row;
  const int orders = span == Span::motion ? layout.order : 1;
  for (Eigen::Index r = 0; r < out.answer.H.rows(); ++r) {
    const auto of_answer = out.answer.H.row(r);
    row.h.setZero(states_);
    if (span == Span::state)
      row.h.head(n) = of_answer.head(n);
    else
      fill_row(layout, X_WS.R, m.l, orders, of_answer, row);
    if (span == Span::motion && carried) add_turning(layout, X_WS.R, m, of_answer, row);
    set_own(placed, of_answer, row);
    out.H.row(r) = row.h;
  }
  return true;
}

bool ReadingModel::predict(const TrackReading& reading, const StateVector& x,
                           const Eigen::Matrix3d& R, PredictedReading& out) const {
  const PlacedDevice& placed =
      system_.devices[static_cast<std::size_t>(reading.device)];
  const StateLayout& layout = system_.motion.layout;
  const TargetPose X_WT = pose_of(reading.block, x, R);
  Target& target = out.target;
  target.own = x.segment(placed.own.first, placed.own.size);
  const auto finish = [&] {
    check_reading(placed, out.answer);
    out.z = out.answer.z;
    out.R = out.answer.R;
    const double sigma = placed.without_sight.sigma;
    if (reading.without_sight) out.R.diagonal().array() += sigma * sigma;
    out.R *= placed.noise;
    if (placed.clock) {
      out.z.array() += x(*placed.clock);
      out.H.col(*placed.clock).setOnes();
    }
    return true;
  };
  const auto size_H = [&] { out.H.setZero(out.answer.H.rows(), states_); };
  if (placed.device->span() != Span::point) {
    // Rows are as many as the answer has, known only then.
    out.H.setZero(kMaxRows, states_);
    if (!predict_motion(placed, X_WT, x, out)) return false;
    out.H.conservativeResize(out.answer.H.rows(), Eigen::NoChange);
    return finish();
  }
  target.R_ST.setIdentity();
  target.velocity.setZero();
  target.acceleration.setZero();
  target.state.resize(0);
  const auto pull = [&](const Eigen::Matrix3d& R_WS, const Eigen::Vector3d& arm) {
    size_H();
    for (Eigen::Index r = 0; r < out.answer.H.rows(); ++r) {
      const Eigen::Vector3d h = out.answer.H.row(r).head<3>().transpose();
      pull_row<1>(layout, R_WS, h.data(), arm.data(), &out.H(r, reading.block.first));
      if (placed.own.size > 0)
        out.H.row(r).segment(placed.own.first, placed.own.size) =
            out.answer.H.row(r).tail(placed.own.size);
    }
  };
  const TargetMount* carried = placed.carried();
  if (!carried) {
    const Eigen::Vector3d arm = X_WT.R * system_.markers[reading.of].p;
    target.p_ST = seen_at(placed.X_WS(), X_WT.p, arm);
    target.n_ST.setZero();
    if (!observe_target(placed, 3 + placed.own.size, target, out.answer)) return false;
    pull(placed.X_WS().R, arm);
    return finish();
  }
  const Pose X_WS = X_WT * carried->X_TS;
  const Beacon& beacon = (*carried->beacons)[reading.of];
  target.p_ST = X_WS.R.transpose() * (beacon.p - X_WS.p);
  target.n_ST = X_WS.R.transpose() * beacon.normal;
  const bool sees = ask(placed, [&](const Device& device) {
    return device.observe_view(reading.view, target, out.answer);
  });
  if (!sees) return false;
  check_answer(placed, out.answer, 3);
  pull(-X_WS.R, beacon.p - X_WT.p);
  return finish();
}

decltype(Observation::z) ReadingModel::difference(
    int device, const decltype(Observation::z)& a,
    const decltype(Observation::z)& b) const {
  const Device& of = *system_.devices[static_cast<std::size_t>(device)].device;
  decltype(Observation::z) left = a - b;
  for (Eigen::Index r = 0; r < left.size(); ++r)
    if (const double period = of.period(static_cast<int>(r)); period > 0)
      left(r) = std::remainder(left(r), period);
  return left;
}

}  // namespace delos
