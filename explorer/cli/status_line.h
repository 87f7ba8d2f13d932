// One line of stderr that says how far something is.
#pragma once

#include <chrono>
#include <string>

namespace delos::cli {

/// Shows nothing in the first second; then a line that is redrawn on a terminal, or
/// written every few seconds elsewhere.
class StatusLine {
 public:
  explicit StatusLine(std::string label);
  void update(const std::string& text);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  Clock::time_point start_, shown_;
  bool terminal_, drawn_ = false;
};

}  // namespace delos::cli
