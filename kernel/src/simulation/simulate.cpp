#include "delos/simulation/simulate.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "model/lower_root.h"
#include "observe/shared_noise.h"
#include "simulation/expectation.h"
#include "simulation/given_states.h"
#include "simulation/run_sums.h"
#include "simulation/tally.h"
#include "simulation/track_run.h"

namespace delos {
namespace {

constexpr std::size_t kMostInstants = 5000;

/// The mean over `runs` of what is χ² with `degrees` over all of them.
Consistency consistency(double sum, double degrees, std::size_t runs) {
  const auto count = static_cast<double>(runs);
  Consistency of{sum / count, degrees / count, 0, 0};
  if (degrees == 0) return of;
  const auto quantile = [&](double p) {
    return 2 * boost::math::gamma_p_inv(degrees / 2, p) / count;
  };
  of.lower = quantile(0.025);
  of.upper = quantile(0.975);
  return of;
}

/// All that exposes begins anew: a start is of the motion's states alone.
StateMatrix start_root(const StateMatrix& posterior, double factor, int states) {
  StateMatrix root = StateMatrix::Zero(states, states);
  const Eigen::Index n = posterior.rows();
  root.topLeftCorner(n, n) = factor * lower_root(posterior);
  return root;
}

/// The posterior Cramér–Rao recursion: P ← A P Aᵀ + Q, P⁻¹ ← P⁻¹ + E[Hᵀ R⁻¹ H], the
/// expectation over all runs at their true states, of a state that doesn't turn.
/// @param take(instant, prior, P) what is made of it
template <class Take>
void each_bound(const MotionSteps& steps, const StateMatrix& root, const Tally& sums,
                Take&& take) {
  StateMatrix P = root * root.transpose();
  const auto runs = static_cast<double>(sums.tracked);
  for (std::size_t i = 0; i < sums.instants.size(); ++i) {
    const MotionStep& motion = steps.slot(i).motion;
    P = (motion.A * P * motion.A.transpose()).eval() + motion.Q;
    take(i, true, P);
    // (P⁻¹ + S)⁻¹ = P − P L (I + Lᵀ P L)⁻¹ Lᵀ P with S = L Lᵀ.
    StateMatrix S = sums.instants[i].information / runs;
    S = StateMatrix(S.selfadjointView<Eigen::Lower>());
    const StateMatrix L = lower_root(S);
    const StateMatrix PL = P * L;
    StateMatrix M = L.transpose() * PL;
    M.diagonal().array() += 1;
    P -= PL * M.llt().solve(PL.transpose());
    P = ((P + P.transpose()) / 2).eval();
    take(i, false, P);
  }
}

void check_simulated(const System& system, const SimulationOptions& options) {
  if (counts_bias(system) && system.error == ErrorPart::bias)
    throw std::invalid_argument(
        "errors of filters are scatter and bias together; use error: total or scatter");
  bool exposes = false;
  for (const PlacedDevice& placed : system.devices) exposes |= placed.exposure > 0;
  if (system.lag > 0)
    throw std::invalid_argument(
        "errors are of each instant, and P∞ of a lag isn't: leave lag out, or set it "
        "to 0");
  if (exposes && system.exposures != ExposureModel::exact)
    throw std::invalid_argument(
        "readings are simulated as they are, not as the papers' approximations have "
        "them; leave exposures out, or use exposures: exact");
  if (exposes && system.motion.layout.turns() == 3)
    throw std::invalid_argument(
        "readings that take time of a target that turns in space aren't simulated; "
        "leave exposure out, or use state: position");
  if (exposes && options.path)
    throw std::invalid_argument(
        "readings that take time aren't simulated along a given path; leave exposure "
        "out");
  for (const PlacedDevice& placed : system.devices)
    if (shares_noise(placed) && system.markers.size() > 1)
      throw std::invalid_argument(
          "noise that markers share isn't simulated, such as that of " + placed.name +
          "; leave its shared part out, or use one marker");
  if (options.path && system.motion.layout.positions() == 0)
    throw std::invalid_argument(
        "a path gives positions, which this motion has none of");
  if (options.runs < 2)
    throw std::invalid_argument("a simulation needs at least two runs");
}

/// How many instants, whole cycles.
std::size_t count_instants(const Expectation& expected, double cycle,
                           const SimulationOptions& options, bool& enough) {
  const std::size_t slots = expected.slots.size();
  double seconds = options.seconds;
  if (seconds <= 0)
    seconds = options.path ? options.path->t.back() - options.path->t.front()
                           : 5 * expected.time_constant;
  double cycles = std::ceil(seconds / cycle * (1 - 1e-12));
  if (options.path) cycles = std::floor(seconds / cycle * (1 + 1e-12));
  cycles = std::max(1.0, cycles);
  const double most =
      std::max(1.0, static_cast<double>(kMostInstants) / static_cast<double>(slots));
  enough = cycles <= most;
  const bool free = options.seconds <= 0 && !options.path;
  if (!enough && !free && cycles > 20 * most)
    throw std::invalid_argument("the simulation would take more than 100,000 instants");
  if (free) cycles = std::min(cycles, std::floor(most));
  return static_cast<std::size_t>(cycles) * slots;
}

/// P∞ of where a target is in the mean, at each instant: variances by state.
void predict_along(const System& system, const TargetPose& about, Simulation& done) {
  std::vector<TargetPose> poses;
  for (const SimulatedInstant& at : done.instants) poses.push_back({about.R, at.at});
  const std::vector<StateVector> variances = steady_variances(system, poses, done.kind);
  for (std::size_t i = 0; i < poses.size(); ++i)
    done.instants[i].predicted = variances[i];
}

/// After when the mean square of the pose block stays near P∞'s.
std::optional<double> settled_after(const Simulation& done, const Expectation& expected,
                                    int d) {
  std::optional<double> since;
  const double within =
      0.1 + 3 * std::sqrt(2 / static_cast<double>(done.runs - done.lost));
  for (const SimulatedInstant& at : done.instants) {
    const SteadyState& state = expected.states[at.slot];
    const double predicted =
        (done.kind == CovarianceKind::posterior ? state.posterior : state.prior)
            .topLeftCorner(d, d)
            .trace() +
        expected.bias.topLeftCorner(d, d).trace();
    const bool near = std::abs(at.square.head(d).sum() / predicted - 1) <= within;
    if (!near)
      since.reset();
    else if (!since)
      since = at.t;
  }
  return since;
}

}  // namespace

Simulation simulate(const System& system, const TargetPose& about,
                    const SimulationOptions& options) {
  check_simulated(system, options);
  const Expectation expected = expectation(system, about);
  const MotionSteps steps(system, expected.slots);
  const int n = system.motion.layout.size(), N = steps.states();
  bool enough = true;
  const std::size_t instants = count_instants(expected, steps.cycle(), options, enough);

  Simulation done;
  done.kind = system.covariance;
  done.time_constant = expected.time_constant;
  done.step = steps.cycle() / static_cast<double>(steps.slots());
  done.settles = enough && !options.path;
  const StateMatrix start =
      start_root(expected.states.back().posterior, done.settles ? 2 : 1, N);
  std::vector<StateVector> given;
  if (options.path) given = given_states(system, about, *options.path, steps, instants);

  const auto made = make_filter(options.filter);
  const TrackFilter& filter = options.own_filter ? *options.own_filter : *made;
  const TrackRuns runs(system, about, expected, steps, instants, start, filter,
                       options.seed, options.path ? &given : nullptr);
  Tally sums(expected, instants, n, N);
  add_runs(runs, Tally(expected, instants, n, N), options, sums);
  const auto wanted = static_cast<std::size_t>(options.runs);
  done.runs = sums.runs;
  done.cancelled = sums.runs < wanted;
  done.lost = sums.lost;
  done.coasting = sums.coasting;
  done.longest_gap = sums.longest_gap;
  done.dropped = sums.dropped;
  const std::size_t tracked = sums.tracked;
  if (tracked < 2) return done;

  const auto count = static_cast<double>(tracked);
  for (std::size_t l = 0; l < expected.looks.size(); ++l) {
    const LookTally& of = sums.looks[l];
    SimulatedCovariance covariance{expected.looks[l].name, expected.looks[l].predicted,
                                   of.sum / count,         {},
                                   of.filter / count,      {}};
    // The scatter of what each run has, over √runs.
    covariance.error =
        ((of.squares / count - covariance.measured.cwiseAbs2()).cwiseMax(0) /
         (count - 1))
            .cwiseSqrt();
    done.covariances.push_back(std::move(covariance));
  }
  double t = 0;
  for (std::size_t i = 0; i < instants; ++i) {
    const InstantTally& of = sums.instants[i];
    t += steps.slot(i).interval;
    SimulatedInstant at;
    at.t = t;
    at.slot = i % steps.slots();
    at.at = of.at / count;
    at.mean = of.error / count;
    at.square = of.square / count;
    at.filter = of.filter / count;
    at.nees = consistency(of.nees, count * n, tracked);
    at.nis = consistency(of.nis, static_cast<double>(of.nis_rows), tracked);
    at.seen = static_cast<double>(of.seen) / count;
    done.instants.push_back(std::move(at));
  }
  const bool at_posterior = done.kind == CovarianceKind::posterior;
  if (!sums.perfect && system.motion.layout.turns() < 3) {
    for (SimulatedCovariance& c : done.covariances) c.bound = StateMatrix::Zero(n, n);
    each_bound(steps, start, sums,
               [&](std::size_t i, bool prior, const StateMatrix& P) {
                 if (prior != at_posterior)
                   done.instants[i].bound = P.diagonal().head(n);
                 if (i < instants - steps.slots()) return;
                 for (std::size_t l = 0; l < expected.looks.size(); ++l) {
                   const CovarianceLook& look = expected.looks[l];
                   done.covariances[l].bound +=
                       (prior ? look.prior : look.posterior)[i % steps.slots()] *
                       P.topLeftCorner(n, n);
                 }
               });
  }
  if (options.path) predict_along(system, about, done);
  if (done.settles)
    done.settled_after = settled_after(done, expected, system.motion.layout.block());
  std::size_t in_nees = 0, in_nis = 0, settled = 0;
  for (std::size_t i = instants / 2; i < instants; ++i) {
    ++settled;
    in_nees += done.instants[i].nees.inside();
    in_nis += done.instants[i].nis.inside();
  }
  done.nees_inside = static_cast<double>(in_nees) / static_cast<double>(settled);
  done.nis_inside = static_cast<double>(in_nis) / static_cast<double>(settled);
  return done;
}

}  // namespace delos
