#include "readings/power.h"

#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>

namespace delos::readings {
namespace {

using boost::math::complement;

double means_of(const PowerTest& test) { return test.two_means ? 2 : 1; }
double tail_of(const PowerTest& test) {
  return test.two_sided ? test.alpha / 2 : test.alpha;
}

/// From so many degrees of freedom on, t is normal to ten digits of its power.
constexpr double kNormalFrom = 1e7;

}  // namespace

std::string power_problem(const PowerTest& test, double power) {
  if (!(test.sigma > 0) || !std::isfinite(test.sigma)) return "sigma must be above 0";
  if (!(test.alpha > 0 && test.alpha < 1)) return "alpha must be between 0 and 1";
  if (!(power > test.alpha && power < 1))
    return "the power must be above alpha and below 1";
  return "";
}

CriticalValues critical_values(const PowerTest& test, double power) {
  const boost::math::normal normal;
  return {quantile(complement(normal, tail_of(test))),
          quantile(complement(normal, 1 - power))};
}

double power_of(const PowerTest& test, double effect, double count) {
  const double delta = effect / (test.sigma * std::sqrt(means_of(test) / count));
  const double freedom = means_of(test) * (count - 1);
  if (test.known || freedom > kNormalFrom) {
    const boost::math::normal normal;
    const double z = quantile(complement(normal, tail_of(test)));
    return cdf(normal, delta - z) + (test.two_sided ? cdf(normal, -delta - z) : 0);
  }
  const double t =
      quantile(complement(boost::math::students_t(freedom), tail_of(test)));
  // Beyond this a difference is found for certain, and the series don't end.
  constexpr double kCertain = 100;
  if (delta > kCertain + t) return 1;
  const boost::math::non_central_t found(freedom, delta);
  return cdf(complement(found, t)) + (test.two_sided ? cdf(found, -t) : 0);
}

double readings_for(const PowerTest& test, double effect, double power) {
  constexpr double kMost = 1e12;
  const double least = test.known ? 1 : 2;
  const auto enough = [&](double count) {
    return power_of(test, effect, count) >= power;
  };
  if (enough(least)) return least;
  double few = least, many = 2 * least;
  while (!enough(many)) {
    few = many;
    many *= 2;
    if (many > kMost) return 0;
  }
  while (many - few > 1) {
    const double middle = std::floor((few + many) / 2);
    (enough(middle) ? many : few) = middle;
  }
  return many;
}

double effect_for(const PowerTest& test, double count, double power) {
  double high = test.sigma;
  while (power_of(test, high, count) < power) high *= 2;
  std::uintmax_t most = 200;
  const auto [low, up] = boost::math::tools::toms748_solve(
      [&](double effect) { return power_of(test, effect, count) - power; }, 0.0, high,
      boost::math::tools::eps_tolerance<double>(45), most);
  return (low + up) / 2;
}

}  // namespace delos::readings
