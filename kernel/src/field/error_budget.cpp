#include "field/error_budget.h"

#include <algorithm>
#include <cmath>

#include "delos/field/evaluate.h"
#include "delos/model/infinity.h"
#include "delos/steady/state_metric.h"
#include "field/pose_facts.h"
#include "riccati/linear.h"
#include "steady/bias.h"

namespace delos {
namespace {

/// Values of states at one pose.
class Values {
 public:
  Values(const System& system, const SolvedPose& at)
      : system_(system), facts_(facts_of(system, at.block, 0, at.pose, true)) {
    // Linearising knows nothing of what is constantly off.
    LinearisationCheck check(system);
    add_linearisation(at.scatter, at.pose, check, facts_);
  }

  [[nodiscard]] double operator()(const Metric& metric, const FusedState& state) const {
    if (!metric_problem(system_, metric).empty()) return kInfinity;
    const double value =
        state_metric(metric, system_.motion.layout, state, system_.covariance, facts_);
    return std::isfinite(value) ? value : kInfinity;
  }

 private:
  const System& system_;
  PoseFacts facts_;
};

bool of_one_type(const System& system, const LayerBlock& block) {
  const PlacedDevice* first = nullptr;
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    if (!(block.seen[i] & 1)) continue;
    if (first && first->type != system.devices[i].type) return false;
    first = &system.devices[i];
  }
  return first != nullptr;
}

/// A covariance of the pose alone as a state that metrics read.
FusedState pose_state(const StateMatrix& P, const StateMatrix& lost) {
  FusedState state;
  state.prior = state.posterior = P;
  state.unobservable = lost;
  if (lost.cols() > 0) state.status = RiccatiStatus::unobservable;
  return state;
}

/// Readings z = H x + v of one instant, all weighed alike:
///
///     x̂ = S₀⁻¹ Hᵀ z,   S₀ = Hᵀ H,   cov v = S₀⁻¹ Hᵀ R H S₀⁻¹,   bias S₀⁻¹ D₀ S₀⁻¹
///
/// which is what most software does.
std::optional<ErrorBudget::Plain> plain_least_squares(const System& system,
                                                      const SolvedPose& at,
                                                      const Metric& metric,
                                                      const Values& value) {
  const int d = system.motion.layout.coordinates();
  if (!of_one_type(system, at.block) || information_size(system) != d ||
      need_of(metric, system.motion.layout) != MetricNeed::pose_block)
    return std::nullopt;
  const WhitenedRows rows = whitened_rows(system, at.pose);
  StateMatrix S0 = StateMatrix::Zero(d, d), noise = S0;
  for (Eigen::Index r = 0; r < rows.rows.rows(); ++r) {
    const auto i = static_cast<std::size_t>(r);
    const StateMatrix hh = rows.rows.row(r).transpose() * rows.rows.row(r);
    S0 += rows.variance[i] * hh;
    noise += rows.variance[i] * rows.variance[i] * hh;
  }
  const auto inverse = riccati::pseudo_inverse(S0, S0.diagonal());
  CalibrationScratch scratch;
  const StateMatrix scatter = riccati::congruence(inverse.inverse, noise);
  const StateMatrix bias = riccati::congruence(
      inverse.inverse, calibration_spread(system, at.pose, scratch, RowWeights::plain));
  const auto of = [&](const StateMatrix& P) {
    return value(metric, pose_state(P, inverse.null));
  };
  return ErrorBudget::Plain{of(scatter), of(bias), of(scatter + bias)};
}

}  // namespace

void add_budget(const System& system, const SolvedPose& at, const Metric& metric,
                PointReport& report) {
  const Values value(system, at);
  BiasSolver bias(system);
  CalibrationScratch scratch;
  const StateMatrix D = calibration_spread(system, at.pose, scratch);
  const auto state_of = [&](ErrorPart part, const StateMatrix& spread) {
    FusedState state = at.scatter;
    bias.apply(part, at.S, spread, state);
    return state;
  };
  const auto values_of = [&](ErrorPart part) {
    const FusedState state = state_of(part, D);
    std::vector<double> values;
    for (const MetricValue& m : report.metrics)
      values.push_back(value(m.metric, state));
    return values;
  };
  report.budget = {values_of(ErrorPart::scatter),
                   values_of(ErrorPart::bias),
                   values_of(ErrorPart::total),
                   {},
                   plain_least_squares(system, at, metric, value)};

  if (!counts_bias(system)) return;
  report.state = state_of(system.error, D);
  for (MetricValue& m : report.metrics) m.value = value(m.metric, report.state);
  const double all = value(metric, report.state);
  if (!std::isfinite(all)) return;
  const auto worth = [&] {
    const double without = value(metric, state_of(system.error, D - scratch.of_source));
    return metric.larger_is_better ? 1 - all / without : 1 - without / all;
  };
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    if (system.devices[i].calibration.exact()) continue;
    find_calibration(system, system.devices[i], at.pose, scratch);
    report.devices[i].calibration = worth();
  }
  for (std::size_t i = 0; i < system.common_errors.size(); ++i) {
    find_common_error(system, i, at.pose, scratch);
    report.budget->common.push_back({system.common_errors[i].name, worth()});
  }
}

}  // namespace delos
