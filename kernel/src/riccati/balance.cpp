// Choosing powers of two for the state's units.
#include "riccati/balance.h"

#include <algorithm>
#include <cmath>

#include "riccati/linear.h"

namespace delos::riccati {

StateVector balance(const StateVector& noise, const StateVector& information) {
  const Eigen::Index n = noise.size();
  double log_product = 0;
  int both = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!(noise[i] > 0 && information[i] > 0)) continue;
    log_product += (std::log2(noise[i]) + std::log2(information[i])) / 2;
    ++both;
  }
  const double typical = both > 0 ? log_product / both : 0;
  StateVector D(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool driven = noise[i] > 0, seen = information[i] > 0;
    double log_square = 0;
    if (driven && seen)
      log_square = (std::log2(noise[i]) - std::log2(information[i])) / 2;
    else if (driven)
      log_square = std::log2(noise[i]) - typical;
    else if (seen)
      log_square = typical - std::log2(information[i]);
    D[i] = std::exp2(std::round(std::clamp(log_square, -400.0, 400.0) / 2));
  }
  return D;
}

StateVector balance(std::span<const CycleStep> cycle) {
  constexpr int kSteps = 3;  // enough to reach from one end of a chain to the other
  const int count = static_cast<int>(cycle.size());
  const Eigen::Index n = cycle[0].motion.A.rows();
  StateMatrix noise = StateMatrix::Zero(n, n), information = noise;
  for (int step = 0; step < kSteps; ++step) {
    const MotionStep& motion = cycle[step % count].motion;
    noise = congruence(motion.A, noise) + motion.Q;
  }
  for (int step = kSteps - 1; step >= 0; --step) {
    const auto& [motion, measurement] = cycle[step % count];
    information += measurement.information;
    for (Eigen::Index i = 0; i < measurement.rows.rows(); ++i)
      information += measurement.rows.row(i).transpose() * measurement.rows.row(i);
    for (Eigen::Index row = 0; row < measurement.exact.rows(); ++row) {
      // An exact row counts as one that is as noisy as the process behind it.
      const auto c = measurement.exact.row(row);
      const double variance = c.dot(c * noise);
      if (variance > 0) information += c.transpose() * c / variance;
    }
    information = congruence(motion.A.transpose(), information);
  }
  return balance(noise.diagonal(), information.diagonal());
}

CycleStep scaled(const CycleStep& step, const StateVector& D) {
  const StateVector inverse = D.cwiseInverse();
  const auto& [motion, measurement] = step;
  return {{inverse.asDiagonal() * motion.A * D.asDiagonal(),
           inverse.asDiagonal() * motion.Q * inverse.asDiagonal()},
          {D.asDiagonal() * measurement.information * D.asDiagonal(),
           measurement.exact * D.asDiagonal(),
           in_terms_of(StateMatrix(D.asDiagonal()), measurement.rows)}};
}

}  // namespace delos::riccati
