// A scene as something to choose from.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "delos/optimize/select.h"
#include "problem/search_samples.h"
#include "selection/exchange.h"
#include "selection/field_cost.h"
#include "selection/polytope.h"

namespace delos {

/// Everything that a selection is about.
struct Question {
  CandidateScene all;
  System system;
  SearchSamples samples;
  std::vector<VarianceTerm> terms;
  double guess = 0;  ///< metres and radians, by which blind samples are judged
  ChoiceRules rules;
  std::vector<Decision> decisions;
};

/// One flag a sample, or empty where nothing is solid.
[[nodiscard]] std::vector<unsigned char> samples_inside_solids(
    const System& system, const Samples& samples, const Orientations& orientations);

/// @throws std::invalid_argument as select()
[[nodiscard]] Question question_of(const Scene& scene, PluginRegistry& plugins,
                                   const SelectOptions& options);

/// The rules for at most `count` candidates.
[[nodiscard]] ChoiceRules rules_for(const CandidateScene& all, int count);

/// Its cost.
/// @throws std::invalid_argument as select(): a sample isn't observable
[[nodiscard]] std::unique_ptr<FieldCost> cost_of(const Question& question, int threads);

/// @throws std::invalid_argument some equation wasn't solved
void check_settled(const FieldCost& cost);

/// @throws std::invalid_argument the best choice is blind, whatever the guess
void check_judged(const Choice& best);

/// What is certified, as a standard deviation where there is one.
struct Quantity {
  bool root = false;
  double weight = 1;
  std::string text, unit;
  /// +∞ where something is blind.
  [[nodiscard]] double of(double cost) const {
    if (is_blind(cost)) return std::numeric_limits<double>::infinity();
    return root ? std::sqrt(cost / weight) : cost;
  }
  /// The gap of costs that goes with one of the quantity: a small relative change of a
  /// variance is twice that of its root.
  [[nodiscard]] double cost_gap(double gap) const {
    return root ? (1 + gap) * (1 + gap) - 1 : gap;
  }
};

[[nodiscard]] Quantity quantity_of(const Question& question);

}  // namespace delos
