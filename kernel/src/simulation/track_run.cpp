#include "simulation/track_run.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace delos {
namespace {

/// eᵀ P⁻¹ e; NaN where P is singular.
double normalized_square(const StateVector& e, const StateMatrix& P) {
  const Eigen::Index n = e.size();
  const Eigen::LLT<StateMatrix> root(P.topLeftCorner(n, n));
  if (root.info() != Eigen::Success) return std::numeric_limits<double>::quiet_NaN();
  const StateVector y = root.matrixL().solve(e);
  return y.squaredNorm();
}

}  // namespace

TrackRuns::TrackRuns(const System& system, const TargetPose& about,
                     const Expectation& expected, const MotionSteps& steps,
                     std::size_t instants, const StateMatrix& start,
                     const TrackFilter& filter, std::uint64_t seed,
                     const std::vector<StateVector>* given)
    : system_(system),
      about_(about),
      model_(system, about, steps.states()),
      expected_(expected),
      steps_(steps),
      targets_(system, about, steps, instants),
      instants_(instants),
      start_(start),
      filter_(filter),
      seed_(seed),
      given_(given),
      draws_errors_(counts_bias(system)),
      n_(system.motion.layout.size()) {}

StateVector TrackRuns::error_of(const StateVector& x, const Eigen::Matrix3d& R,
                                const TrackEstimate& estimate) const {
  const StateLayout& layout = system_.motion.layout;
  StateVector e = (x - estimate.x).head(n_);
  if (layout.turns() == 0) return e;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(R * estimate.R.transpose()));
  const Eigen::Vector3d theta = turn.angle() * turn.axis();
  if (layout.turns() == 3)
    e.segment<3>(layout.positions()) = theta;
  else
    e(layout.positions()) = theta.z();
  return e;
}

void TrackRuns::tally_instant(const StateVector& error, const TrackEstimate& estimate,
                              InstantTally& out) const {
  out.error += error;
  out.square += error.cwiseAbs2();
  out.filter += estimate.P.diagonal().head(n_);
  out.nees += normalized_square(error, estimate.P);
}

void TrackRuns::look(std::size_t slot, bool prior, const StateVector& error,
                     const TrackEstimate& estimate, Memory& memory,
                     Tally& tally) const {
  for (std::size_t l = 0; l < expected_.looks.size(); ++l) {
    const CovarianceLook& at = expected_.looks[l];
    const double weight = (prior ? at.prior : at.posterior)[slot];
    if (weight == 0) continue;
    memory.looked[l].noalias() += weight * error * error.transpose();
    tally.looks[l].filter += weight * estimate.P.topLeftCorner(n_, n_);
  }
}

void TrackRuns::run(std::uint64_t number, Memory& memory, Tally& sums) const {
  Tally& tally = memory.own;
  tally.clear();
  RunRandom motion(seed_, number, Draw::motion), begin(seed_, number, Draw::start);
  RunRandom noise(seed_, number, Draw::readings), beacons(seed_, number, Draw::beacons);
  targets_.draw(motion, given_, memory.path);
  if (draws_errors_) {
    if (!memory.errors) memory.errors.emplace(system_, about_, steps_.states());
    RunRandom errors(seed_, number, Draw::errors);
    memory.errors->draw(errors);
  }
  TrackEstimate& estimate = memory.estimate;
  const int N = steps_.states();
  StateVector drawn(N);
  for (double& d : drawn) d = begin.normal();
  estimate.x = memory.path.x[0];
  estimate.R = memory.path.R[0];
  move_state(system_.motion.layout, StateVector(-(start_ * drawn)), estimate.x,
             estimate.R);
  estimate.P.noalias() = start_ * start_.transpose();
  memory.looked.assign(expected_.looks.size(), StateMatrix::Zero(n_, n_));

  const bool posterior = system_.covariance == CovarianceKind::posterior;
  const std::size_t last_cycle = instants_ - steps_.slots();
  double gap = 0, longest = 0;
  StateVector error;
  for (std::size_t i = 0; i < instants_; ++i) {
    const SimulatedSlot& slot = steps_.slot(i);
    const std::size_t s = i % steps_.slots();
    const StateVector& x = memory.path.x[i + 1];
    const Eigen::Matrix3d& R = memory.path.R[i + 1];
    InstantTally& out = tally.instants[i];
    steps_.predict(i, estimate);
    error = error_of(x, R, estimate);
    if (!posterior) tally_instant(error, estimate, out);
    if (i >= last_cycle) look(s, true, error, estimate, memory, tally);

    memory.readings.clear();
    for (std::size_t d = 0; d < slot.devices.size(); ++d)
      draw_readings(model_, slot.devices[d], slot.blocks[d], x, R, noise, beacons,
                    memory.scratch, memory.readings, out.information, tally.perfect,
                    memory.errors ? &*memory.errors : nullptr);
    out.at += model_.pose_of({0, n_}, x, R).p;
    gap = memory.readings.empty() ? gap + slot.interval : 0;
    longest = std::max(longest, gap);
    out.seen += !memory.readings.empty();
    const Innovation innovation = filter_.update(model_, memory.readings, estimate);
    out.nis += innovation.nis;
    out.nis_rows += static_cast<std::size_t>(innovation.rows);
    tally.dropped += static_cast<std::size_t>(innovation.dropped);
    error = error_of(x, R, estimate);
    if (posterior) tally_instant(error, estimate, out);
    if (i >= last_cycle) look(s, false, error, estimate, memory, tally);
  }
  for (std::size_t l = 0; l < memory.looked.size(); ++l) {
    tally.looks[l].sum += memory.looked[l];
    tally.looks[l].squares += memory.looked[l].cwiseAbs2();
  }
  const StateMatrix P = expected_.states.back().posterior + expected_.bias;
  bool lost = false;
  for (int k = 0; k < n_; ++k) lost |= !(error(k) * error(k) <= 100 * P(k, k) + 1e-300);
  // Along a given path, what is lost there is what one wants to see.
  const bool counts = !lost || given_;
  if (counts) sums.add(tally);
  sums.tracked += counts;
  sums.lost += lost;
  sums.coasting += longest > steps_.cycle() * (1 + 1e-9);
  sums.longest_gap = std::max(sums.longest_gap, longest);
  ++sums.runs;
}

}  // namespace delos
