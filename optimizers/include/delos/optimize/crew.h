// Processes that make one search, or one simulation, together.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "delos/plugin/registry.h"
#include "delos/scene/scene.h"
#include "delos/simulation/simulate.h"

namespace delos {

/// Processes of one program, on one machine or many, that take the same steps. Rank 0
/// asks; the others serve().
class Crew {
 public:
  virtual ~Crew() = default;
  [[nodiscard]] virtual std::size_t rank() const = 0;
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// The host, for messages.
  [[nodiscard]] virtual std::string host() const = 0;

  /// What each process says, to all of them, in order of rank. All take this step
  /// together: it waits for the slowest.
  [[nodiscard]] virtual std::vector<std::string> exchange(const std::string& said) = 0;

  /// A search has failed, so that the others are no longer where rank 0 takes them to
  /// be: no step can be taken together any more.
  void abandon() { abandoned_ = true; }
  [[nodiscard]] bool abandoned() const { return abandoned_; }

 private:
  bool abandoned_ = false;
};

/// As simulate() of the scene's system, by rank 0, while the others serve(). Gives the
/// bytes that one process gives.
/// @param options without a filter of one's own
/// @throws std::invalid_argument as simulate()
/// @throws std::runtime_error another process has other plugins, or fails
/// @throws DeviceFault
[[nodiscard]] Simulation simulate_with_crew(const Scene& scene, const TargetPose& about,
                                            PluginRegistry& plugins,
                                            const SimulationOptions& options,
                                            Crew& crew);

/// Take part in what rank 0 asks for, whatever it is, until it dismisses.
/// @pre rank > 0
/// @throws std::runtime_error what another process has failed by
void serve(Crew& crew, PluginRegistry& plugins, int threads);

/// Rank 0 asks for nothing more.
void dismiss(Crew& crew);

}  // namespace delos
