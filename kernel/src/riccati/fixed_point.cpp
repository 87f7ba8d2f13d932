// Structure-preserving doubling: compose a map with itself until nothing is added.
//
// H of 2ʲ cycles grows monotonically to the fixed point, quadratically once the closed
// loop A forgets. Modes without noise need care:
//  - constant, measured (a bias): A keeps a one there for ever and nothing is ever
//    added to H, whose limit, zero variance, is the right one: the error of a filter
//    that starts ignorant falls as 1/t. Since a minute noise would look the same at
//    first, such a map is doubled on for kPatience doublings; what noise could still
//    add after 2^40 cycles is below rounding.
//  - growing, measured: from a known start H stays zero, yet any error at all would
//    grow to a finite variance. A trace of noise, 1e-32 of the rest, finds that
//    solution; its own effect is as small.
// Source: Chu, Fan, Lin, Wang (2004), Int. J. Control 77(8), 767–788,
//         doi:10.1080/00207170410001714988; convergence in the critical case:
//         Huang, Lin (2009), SIAM J. Matrix Anal. Appl. 31(2), 227–247,
//         doi:10.1137/080717304.
#include "riccati/fixed_point.h"

#include <algorithm>

namespace delos::riccati {
namespace {

constexpr int kPatience = 40;  // doublings until a bounded A is taken for constant
constexpr int kMaxDoublings = 64;
constexpr double kSettled = 1e-15;   // relative growth of a variance that is none
constexpr double kForgotten = 1e-8;  // ‖A‖ whose square is rounding
constexpr double kGrowing = 1e30;  // ‖A‖ that no constant mode reaches in 2⁴⁰ cycles
constexpr double kTrace = 1e-32;

enum class Outcome { settled, growing, limit };

template <class Matrix>
Outcome double_up(BasicUpdateMap<Matrix>& map, int& doublings, int patience) {
  for (; doublings < kMaxDoublings; ++doublings) {
    const BasicUpdateMap<Matrix> twice = compose(map, map);
    const double size = twice.A.cwiseAbs().maxCoeff();
    if (!twice.H.allFinite() || !(size < kGrowing)) return Outcome::growing;

    const auto before = map.H.diagonal().array();
    const auto after = twice.H.diagonal().array();
    const bool still = (after - before <= kSettled * after).all();
    map = twice;
    if (still && (size <= kForgotten || doublings >= patience)) {
      ++doublings;
      return Outcome::settled;
    }
  }
  return Outcome::limit;
}

template <class Matrix>
FixedPoint solve(const UpdateMap& start) {
  FixedPoint result;
  BasicUpdateMap<Matrix> m{start.A, start.G, start.H};
  Outcome outcome = double_up(m, result.doublings, kPatience);
  if (outcome == Outcome::growing) {
    m = {start.A, start.G, start.H};
    m.H.diagonal().array() += kTrace * std::max(1.0, start.H.diagonal().maxCoeff());
    result.doublings = 0;
    outcome = double_up(m, result.doublings, kMaxDoublings);
  }
  result.settled = outcome == Outcome::settled;
  result.posterior = m.H;
  return result;
}

}  // namespace

FixedPoint fixed_point(const UpdateMap& map) {
  if (map.A.rows() == 0) return {map.H, 0, true};
  // Position and velocity, the papers' state: knowing its size when compiling halves
  // its time.
  if (map.A.rows() == 6) return solve<Eigen::Matrix<double, 6, 6>>(map);
  return solve<StateMatrix>(map);
}

}  // namespace delos::riccati
