// The cost of a choice of candidates of a scene: variances over its samples.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "delos/layers/candidate_information.h"
#include "delos/model/metric.h"
#include "delos/steady/steady_solver.h"
#include "problem/search_samples.h"
#include "selection/cost.h"

namespace delos {

/// What is certified: a sum of means and maxima, over samples, of variances.
///
///     f(w) = Σ_terms weight · mean or max_samples φ(P∞(S(w)))
///
/// φ is variance_value() of the metric: P_ii, a trace, the largest eigenvalue, or the
/// Frobenius norm of a block. All are convex and rise with P, and P∞ is convex and
/// falls with S, which is linear in w: f is convex.
///
/// A sample is blind where a field of the choice says so: where a metric reads a
/// direction that the solver of fields calls lost. It then costs kBlindCost for each,
/// or what it costs with a guess of the pose beside what is known. A guess only ever
/// lowers a cost: tangents of f with it lie below f without it.
struct VarianceTerm {
  Metric metric;
  double weight = 1;
  bool maximum = false;         ///< else the mean
  std::vector<double> samples;  ///< weights that sum to 1; maximum: of those above 0
};

/// Empty where φ of the metric is convex and rises with P.
[[nodiscard]] std::string variance_problem(const Metric& metric);

class FieldCost final : public ChoiceCost {
 public:
  /// @param guess information, as System::prior, by which blind samples are judged: all
  ///        of them at first
  /// @pre adjoint_problem() is empty
  FieldCost(const System& system, const CandidateScene& all, const Samples& samples,
            const Orientations& orientations, std::vector<VarianceTerm> terms,
            double guess, int threads);

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

  /// A sample that is blind even with every candidate and the guess; samples(): none.
  [[nodiscard]] std::size_t hopeless_sample();
  /// Judge by the guess what is blind whatever is chosen, and nothing else.
  /// @param available one flag a candidate: it may be chosen
  void guess_the_always_blind(std::span<const char> available);
  /// Judge by the guess whatever a choice leaves blind.
  void guess_the_blind();
  /// The samples that a choice leaves blind, judged by the guess or not.
  [[nodiscard]] std::vector<std::size_t> blind_samples(std::span<const char> chosen);
  [[nodiscard]] std::size_t samples() const { return samples_; }
  /// Whether that of some whole choice wasn't solved, so that what was found proves
  /// nothing.
  [[nodiscard]] bool unsettled() const { return unsettled_; }

 private:
  struct Sample;  // what one sample adds
  struct Turn;
  struct Scratch;
  void add_information(std::span<const double> w, std::size_t pose, double share,
                       SteadyEquation& at) const;
  /// Rows without noise. @param fractions whether open candidates have theirs
  void add_perfect_rows(std::span<const double> w, bool fractions, std::size_t pose,
                        SteadyEquation& at) const;
  void solve(std::span<const double> w, bool fractions, double guess,
             std::size_t sample, std::size_t turn, Turn& out) const;
  /// Whether what a term reads of a sample is finite, if it reads anything.
  [[nodiscard]] bool sees(const Turn& turn, std::size_t sample, std::size_t term) const;
  /// Whether some term reads a sample.
  [[nodiscard]] bool counts(std::size_t sample) const;
  [[nodiscard]] double total(const std::vector<double>& values) const;
  void hard(std::span<const double> w, std::size_t sample, Scratch& scratch,
            double* values) const;
  bool soft_turn(std::span<const double> w, std::size_t sample, std::size_t turn,
                 Turn& out) const;
  bool soft(std::span<const double> w, double sharpness, std::size_t sample,
            Scratch& scratch, Sample& out) const;
  void soft_term(std::size_t term, double sharpness, Scratch& scratch,
                 Sample& out) const;
  void spread(const StateMatrix& G, std::size_t turn, std::vector<double>& slope) const;
  void accumulate(std::size_t sample, const Sample& part, std::span<const double> pull,
                  double* slope) const;
  template <class Body>
  void each_chunk(Body&& body) const;

  StateLayout layout_;
  OrientationRule combine_;
  std::vector<VarianceTerm> terms_;
  CovarianceKind kind_;
  std::unique_ptr<const SmoothSteadySolver> solver_;
  SteadyRequest request_;
  CandidateInformation known_;
  mutable std::atomic<bool> unsettled_ = false;
  std::vector<std::size_t> whole_ones_;
  std::vector<char> excluded_;
  double prior_, guess_;
  std::vector<char> guessed_;  ///< solved turns: judged by the guess where blind
  std::vector<std::vector<std::uint32_t>> seen_by_;  ///< samples that see a candidate
  std::size_t size_, samples_, turns_;
  std::size_t solved_;  ///< turns that are solved: solved_turns()
  std::size_t packed_;
  int threads_;
  /// Of each term and sample, the scale of its kinks: φ where everything is chosen.
  std::vector<std::vector<double>> scale_;
};

}  // namespace delos
