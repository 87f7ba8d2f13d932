// Changes of a scene in their order, and back.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "delos/document/override.h"

namespace delos::session {

/// Steps of changes, of which some may be undone. Its memory is bounded: what is longer
/// ago than kMostSteps can't be undone any more, and of what is kept of that the last
/// value of a path counts.
class History {
 public:
  static constexpr std::size_t kMostSteps = 500;

  /// Add a step after those that aren't undone; those that are, are gone.
  /// @param gesture what several changes have in common that are undone together, such
  ///        as one drag; empty: a step of its own
  void add(std::vector<Override> changes, const std::string& gesture);

  /// @returns false where there is nothing to undo
  bool undo();
  bool redo();
  /// The next change begins a step, whatever its gesture.
  void end_gesture();

  [[nodiscard]] std::size_t undoable() const { return done_; }
  [[nodiscard]] std::size_t redoable() const { return steps_.size() - done_; }

  /// Changes that are too long ago to be undone.
  [[nodiscard]] const std::vector<Override>& settled() const { return settled_; }
  /// They are in the scene by now.
  void forget_settled() { settled_.clear(); }

  /// Steps that were ever taken and aren't undone.
  [[nodiscard]] std::size_t steps() const { return settled_steps_ + done_; }
  /// Those that are too long ago to be undone.
  [[nodiscard]] std::size_t settled_steps() const { return settled_steps_; }
  /// The changes of the steps after so many. @pre steps ≥ settled_steps()
  [[nodiscard]] std::vector<Override> changes_after(std::size_t steps) const;

  /// All changes that aren't undone, in order.
  [[nodiscard]] std::vector<Override> changes() const;

 private:
  struct Step {
    std::string gesture;
    std::vector<Override> changes;
  };
  std::vector<Override> settled_;
  std::deque<Step> steps_;
  std::size_t done_ = 0;
  std::size_t settled_steps_ = 0;
};

}  // namespace delos::session
