#include "observe/beacon_choice.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace delos {
namespace {

using All = std::vector<BeaconSighting>;

double total_weight(const All& all) {
  return std::accumulate(all.begin(), all.end(), 0.0,
                         [](double sum, const auto& s) { return sum + s.weight; });
}

void use_all(All& all) {
  for (BeaconSighting& s : all) s.share = s.weight;
}

void use_mean(double count, All& all) {
  const double total = total_weight(all);
  for (BeaconSighting& s : all) s.share = count * s.weight / total;
}

void use_random(double count, All& all) {
  const double part = std::min(1.0, count / total_weight(all));
  for (BeaconSighting& s : all) s.share = part * s.weight;
}

void use_nearest(double count, All& all, std::vector<std::uint32_t>& order) {
  order.resize(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return all[a].distance != all[b].distance ? all[a].distance < all[b].distance
                                              : a < b;
  });
  for (const std::uint32_t i : order) {
    all[i].share = std::min(all[i].weight, count);
    count -= all[i].share;
  }
}

/// The split of a count among sightings that makes log det S largest,
///
///   S(x) = Σ xᵢ Sᵢ,   0 ≤ xᵢ ≤ wᵢ,   Σ xᵢ = count,
///
/// which is what the best schedule reaches in the long run. The determinant compares
/// metres with radians without a scale between them. It is concave in x: pairs of
/// sightings exchange shares until no exchange gains more than a tolerance. With
/// D = Sᵢ − Sⱼ, the gain's slope and curvature at δ = 0 are tr S⁻¹D and −tr (S⁻¹D)².
///
/// Source: Pukelsheim (1993), Optimal Design of Experiments, ch. 9 (D-optimality).
class BestSplit {
 public:
  BestSplit(int coordinates, BeaconSightings& sightings)
      : d_(coordinates), all_(sightings.all), rows_(sightings.rows) {
    double largest = 0;
    for (const SightingRow& r : rows_) largest = std::max(largest, r.variance);
    least_variance_ = std::max(1e-9 * largest, std::numeric_limits<double>::min());
  }

  void run(double count) {
    constexpr double kTolerance = 1e-5;  // of log det S
    constexpr int kMostSteps = 2000;
    for (int step = 0; step < kMostSteps && invert(); ++step) {
      const auto [up, down] = steepest_exchange();
      if (up == down) return;
      // All exchanges together move at most the count, none gaining more than this.
      const double slope = gain(all_[up]) - gain(all_[down]);
      if (slope * count <= kTolerance) return;
      exchange(all_[up], all_[down], slope);
    }
  }

 private:
  template <class Use>
  void for_rows(const BeaconSighting& s, Use&& use) const {
    for (std::uint32_t r = s.first_row; r < s.first_row + s.rows; ++r) {
      use(Eigen::Map<const Eigen::VectorXd>(rows_[r].h, d_),
          std::max(rows_[r].variance, least_variance_));
    }
  }

  /// S⁻¹ of the present shares; false where S is singular, and no share helps.
  bool invert() {
    CoordinateMatrix S = CoordinateMatrix::Zero(d_, d_);
    for (const BeaconSighting& s : all_) {
      for_rows(
          s, [&](const auto& h, double r) { S += (s.share / r) * h * h.transpose(); });
    }
    // Equilibrated, so that singular means the same in metres and in radians.
    const CoordinateVector scale = S.diagonal().cwiseSqrt().cwiseInverse();
    if (!scale.allFinite()) return false;
    const Eigen::LLT<CoordinateMatrix> chol(scale.asDiagonal() * S *
                                            scale.asDiagonal());
    if (chol.info() != Eigen::Success || chol.rcond() < 1e-12) return false;
    inverse_ = scale.asDiagonal() * chol.solve(CoordinateMatrix::Identity(d_, d_)) *
               scale.asDiagonal();
    return true;
  }

  /// tr S⁻¹Sᵢ
  double gain(const BeaconSighting& s) const {
    double sum = 0;
    for_rows(s, [&](const auto& h, double r) { sum += h.dot(inverse_ * h) / r; });
    return sum;
  }

  /// Who may give, and whom it would help most.
  std::pair<std::size_t, std::size_t> steepest_exchange() const {
    double best = -1, least = std::numeric_limits<double>::infinity();
    std::size_t up = 0, down = 0;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const double g = gain(all_[i]);
      if (all_[i].share < all_[i].weight && g > best) best = g, up = i;
      if (all_[i].share > 0 && g < least) least = g, down = i;
    }
    return best < 0 ? std::pair{down, down} : std::pair{up, down};
  }

  /// A Newton step, damped: the gain is self-concordant, so that it never overshoots.
  void exchange(BeaconSighting& up, BeaconSighting& down, double slope) const {
    CoordinateMatrix D = CoordinateMatrix::Zero(d_, d_);
    for_rows(up, [&](const auto& h, double r) { D += h * h.transpose() / r; });
    for_rows(down, [&](const auto& h, double r) { D -= h * h.transpose() / r; });
    const CoordinateMatrix M = inverse_ * D;
    const double curvature = (M * M).trace();
    const double step =
        slope / (curvature + slope * std::sqrt(std::max(0.0, curvature)));
    const double delta = std::min({step, up.weight - up.share, down.share});
    up.share = delta == up.weight - up.share ? up.weight : up.share + delta;
    down.share = delta == down.share ? 0 : down.share - delta;
  }

  int d_;
  All& all_;
  const std::vector<SightingRow>& rows_;
  double least_variance_;
  CoordinateMatrix inverse_;
};

}  // namespace

void choose(SightingRule rule, int count, int coordinates, BeaconSightings& sightings,
            std::vector<std::uint32_t>& order) {
  All& all = sightings.all;
  if (all.empty()) return;
  switch (rule) {
    case SightingRule::all:
      return use_all(all);
    case SightingRule::mean:
      return use_mean(count, all);
    case SightingRule::random:
      return use_random(count, all);
    case SightingRule::nearest:
      return use_nearest(count, all, order);
    case SightingRule::best:
      use_random(count, all);
      if (total_weight(all) > count) BestSplit(coordinates, sightings).run(count);
  }
}

}  // namespace delos
