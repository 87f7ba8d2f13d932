// One start of a search, and what all starts share.
#pragma once

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "delos/optimize/optimize.h"
#include "nlopt/solver.h"

namespace delos {

/// Widths of edges, radians, one a stage; at last they are as hard as they are judged.
inline constexpr double kWidths[] = {0.3, 0.1, 0.03, 0.01, 0};
/// After so many stages the worse half of the starts is given up, which spares the time
/// of the sharp stages, on all samples.
inline constexpr int kExploring = 3;

/// A search as it was decided on.
struct Plan {
  std::string algorithm;
  SolverTraits traits;
  int starts = 1;
  int per_start = 0;  ///< evaluations
};

/// What all starts of a search share.
class Shared {
 public:
  explicit Shared(const OptimizeOptions& options, std::size_t of)
      : options_(options), of_(of) {}

  void count(bool slopes) {
    const std::lock_guard lock(mutex_);
    ++(slopes ? gradient_evaluations_ : evaluations_);
    tell();
  }
  void found(double objective) {
    const std::lock_guard lock(mutex_);
    best_ = std::min(best_, objective);
    tell();
  }
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }
  [[nodiscard]] std::size_t gradient_evaluations() const {
    return gradient_evaluations_;
  }

 private:
  void tell() {
    if (options_.progress)
      options_.progress({evaluations_ + gradient_evaluations_, of_, best_});
  }

  const OptimizeOptions& options_;
  std::size_t of_;
  std::mutex mutex_;
  std::size_t evaluations_ = 0, gradient_evaluations_ = 0;
  double best_ = std::numeric_limits<double>::infinity();
};

/// Whether one score is better than another: feasible first, then the objective.
[[nodiscard]] bool better(const Score& a, const Score& b,
                          const std::vector<Limit>& limits);

/// Edges at least so wide are searched on a quarter of the samples.
inline constexpr double kCoarseWidth = 0.1;

/// A problem, for one thread at a time.
class Workplace {
 public:
  /// What is passed is kept by reference, but for the options.
  Workplace(const Scene& scene, PluginRegistry& plugins, const ProblemOptions& options);

  /// What hard scores are of, the same for all starts and stages.
  Problem problem;

  /// What a stage minimises: on fewer samples while edges are wide. Adaptive sets are
  /// sampled by the octree of the design that the stage begins with, until the next
  /// one.
  [[nodiscard]] Problem& of_stage(double width, const std::vector<double>& from);

 private:
  const Scene& scene_;
  PluginRegistry& plugins_;
  ProblemOptions options_, coarse_options_;
  bool adaptive_;
  std::optional<Problem> coarse_;  // where nothing is adaptive
  std::optional<Problem> frozen_;
};

/// One start of a search. What is passed is kept by reference.
class Start {
 public:
  Start(const OptimizeOptions& options, const Plan& plan, int index, Shared& shared)
      : options_(options), plan_(plan), index_(index), shared_(shared) {}

  /// The first stages, or all of a method that has none; none where the search is
  /// cancelled already.
  void explore(Workplace& at, const std::vector<double>& from);
  /// The other stages.
  void finish(Workplace& at);

  [[nodiscard]] bool explored() const { return !best_.empty(); }
  /// The best point by its hard score on the samples of the search. @pre explored()
  [[nodiscard]] const std::vector<double>& best() const { return best_; }
  [[nodiscard]] const Score& best_score() const { return best_score_; }

  /// Whether evaluations ran out before a stage had come to its end.
  [[nodiscard]] bool spent() const { return spent_; }

 private:
  [[nodiscard]] bool cancelled() const {
    return options_.cancel && options_.cancel->load();
  }
  template <class Evaluate>
  EvaluationRecord remembered(std::span<const double> x, bool slopes,
                              Evaluate&& evaluate);
  Score hard(std::span<const double> x);
  EvaluationRecord soft(std::span<const double> x, double width);
  void note();
  void take(std::span<const double> x, const Score& score);
  void run_stages(int first, int end);
  std::vector<double> run_stage(const std::vector<double>& from, double width,
                                int evaluations);
  [[nodiscard]] const std::vector<Limit>& limits() const {
    return at_->problem.limits();
  }

  Workplace* at_ = nullptr;
  Problem* stage_ = nullptr;  // what soft() asks
  const OptimizeOptions& options_;
  const Plan& plan_;
  int index_;
  Shared& shared_;
  int number_ = 0;
  bool spent_ = false;
  std::vector<double> x_;  // where the last stage ended
  std::vector<double> best_;
  Score best_score_;
};

}  // namespace delos
