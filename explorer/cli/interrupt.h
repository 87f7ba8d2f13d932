// Ctrl-C, or a terminal that is closed, as a request: the first one stops the work
// cleanly, the second one ends at once.
#pragma once

#include <atomic>

namespace delos::cli {

/// While one lives, SIGINT, SIGTERM and SIGHUP set a flag instead of ending the
/// program.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] const std::atomic<bool>& requested() const;
};

}  // namespace delos::cli
