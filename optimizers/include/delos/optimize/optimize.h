// Searches: better values for the variables of a scene.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "delos/optimize/problem.h"

namespace delos {

/// Which evaluation of a search this is: the same in every run of the same search.
struct EvaluationKey {
  int start = 0;   ///< which start of the search
  int number = 0;  ///< counted from 0 within the start
};

/// What an evaluation gave.
struct EvaluationRecord {
  double width = 0;  ///< softness of edges, 0: hard
  Score score;
  std::vector<double> slope, slopes;  ///< empty where none were asked for
};

/// Remembers evaluations, so that a search can be taken up again. Safe to call from
/// several threads.
class EvaluationLedger {
 public:
  virtual ~EvaluationLedger() = default;
  /// @param record with lists as long as those of this evaluation are
  /// @returns true, and the record, where this evaluation was made at this point before
  /// @throws std::runtime_error what is remembered can't be of this search
  virtual bool recall(const EvaluationKey& key, std::span<const double> x,
                      EvaluationRecord& record) = 0;
  /// Called before the search uses the record.
  virtual void remember(const EvaluationKey& key, std::span<const double> x,
                        const EvaluationRecord& record) = 0;
  using Told = std::function<void(const EvaluationKey&, std::span<const double> x,
                                  const EvaluationRecord&)>;
  /// Tell all that is remembered of the search; nothing, as here, where that can't be
  /// had.
  virtual void each(const Told&) {}
};

class Crew;

/// Which of a search's starts are searched: those k with k % of == index.
struct SearchPart {
  std::size_t index = 0, of = 1;
};

/// How far a search is.
struct SearchProgress {
  std::size_t evaluations = 0, of = 0;
  double best = 0;  ///< least hard objective of a feasible point so far; ∞: none yet
};

/// How to search.
struct OptimizeOptions {
  std::string algorithm = "auto";  ///< or one of algorithm_names()
  int evaluations = 0;             ///< at most so many; 0: by the problem's size
  /// 0: one of a global method; 16 where a worst sample decides (a limit on a metric,
  /// maximum, soft_max); else 4
  int starts = 0;
  std::uint64_t seed = 1;
  int threads = 0;             ///< 0: one a core
  std::size_t samples = 1500;  ///< looked at while searching
  const std::atomic<bool>* cancel = nullptr;
  /// Called now and then, from any thread but never from two at once.
  std::function<void(const SearchProgress&)> progress;
  EvaluationLedger* ledger = nullptr;
  /// Other processes that search too; they serve(). Null: this one alone.
  Crew* crew = nullptr;
  /// The starts that are searched here. Others are left out, or, where there is
  /// `meet`, recalled.
  SearchPart parts;
  /// Called when the starts of a phase have been searched, with what they failed by, or
  /// nothing: afterwards the ledger recalls the other parts' evaluations.
  /// @throws std::runtime_error a part has failed
  std::function<void(const std::string& problem)> meet;
};

/// How a search ended.
enum class SearchStop {
  converged,   ///< every start came to its end
  budget,      ///< the evaluations are spent
  cancelled,   ///< asked to stop; the best so far is reported
  infeasible,  ///< no design was found that keeps all constraints
};
[[nodiscard]] const char* to_string(SearchStop stop);

/// Whether a constraint is kept.
struct ConstraintReport {
  std::string name;
  bool satisfied = false;
  double slack = 0;  ///< least of its limits, SI; below 0: so much is missing
};

/// Whether a score of the problem keeps each constraint of its scene.
[[nodiscard]] std::vector<ConstraintReport> constraint_reports(Problem& problem,
                                                               const Score& score);

/// What came of a search. Scores are hard, on all samples of the scene.
struct OptimizeResult {
  std::vector<double> initial_x, best_x;  ///< in the unit cube
  Score initial, best;
  /// The objectives without what they withstand: see Problem::plain_objective().
  double plain_initial = 0, plain_best = 0;
  Field initial_field, best_field;  ///< of the scene's metric
  Scene initial_scene;              ///< as it was given
  Scene scene;                      ///< with the best values
  std::vector<ConstraintReport> constraints;
  std::vector<std::string> messages;  ///< what was repaired, for the user
  std::string algorithm;
  SearchStop stop = SearchStop::converged;
  std::size_t evaluations = 0, gradient_evaluations = 0;
  double seconds = 0;
};

[[nodiscard]] std::vector<std::string> algorithm_names();

/// The scene with the guess of its objective and its fusion written down, so that
/// scores of other designs can be compared with its own.
/// @throws std::invalid_argument as Problem
[[nodiscard]] Scene with_guess(Scene scene, PluginRegistry& plugins);

/// Search for the least objective that keeps all constraints.
///
/// With slopes: from each start, SLSQP (CCSA for many variables) over edges that are
/// 0.3, 0.1, 0.03, 0.01 and 0 rad wide; every stage's end is scored hard, and after the
/// third the worse half of the starts is given up. Without: BOBYQA, or COBYLA where
/// there are limits. Starts: the scene as it stands, then random ones, half of them
/// near it, all by the seed. The best is scored on all samples.
/// @throws std::invalid_argument one sentence: nothing to change, a method that doesn't
///         fit, or constraints that contradict each other, by name
[[nodiscard]] OptimizeResult optimize(const Scene& given, PluginRegistry& plugins,
                                      const OptimizeOptions& options);

}  // namespace delos
