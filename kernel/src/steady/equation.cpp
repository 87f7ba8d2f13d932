#include "delos/steady/equation.h"

#include <cmath>

#include "delos/model/lanes.h"
#include "delos/model/metric_table.h"
#include "observe/exact_rows.h"

namespace delos {

SteadyRequest request_for(const System& system, std::span<const Metric> metrics) {
  SteadyRequest request{system.covariance == CovarianceKind::prior,
                        system.covariance != CovarianceKind::prior, false, false};
  for (const Metric& metric : metrics) {
    const MetricNeed need = need_of(metric, system.motion.layout);
    request.whole_state |= need == MetricNeed::whole_state;
    request.time_constant |= need == MetricNeed::time_constant;
    if (need != MetricNeed::time_constant || !metric.expression) continue;
    // A formula may read all of P∞ besides the closed loop.
    request.whole_state = true;
  }
  return request;
}

void SteadyEquation::clear() {
  for (std::vector<double>& rows : readings) rows.clear();
  for (CycleStep& step : steps) {
    Measurement& m = step.measurement;
    m.information.setZero();
    m.exact.resize(0, m.information.cols());
    m.rows.resize(0, 0);
  }
}

void SteadyEquation::add(std::size_t step, const StateBlock& read, const double* S,
                         int stride) {
  StateMatrix& sum = steps[step].measurement.information;
  for (int i = 0; i < read.size; ++i)
    for (int j = 0; j <= i; ++j)
      sum(read.first + j, read.first + i) = sum(read.first + i, read.first + j) +=
          S[packed_index(i, j) * stride];
}

void SteadyEquation::add_reading(std::size_t step, const StateBlock& read,
                                 const Eigen::Ref<const Eigen::RowVectorXd>& row,
                                 double information) {
  readings.resize(steps.size());
  std::vector<double>& rows = readings[step];
  const auto n = static_cast<std::size_t>(steps[step].motion.A.rows());
  const std::size_t begin = rows.size();
  rows.resize(begin + n, 0);
  const double root = std::sqrt(information);
  for (int i = 0; i < read.size; ++i)
    rows[begin + static_cast<std::size_t>(read.first + i)] = root * row(i);
}

bool SteadyEquation::take_readings(const StateBlock& pose) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  bool any = false;
  for (std::size_t s = 0; s < readings.size(); ++s) {
    Measurement& m = steps[s].measurement;
    const Eigen::Index n = m.information.rows();
    const std::vector<double>& rows = readings[s];
    any |= !rows.empty();
    m.information.setZero();
    m.information.diagonal().segment(pose.first, pose.size).setConstant(besides);
    m.rows = Eigen::Map<const Rows>(rows.data(),
                                    static_cast<Eigen::Index>(rows.size()) / n, n);
  }
  return any;
}

void SteadyEquation::add_perfect(std::size_t step, const StateBlock& read,
                                 const StateVector& row) {
  StateMatrix& exact = steps[step].measurement.exact;
  StateVector whole = StateVector::Zero(exact.cols());
  whole.segment(read.first, read.size) = row.head(read.size);
  append_independent(whole, exact);
}

}  // namespace delos
