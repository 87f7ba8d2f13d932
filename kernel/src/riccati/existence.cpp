#include "delos/riccati/existence.h"

#include <cmath>
#include <complex>

#include "riccati/linear.h"
#include "riccati/observability.h"

namespace delos {

// Stabilizable is dual to detectable: w is lost by no noise's doing where it is lost to
// a sensor that reads Q of x⁺ = Aᵀ x.
UndrivenModes undriven_modes(const MotionStep& motion) {
  const Eigen::Index n = motion.A.rows();
  // In units in which the noise of every driven state is 1.
  StateVector D(n);
  for (Eigen::Index i = 0; i < n; ++i)
    D[i] = motion.Q(i, i) > 0 ? std::sqrt(motion.Q(i, i)) : 1;
  const StateMatrix A = D.cwiseInverse().asDiagonal() * motion.A * D.asDiagonal();
  const StateMatrix Q =
      D.cwiseInverse().asDiagonal() * motion.Q * D.cwiseInverse().asDiagonal();
  const CycleStep dual{{A.transpose(), StateMatrix::Zero(n, n)},
                       {Q, StateMatrix(0, n)}};
  const StateMatrix W =
      riccati::lost_directions({&dual, 1}, riccati::Stability::discrete);

  UndrivenModes modes;
  modes.directions = D.cwiseInverse().asDiagonal() * W;
  modes.directions.colwise().normalize();
  if (W.cols() == 0) return modes;
  constexpr double kOnTheCircle = 1e-10;  // as near as eigenvalues are computed
  const StateMatrix within = W.transpose() * A.transpose() * W;
  for (const std::complex<double> mu : riccati::eigenvalues(within))
    modes.on_circle = modes.on_circle || std::abs(std::abs(mu) - 1) < kOnTheCircle;
  return modes;
}

}  // namespace delos
