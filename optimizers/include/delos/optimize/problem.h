// What a search asks of a scene: its objective and constraints at a point.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "delos/field/evaluate.h"
#include "delos/optimize/design.h"

namespace delos {

/// How a problem is evaluated.
struct ProblemOptions {
  /// Samples that a search looks at, at most: larger sets are thinned evenly, adaptive
  /// ones replaced by points spread over their box. 0: all, and a fine grid of those.
  std::size_t samples = 1500;
  int threads = 0;
  /// A design in the unit cube: adaptive sets become the nodes of the octree that its
  /// field asks for, about `samples` of them, each with its volume. Empty: as above.
  std::vector<double> octree_of = {};
};

/// Objective and constraints at one point.
struct Score {
  double objective = 0;        ///< what is made small; finite
  std::vector<double> slacks;  ///< one a limit, see Problem::limits(); ≥ 0 where kept
  [[nodiscard]] bool feasible() const;
};

/// One inequality that a constraint stands for, such as the distance of one pair.
struct Limit {
  std::size_t constraint;  ///< index in the scene
  double scale = 1;        ///< a slack of this size is a large one; > 0
};

/// The objective and the constraints of a scene over its variables. Not thread-safe:
/// one a thread.
class Problem {
 public:
  /// @throws std::invalid_argument one sentence: nothing to change, what can't be
  ///         solved, or a single device that may fail
  Problem(const Scene& scene, PluginRegistry& plugins, const ProblemOptions& options);
  ~Problem();
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  [[nodiscard]] Design& design();
  /// The guess of the objective, given or not.
  [[nodiscard]] double guess() const;
  [[nodiscard]] const std::vector<Limit>& limits() const;
  [[nodiscard]] std::size_t samples() const;

  /// Empty where score_with_slopes() works; else why not.
  [[nodiscard]] const std::string& slope_problem() const;

  /// The score with hard edges: what results are judged by.
  /// @param x in [0, 1]ⁿ
  [[nodiscard]] Score score(std::span<const double> x);

  /// The score with soft edges, docs/theory.md, and its slopes in the unit cube.
  /// @param width see SoftField
  /// @param[out] slope   n numbers, ∂objective/∂x
  /// @param[out] slopes  limits × n, ∂slack/∂x, row after row
  /// @pre slope_problem().empty()
  [[nodiscard]] Score score_with_slopes(std::span<const double> x, double width,
                                        double* slope, double* slopes);
  /// The same score without slopes.
  [[nodiscard]] Score soft_score(std::span<const double> x, double width);

  /// The slacks of the first limits, those that places and numbers alone decide; cheap.
  [[nodiscard]] std::vector<double> place_slacks(std::span<const double> x);

  /// The objective, hard, where nothing fails and all is where it should be: what a
  /// robust objective is without `robust`.
  [[nodiscard]] double plain_objective(std::span<const double> x);
  /// The same where one device fails.
  /// @pre there are two devices or more
  [[nodiscard]] double objective_without(std::span<const double> x, std::size_t device);

  /// The field of the scene's metric at x, hard, on all samples of the scene, without
  /// the guess of the objective.
  [[nodiscard]] Field field(std::span<const double> x);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delos
