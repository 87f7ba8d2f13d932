#include "delos/scene/sample_time.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>

#include "delos/expression/expression.h"

namespace delos {
namespace {

const ExpressionNames kTau = {{"tau"}, "", {}};

/// Least squares over the terms of 1, 1/τ, 1/τ² that a set of bits has; the others are
/// 0. One of these subsets is the solution of the problem with signs, since there its
/// active terms solve theirs (Lawson & Hanson 1974, Solving Least Squares Problems,
/// §23).
Eigen::Vector3d fit_terms(std::span<const BenchReading> readings, unsigned set) {
  const auto rows = static_cast<Eigen::Index>(readings.size());
  // In units of the geometric mean of τ, in which all terms are near one.
  double mean = 0;
  for (const BenchReading& r : readings) mean += std::log(r.exposure);
  const double unit = std::exp(mean / static_cast<double>(rows));
  std::vector<int> terms;
  for (int t = 0; t < 3; ++t)
    if (set >> t & 1) terms.push_back(t);
  Eigen::MatrixXd A(rows, static_cast<Eigen::Index>(terms.size()));
  for (Eigen::Index i = 0; i < rows; ++i) {
    const BenchReading& r = readings[static_cast<std::size_t>(i)];
    for (std::size_t t = 0; t < terms.size(); ++t)
      A(i, static_cast<Eigen::Index>(t)) =
          std::pow(r.exposure / unit, -terms[t]) / r.variance;
  }
  const Eigen::VectorXd x = A.colPivHouseholderQr().solve(Eigen::VectorXd::Ones(rows));
  Eigen::Vector3d all = Eigen::Vector3d::Zero();
  for (std::size_t t = 0; t < terms.size(); ++t)
    all(terms[t]) = x(static_cast<Eigen::Index>(t)) * std::pow(unit, terms[t]);
  return all;
}

double value_of(const BenchFit& fit, double tau) {
  return fit.constant + (fit.inverse + fit.inverse_square / tau) / tau;
}

/// A law's variance, in the law's own unit.
double variance_at(const NoiseOverTime& noise, double tau) {
  switch (noise.law) {
    case NoiseLaw::constant:
      return 1;
    case NoiseLaw::inverse:
      return 1 / tau;
    case NoiseLaw::samples:
      return 1 / std::max(1.0, tau * noise.frequency);
    case NoiseLaw::photon: {
      const double part = noise.at / tau;
      return (1 - noise.read) * part + noise.read * part * part;
    }
    case NoiseLaw::photodiode: {
      const double gain = photodiode_gain(tau, noise.bandwidth, noise.gap);
      return gain * gain;
    }
    case NoiseLaw::table:
      return value_of(fit_bench(noise.table), tau);
    case NoiseLaw::expression: {
      const auto parsed = parse_expression(noise.expression, kTau);
      const auto* formula = std::get_if<Expression>(&parsed);
      const double value = formula ? evaluate(*formula, &tau) : -1;
      return value > 0 ? value : std::numeric_limits<double>::quiet_NaN();
    }
  }
  return 1;
}

}  // namespace

BenchFit fit_bench(std::span<const BenchReading> readings) {
  BenchFit best;
  best.error = std::numeric_limits<double>::infinity();
  for (unsigned set = 1; set < 8; ++set) {
    const Eigen::Vector3d x = fit_terms(readings, set);
    if (!(x.minCoeff() >= 0)) continue;
    BenchFit fit{x(0), x(1), x(2), 0};
    for (const BenchReading& r : readings) {
      const double off = value_of(fit, r.exposure) / r.variance - 1;
      fit.error += off * off;
    }
    fit.error = std::sqrt(fit.error / static_cast<double>(readings.size()));
    if (fit.error < best.error) best = fit;
  }
  return best;
}

double photodiode_gain(double window, double bandwidth, double gap) {
  const double a = std::numbers::pi * bandwidth, T = window;
  const double once = std::exp(-2 * a * T), apart = std::exp(-2 * a * gap);
  const double D1 = (std::expm1(-2 * a * T) + 2 * a * T) / (2 * a);
  const double D2 = (1 - (1 + 2 * a * T) * once) * apart / (4 * a);
  const double D3 = apart * once * (once + 2 * a * T - 1) / (4 * a);
  return std::sqrt(2 / (T * T) * (D1 - D2 - D3));
}

double noise_ratio(const NoiseOverTime& noise, double exposure) {
  if (noise.law == NoiseLaw::constant) return 1;
  return variance_at(noise, exposure) / variance_at(noise, noise.at);
}

std::string expression_problem(const NoiseOverTime& noise) {
  const auto parsed = parse_expression(noise.expression, kTau);
  if (const auto* problem = std::get_if<ExpressionProblem>(&parsed))
    return problem->sentence;
  if (!(variance_at(noise, noise.at) > 0))
    return "has no positive value at tau = `at`; R is a variance";
  return "";
}

}  // namespace delos
