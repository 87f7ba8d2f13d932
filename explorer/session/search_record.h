// Which designs a search has looked at, as far as people ask about them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "delos/optimize/design.h"
#include "delos/optimize/study.h"
#include "session/job.h"
#include "session/scene_changes.h"

namespace delos::session {

/// What a round searches: other variables after a lock, another scene after an edit.
struct SearchedRound {
  int number = 0;
  std::vector<std::string> paths;
  std::vector<double> lower, upper;  ///< SI, of each
  std::vector<char> logarithmic;     ///< likewise
};

/// A design that was evaluated.
struct SearchedDesign {
  std::size_t evaluation = 0;  ///< counted from 1 over the whole search
  int round = 0;
  double objective = 0;        ///< as it is minimised, on the samples of the search
  bool soft = false;           ///< by softened edges: not to be compared with hard ones
  bool feasible = false;       ///< keeps all constraints
  std::vector<double> values;  ///< SI, of the round's variables
};

/// Not thread-safe. Its memory is bounded: of designs that weren't the best of their
/// time every second is forgotten when there are too many; of those that were, and of
/// rounds, the first ones.
class SearchRecord {
 public:
  static constexpr std::size_t kMostDesigns = 400, kMostIncumbents = 1000,
                               kMostRounds = 100;

  /// A round begins: what was the best before isn't any more.
  /// @param scene that it searches, without what is locked
  void begin_round(int number, const Scene& scene, PluginRegistry& plugins);
  /// What the rounds up to one still find is of another design: it is no incumbent.
  void part_from_rounds(int last);
  /// Whether the last round is such a one.
  [[nodiscard]] bool parted() const { return round() <= parted_; }
  /// Evaluations that a resumed search recalls count once.
  void add(const StudyEvaluation& evaluation);

  [[nodiscard]] int round() const {
    return rounds_.empty() ? 0 : rounds_.back().number;
  }
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }
  /// The best of the last round. @returns null where none keeps the constraints yet
  [[nodiscard]] const SearchedDesign* best() const { return best_ ? &*best_ : nullptr; }
  /// Incumbents that were ever found.
  [[nodiscard]] std::size_t incumbents() const {
    return forgotten_ + incumbents_.size();
  }
  /// The values of an incumbent, counted from 0 as they were found.
  /// @throws std::invalid_argument it isn't kept, or was never
  [[nodiscard]] VariableValues values(std::size_t incumbent) const;
  [[nodiscard]] VariableValues values(const SearchedDesign& design) const;

  /// {rounds: [{round, variables, lower, upper, logarithmic}], evaluations,
  ///  incumbents: [{number, evaluation, round, objective, values}],
  ///  designs: [{evaluation, round, objective, soft, feasible, values}]}
  /// of what wasn't heard. @param sign −1: the objective is shown without the sign that
  /// minimising gave it
  [[nodiscard]] Json json(const Heard& heard, double sign) const;

 private:
  void keep(SearchedDesign design);
  void forget_round();
  void improve(const SearchedDesign& design);

  std::vector<SearchedRound> rounds_;
  std::unique_ptr<::delos::Design> converter_;  // of the last round
  std::vector<int> counted_;                    // evaluations of each start of it
  std::size_t evaluations_ = 0, stride_ = 1, forgotten_ = 0;
  int parted_ = 0;  ///< rounds up to this one are of another design
  /// Whether the design that the round began with is known: before, nothing is better
  /// than it, and what other starts have found waits.
  bool begun_ = false;
  std::optional<SearchedDesign> best_, waiting_;
  std::vector<SearchedDesign> incumbents_, designs_;
};

}  // namespace delos::session
