// Progress of long work, on stderr.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace delos::cli {

/// Shows nothing in the first second; then a bar that is redrawn on a terminal, or a
/// line every few seconds elsewhere.
class Progress {
 public:
  explicit Progress(std::string label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done, std::size_t all);

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  Clock::time_point start_, shown_;
  bool terminal_;
  bool drawn_ = false;
};

}  // namespace delos::cli
