// The cost of a choice of candidates of a scene: variances over its samples.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "delos/layers/candidate_information.h"
#include "delos/model/metric.h"
#include "delos/steady/covariance_map.h"
#include "problem/search_samples.h"
#include "selection/cost.h"

namespace delos {

/// What is certified: a sum of means and maxima, over samples, of variances.
///
///     f(w) = Σ_terms weight · mean or max_samples φ(P∞(S(w)))
///
/// φ is the square of a metric that is a standard deviation: P_ii, a trace, the largest
/// eigenvalue, or the Frobenius norm of a block. All are convex and rise with P, and P∞
/// is convex and falls with S, which is linear in w: f is convex.
struct VarianceTerm {
  Metric metric;
  double weight = 1;
  bool maximum = false;         ///< else the mean
  std::vector<double> samples;  ///< weights that sum to 1; maximum: of those above 0
};

/// Empty where the square of the metric, or the metric itself, is convex in P.
[[nodiscard]] std::string variance_problem(const Metric& metric);
/// Whether the metric is the root of its variance.
[[nodiscard]] bool is_deviation(const Metric& metric);

class FieldCost final : public ChoiceCost {
 public:
  FieldCost(const System& system, const CandidateScene& all, const Samples& samples,
            const Orientations& orientations, std::vector<VarianceTerm> terms,
            int threads);

  [[nodiscard]] std::size_t size() const override { return size_; }
  [[nodiscard]] double value(std::span<const double> w) override;
  /// @cost of the samples that see what changes
  [[nodiscard]] std::vector<double> changed(std::span<const char> chosen,
                                            std::span<const Change> changes) override;
  bool tangent(std::span<const double> w, double sharpness, Tangent& out) override;
  [[nodiscard]] const std::vector<std::size_t>& whole_ones() const override {
    return whole_ones_;
  }
  void exclude(std::span<const char> out) override;

  /// A sample whose variance isn't finite at w; samples() where there is none.
  [[nodiscard]] std::size_t blind_sample(std::span<const double> w);
  [[nodiscard]] std::size_t samples() const { return samples_; }
  /// Whether some equation wasn't solved, so that what was found proves nothing.
  [[nodiscard]] bool unsettled() const { return unsettled_; }

 private:
  struct Sample;  // what one sample adds
  void information(std::span<const double> w, std::size_t pose, StateMatrix& S) const;
  /// Rows without noise. @param fractions whether open candidates have theirs
  void exact_rows(std::span<const double> w, bool fractions, std::size_t pose,
                  Eigen::MatrixXd& rows) const;
  bool solve(std::span<const double> w, bool fractions, std::size_t pose,
             CovarianceMap::Solution& out) const;
  bool settles(const StateMatrix& S, const Eigen::MatrixXd& exact,
               CovarianceMap::Solution& out) const;
  [[nodiscard]] double total(const std::vector<double>& values) const;
  bool hard(std::span<const double> w, std::size_t sample, double* values) const;
  bool soft(std::span<const double> w, double sharpness, std::size_t sample,
            Sample& out) const;
  void accumulate(std::size_t sample, const Sample& part, std::span<const double> pull,
                  double* slope) const;
  template <class Body>
  void each_chunk(Body&& body) const;

  StateLayout layout_;
  OrientationRule combine_;
  std::vector<VarianceTerm> terms_;
  CovarianceMap map_;
  CandidateInformation known_;
  mutable std::atomic<bool> unsettled_ = false;
  std::vector<std::size_t> whole_ones_;
  std::vector<char> excluded_;
  std::vector<std::vector<std::uint32_t>> seen_by_;  ///< samples that see a candidate
  std::size_t size_, samples_, turns_, packed_;
  int threads_;
  /// Of each term and sample, the scale of its kinks: φ where everything is chosen.
  std::vector<std::vector<double>> scale_;
};

}  // namespace delos
