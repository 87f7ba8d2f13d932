// How many readings show a difference: statistical power.
//
// A mean of N readings of standard deviation σ is compared with a known value, or with
// the mean of N other readings. With s = 1 or 2 such means the test sees a difference E
// as δ = E/(σ √(s/N)) and finds it with the probability
//
//     z: σ is known        1 − β = Φ(δ − z) + Φ(−δ − z)
//     t: σ is estimated    1 − β = 1 − F(t; ν, δ) + F(−t; ν, δ)     ν = s (N − 1)
//
// where z and t leave α/2 at either end, and F is of the noncentral t distribution; of
// a one-sided test the first term alone, with α at one end.
//
// Source: J. Cohen: Statistical power analysis for the behavioral sciences, 2nd ed.,
// 1988, chapter 2; B. D. Allen, dissertation, 2007, section 8.4.
#pragma once

#include <string>

namespace delos::readings {

struct PowerTest {
  double sigma = 1;        ///< of one reading, in any unit, > 0
  double alpha = 0.05;     ///< how often a difference is seen that isn't, 0 to 1
  bool two_sided = true;   ///< differences either way count
  bool two_means = false;  ///< against the mean of as many other readings
  bool known = true;       ///< σ is known: z; else estimated from the readings: t
};

/// The probability that a difference of means is found.
/// @param effect E, in the unit of σ, ≥ 0
/// @param count N of each mean; of a t test 2 or more
[[nodiscard]] double power_of(const PowerTest& test, double effect, double count);

/// The fewest readings of each mean that find a difference with a probability.
/// @param power 1 − β, above α and below 1
/// @returns 0 where 10^12 aren't enough
[[nodiscard]] double readings_for(const PowerTest& test, double effect, double power);

/// The least difference that so many readings find with a probability.
/// @param count as of power_of()
[[nodiscard]] double effect_for(const PowerTest& test, double count, double power);

/// z of α/2, or of α of a one-sided test, and of β: the published formula is
/// N = s σ² (z_α + z_β)²/E², which leaves out the far end.
struct CriticalValues {
  double alpha = 0, beta = 0;
};
[[nodiscard]] CriticalValues critical_values(const PowerTest& test, double power);

/// Empty where the numbers make a test, else what is wrong with them.
[[nodiscard]] std::string power_problem(const PowerTest& test, double power);

}  // namespace delos::readings
