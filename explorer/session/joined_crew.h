// The processes that a launcher such as mpirun started with this one.
#pragma once

#include <memory>

#include "delos/optimize/crew.h"

namespace delos::session {

/// The crew of this run, if there is one; while it lives, others wait for rank 0's
/// searches. Rank 0 dismisses them in the end.
class JoinedCrew {
 public:
  /// Joins where the environment says that there are others.
  /// @param threads of each process; 0: its share of the machine's cores
  /// @throws Refusal of the question: Delos has no MPI here
  explicit JoinedCrew(int threads);
  ~JoinedCrew();
  JoinedCrew(const JoinedCrew&) = delete;
  JoinedCrew& operator=(const JoinedCrew&) = delete;

  /// Null where this process is alone.
  [[nodiscard]] Crew* get() const { return crew_.get(); }
  [[nodiscard]] int threads() const { return threads_; }

  /// Where this isn't rank 0: take part until that has ended.
  /// @returns whether it did: there is nothing else to do then
  /// @throws std::runtime_error as serve()
  [[nodiscard]] bool served(PluginRegistry& plugins) const;

 private:
  std::unique_ptr<Crew> crew_;
  int threads_;
};

}  // namespace delos::session
