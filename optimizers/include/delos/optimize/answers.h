// What a design depends on: which variable, how far it may be off, which device.
#pragma once

#include <atomic>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "delos/optimize/problem.h"

namespace delos {

/// What one variable means to a design.
struct VariableAnswer {
  std::string path;
  /// ∂objective/∂variable, in SI, soft edges; 0 where there are no slopes.
  double slope = 0;
  /// How far the variable alone may fall and rise, in SI, before the objective loses
  /// more than the loss asked about, or a constraint; as far as its bounds let it.
  double down = 0, up = 0;
  bool down_is_bound = false, up_is_bound = false;  ///< the bound came first
};

/// What one device means to a design.
struct DeviceAnswer {
  std::string name;
  /// Relative rise of the objective, without what it withstands, where it alone fails.
  double without = 0;
};

/// What a design depends on.
struct Answers {
  double loss = 0.05;  ///< relative rise of the objective that is tolerated
  std::vector<VariableAnswer> variables;
  std::vector<DeviceAnswer> devices;  ///< the one that is missed most stands first
};

/// Samples on which a problem should be asked, at most. A failure is often told by a
/// few that it leaves blind, which a search's thinner samples may miss.
inline constexpr std::size_t kAnswerSamples = 10'000;

using AnswerProgress = std::function<void(std::size_t done, std::size_t of)>;

/// @param at the design, in the unit cube
/// @param progress called with steps done and steps in all
/// @cost some twenty evaluations a variable, each of which moves one device
[[nodiscard]] Answers answers(Problem& problem, std::span<const double> at, double loss,
                              const std::atomic<bool>* cancel = nullptr,
                              const AnswerProgress& progress = {});

}  // namespace delos
