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

}  // namespace

MotionStep discretize(const MotionModel& motion, double dt) {
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

MotionStep continuous_form(const MotionModel& motion) {
  if (!motion.in_continuous_time()) std::abort();
  if (const auto* continuous = std::get_if<ContinuousMotion>(&motion.dynamics))
    return {continuous->A, continuous->Q};
  const CoordinateMatrix& q = std::get<ChainMotion>(motion.dynamics).q;
  const CoordinateMatrix I = CoordinateMatrix::Identity(q.rows(), q.cols());
  const int k = motion.layout.order;
  const auto drift = [](int i, int j) { return j == i + 1 ? 1.0 : 0.0; };
  const auto noise = [k](int i, int j) { return i == k - 1 && j == k - 1 ? 1.0 : 0.0; };
  return {blocks(k, I, drift), blocks(k, q, noise)};
}

}  // namespace delos
