// The integrator chain over a time dt.
#include "delos/model/motion.h"

#include <cmath>
#include <cstdlib>

#include "model/van_loan.h"

namespace delos {
namespace {

double factorial(int n) { return n <= 1 ? 1.0 : n * factorial(n - 1); }

/// A matrix of k×k blocks c(i,j)·B: the Kronecker product of a chain with its
/// coordinates.
template <class Coefficient>
StateMatrix blocks(int order, const CoordinateMatrix& B, Coefficient coefficient) {
  const Eigen::Index d = B.rows();
  StateMatrix m = StateMatrix::Zero(order * d, order * d);
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < order; ++j) m.block(i * d, j * d, d, d) = coefficient(i, j) * B;
  return m;
}

/// A step with the devices' own states behind those of the target.
/// @param transition(state), noise(state) its element of A and of Q
template <class Transition, class Noise>
MotionStep with_own(const MotionModel& motion, const MotionStep& target,
                    Transition transition, Noise noise) {
  if (motion.own.empty()) return target;
  const Eigen::Index n = target.A.rows(),
                     all = n + static_cast<Eigen::Index>(motion.own.size());
  MotionStep step{StateMatrix::Zero(all, all), StateMatrix::Zero(all, all)};
  step.A.topLeftCorner(n, n) = target.A;
  step.Q.topLeftCorner(n, n) = target.Q;
  for (Eigen::Index i = n; i < all; ++i) {
    const GaussMarkov& state = motion.own[static_cast<std::size_t>(i - n)];
    step.A(i, i) = transition(state);
    step.Q(i, i) = noise(state);
  }
  return step;
}

/// The target's part of a step.
MotionStep discretize_target(const MotionModel& motion, double dt) {
  if (const auto* custom = std::get_if<CustomMotion>(&motion.dynamics))
    return {custom->A, custom->Q};
  if (const auto* continuous = std::get_if<ContinuousMotion>(&motion.dynamics))
    return van_loan(continuous->A, continuous->Q, dt);

  const CoordinateMatrix& q = std::get<ChainMotion>(motion.dynamics).q;
  const CoordinateMatrix I = CoordinateMatrix::Identity(q.rows(), q.cols());
  const int k = motion.layout.order;
  // A_ij = dt^(j−i)/(j−i)!
  const auto transition = [&](int i, int j) {
    return j < i ? 0.0 : std::pow(dt, j - i) / factorial(j - i);
  };
  // Q_ij = q dt^(2k−1−i−j) / ((2k−1−i−j) (k−1−i)! (k−1−j)!)
  const auto noise = [&](int i, int j) {
    const int p = 2 * k - 1 - i - j;
    return std::pow(dt, p) / (p * factorial(k - 1 - i) * factorial(k - 1 - j));
  };
  return {blocks(k, I, transition), blocks(k, q, noise)};
}

}  // namespace

MotionStep discretize(const MotionModel& motion, double dt) {
  const auto transition = [dt](const GaussMarkov& state) {
    return std::exp(-dt / state.time_constant);
  };
  const auto noise = [dt](const GaussMarkov& state) {
    const double T = state.time_constant;
    return state.density * (std::isinf(T) ? dt : -std::expm1(-2 * dt / T) * T / 2);
  };
  return with_own(motion, discretize_target(motion, dt), transition, noise);
}

MotionStep continuous_form(const MotionModel& motion) {
  if (!motion.in_continuous_time()) std::abort();
  const auto drift = [](const GaussMarkov& state) { return -1 / state.time_constant; };
  const auto density = [](const GaussMarkov& state) { return state.density; };
  if (const auto* continuous = std::get_if<ContinuousMotion>(&motion.dynamics))
    return with_own(motion, {continuous->A, continuous->Q}, drift, density);
  const CoordinateMatrix& q = std::get<ChainMotion>(motion.dynamics).q;
  const CoordinateMatrix I = CoordinateMatrix::Identity(q.rows(), q.cols());
  const int k = motion.layout.order;
  const auto next = [](int i, int j) { return j == i + 1 ? 1.0 : 0.0; };
  const auto last = [k](int i, int j) { return i == k - 1 && j == k - 1 ? 1.0 : 0.0; };
  return with_own(motion, {blocks(k, I, next), blocks(k, q, last)}, drift, density);
}

}  // namespace delos
