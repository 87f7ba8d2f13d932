// Processes that make one search together.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "delos/plugin/registry.h"

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

/// Take part in the searches of rank 0, whatever they are, until it dismisses.
/// @pre rank > 0
/// @throws std::runtime_error what another process has failed by
void serve(Crew& crew, PluginRegistry& plugins, int threads);

/// Rank 0 asks for no more searches.
void dismiss(Crew& crew);

}  // namespace delos
