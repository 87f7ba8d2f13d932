// The mean covariance of a cycle.
#include "delos/riccati/cycle.h"

#include <cstdlib>

#include "riccati/linear.h"
#include "riccati/update_map.h"

namespace delos {

StateMatrix time_average(const MotionModel& motion, std::span<const double> durations,
                         std::span<const SteadyState> states, AverageRule rule) {
  if (durations.empty() || durations.size() != states.size()) std::abort();
  // Gauss–Legendre on [0, 1]: nodes 1/2, 1/2 ± √15/10, weights 4/9, 5/18.
  constexpr double kNodes[] = {0.5 - 0.3872983346207417, 0.5, 0.5 + 0.3872983346207417};
  constexpr double kWeights[] = {5.0 / 18, 4.0 / 9, 5.0 / 18};

  const Eigen::Index n = states[0].prior.rows();
  StateMatrix sum = StateMatrix::Zero(n, n);
  double total = 0;
  for (std::size_t j = 0; j < states.size(); ++j) {
    const SteadyState& before = states[j == 0 ? states.size() - 1 : j - 1];
    const double dt = durations[j];
    total += dt;
    if (rule == AverageRule::trapezoid || !motion.is_chain()) {
      sum += dt / 2 * (before.posterior + states[j].prior);
      continue;
    }
    StateMatrix mean = StateMatrix::Zero(n, n);
    for (int node = 0; node < 3; ++node)
      mean += kWeights[node] *
              riccati::predict(discretize(motion, dt * kNodes[node]), before.posterior);
    sum += dt * riccati::projected_off(mean, states[j].unobservable);
  }
  return sum / total;
}

}  // namespace delos
