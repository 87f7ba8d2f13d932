#include "motion/chain_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace delos::motion {
namespace {

constexpr int kLags = 20;
/// Innovations that no likelihood counts: the first of each order find the state, and
/// all orders are compared over the same.
constexpr int kBegin = kOrders;
/// η = r/q in units of dt, within which it is looked for.
constexpr double kLeastLog = -20, kGreatestLog = 40;

constexpr double factorial(int n) { return n <= 1 ? 1 : n * factorial(n - 1); }

/// What a filter with q = 1, dt = 1 and r = η leaves of a record.
struct Innovations {
  double count = 0;
  double log_S = 0;    // Σ log S
  double squares = 0;  // Σ ν²/S

  /// −2 log L with the scale q = squares/count.
  [[nodiscard]] double objective() const {
    return log_S + count * std::log(squares / count);
  }
};

template <int k>
class Filter {
 public:
  using Square = Eigen::Matrix<double, k, k>;
  using Column = Eigen::Matrix<double, k, 1>;

  Filter() {
    A_.setZero();
    for (int i = 0; i < k; ++i) {
      for (int j = 0; j < k; ++j) {
        if (j >= i) A_(i, j) = 1 / factorial(j - i);
        Q_(i, j) =
            1 / ((2 * k - 1 - i - j) * factorial(k - 1 - i) * factorial(k - 1 - j));
      }
    }
  }

  /// @param visit(ν/√S) of each innovation that counts
  template <class Visit>
  Innovations run(std::span<const double> z, double eta, Visit&& visit) const {
    Innovations out;
    const double large = 1e8 * std::max(1.0, eta);
    Column x = Column::Zero(), K = Column::Zero();
    Square P = large * Square::Identity();
    double S = 0, log_S = 0;
    bool steady = false, begun = false;
    int seen = 0;
    for (const double value : z) {
      if (std::isnan(value)) {
        if (begun) {
          x = A_ * x;
          P = predicted(P);
          steady = false;
        }
        continue;
      }
      if (!begun) x(0) = value;
      begun = true;
      if (!steady) {
        S = P(0, 0) + eta;
        log_S = std::log(S);
        K = P.col(0) / S;
      }
      const double nu = value - x(0);
      if (++seen > kBegin) {
        const double square = nu * nu / S;
        ++out.count;
        out.log_S += log_S;
        out.squares += square;
        visit(nu / std::sqrt(S));
      }
      x = A_ * (x + K * nu);
      if (!steady) {
        const Square before = P;
        const Square keep = Square::Identity() - K * Column::Unit(0).transpose();
        P = predicted(keep * P * keep.transpose() + eta * K * K.transpose());
        steady = (P - before).cwiseAbs().maxCoeff() <= 1e-13 * P.cwiseAbs().maxCoeff();
      }
    }
    return out;
  }

 private:
  [[nodiscard]] Square predicted(const Square& P) const {
    const Square next = A_ * P * A_.transpose() + Q_;
    return (next + next.transpose()) / 2;
  }

  Square A_, Q_;
};

/// Q and ρ_1 of innovations one after another.
void set_whiteness(const std::vector<double>& e, ChainFit& fit) {
  const double n = static_cast<double>(e.size());
  double mean = 0, variance = 0;
  for (const double v : e) mean += v / n;
  for (const double v : e) variance += (v - mean) * (v - mean);
  fit.lags = std::min(kLags, static_cast<int>(e.size()) / 4);
  fit.ljung_box = 0;
  for (int lag = 1; lag <= fit.lags; ++lag) {
    double sum = 0;
    for (std::size_t i = static_cast<std::size_t>(lag); i < e.size(); ++i)
      sum += (e[i] - mean) * (e[i - static_cast<std::size_t>(lag)] - mean);
    const double rho = variance > 0 ? sum / variance : 0;
    if (lag == 1) fit.first_correlation = rho;
    fit.ljung_box += n * (n + 2) * rho * rho / (n - lag);
  }
  constexpr int kFitted = 2;  // q and r
  fit.p_value = chi_squared_tail(fit.ljung_box, fit.lags - kFitted);
}

Estimate interval(double value, double variance_of_log) {
  const double factor = std::exp(1.96 * std::sqrt(variance_of_log));
  return {value, value / factor, value * factor};
}

/// How much −2 log L rises over an interval of 95 %: χ² of one degree.
constexpr double kWithin = 3.84;

/// Which of the two numbers isn't distinguished from 0: without it −2 log L is hardly
/// larger.
template <int k>
Edge edge_of(const Filter<k>& filter, std::span<const double> z, double least) {
  const auto rise = [&](double log) {
    return filter.run(z, std::exp(log), [](double) {}).objective() - least;
  };
  if (rise(kGreatestLog) < kWithin) return Edge::no_motion;
  if (rise(kLeastLog) < kWithin) return Edge::no_noise;
  return Edge::none;
}

/// How far η may be from its best, away from the edge: log η.
template <int k>
double bound_of(const Filter<k>& filter, std::span<const double> z, double log_eta,
                Edge edge) {
  const auto objective = [&](double log) {
    return filter.run(z, std::exp(log), [](double) {}).objective();
  };
  const double most = objective(log_eta) + kWithin;
  double inside = log_eta, outside = edge == Edge::no_motion ? kLeastLog : kGreatestLog;
  for (int halvings = 0; halvings < 30; ++halvings) {
    const double middle = (inside + outside) / 2;
    (objective(middle) < most ? inside : outside) = middle;
  }
  return inside;
}

/// q and r of η and the scale, with intervals from the observed information of
/// (log η, log q), in which
///
///     −2 log L = n log q + Σ log S(η) + squares(η)/q
template <int k>
void set_estimates(const Filter<k>& filter, std::span<const double> z, double dt,
                   double log_eta, ChainFit& fit) {
  const auto at = [&](double log) {
    return filter.run(z, std::exp(log), [](double) {});
  };
  const Innovations here = at(log_eta);
  const double q = here.squares / here.count, unit = std::pow(dt, 2 * k - 1);
  // Of a variance from so many innovations, the other number being known.
  const double of_q = here.count / 2;
  if (fit.edge != Edge::none) {
    const double log_bound = bound_of(filter, z, log_eta, fit.edge);
    const Innovations bound = at(log_bound);
    const double bound_q = bound.squares / bound.count;
    fit.q = interval(q / unit, 1 / of_q);
    fit.r = interval(std::exp(log_eta) * q, 1 / of_q);
    if (fit.edge == Edge::no_motion)
      fit.q = {q / unit, 0, bound_q / unit};
    else
      fit.r = {std::exp(log_eta) * q, 0, std::exp(log_bound) * bound_q};
    return;
  }
  // By differences over about a standard deviation of what they find.
  constexpr double kStep = 0.05;
  const Innovations less = at(log_eta - kStep), more = at(log_eta + kStep);
  const auto half = [&](const Innovations& i) { return (i.log_S + i.squares / q) / 2; };
  const double of_eta = (half(more) - 2 * half(here) + half(less)) / (kStep * kStep);
  const double crossed = -(more.squares - less.squares) / (2 * kStep) / (2 * q);
  const double determinant = of_eta * of_q - crossed * crossed;
  const double var_eta = of_q / determinant, var_q = of_eta / determinant,
               both = -crossed / determinant;
  fit.q = interval(q / unit, var_q);
  fit.r = interval(std::exp(log_eta) * q, var_eta + var_q + 2 * both);
}

template <int k>
ChainFit fit_order(std::span<const double> z, double dt) {
  const Filter<k> filter;
  const auto objective = [&](std::span<const double> part, double log_eta) {
    return filter.run(part, std::exp(log_eta), [](double) {}).objective();
  };
  // A part of a long record says about where.
  constexpr std::size_t kPart = 20'000;
  const std::span<const double> part = z.first(std::min(z.size(), kPart));
  constexpr double kStep = 2.5;
  double about = kLeastLog, least = objective(part, about);
  for (double log = kLeastLog + kStep; log <= kGreatestLog; log += kStep) {
    const double value = objective(part, log);
    if (!(value < least)) continue;
    least = value;
    about = log;
  }
  const double low = std::max(about - kStep, kLeastLog),
               high = std::min(about + kStep, kGreatestLog);
  constexpr int kBits = 20;
  const auto [log_eta, value] = boost::math::tools::brent_find_minima(
      [&](double log) { return objective(z, log); }, low, high, kBits);
  ChainFit fit;
  fit.order = k;
  fit.edge = edge_of(filter, z, value);
  set_estimates(filter, z, dt, log_eta, fit);
  std::vector<double> innovations;
  innovations.reserve(z.size());
  const Innovations all =
      filter.run(z, std::exp(log_eta), [&](double e) { innovations.push_back(e); });
  fit.minus_2_log_likelihood =
      all.objective() + all.count * (1 + std::log(2 * std::numbers::pi));
  set_whiteness(innovations, fit);
  return fit;
}

}  // namespace

double chi_squared_tail(double value, double degrees) {
  return boost::math::gamma_q(degrees / 2, value / 2);
}

std::array<ChainFit, kOrders> fit_chains(std::span<const double> z, double dt) {
  return {fit_order<1>(z, dt), fit_order<2>(z, dt), fit_order<3>(z, dt)};
}

}  // namespace delos::motion
