// Ctrl-C as a request: the first one stops the work cleanly, the second one ends at
// once.
#pragma once

#include <atomic>

namespace delos::cli {

/// While one lives, SIGINT and SIGTERM set a flag instead of ending the program.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] const std::atomic<bool>& requested() const;
};

}  // namespace delos::cli
