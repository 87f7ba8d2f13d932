#include "status_line.h"

#include <unistd.h>

#include <iostream>
#include <utility>

namespace delos::cli {

StatusLine::StatusLine(std::string label)
    : label_(std::move(label)),
      start_(Clock::now()),
      shown_(start_),
      terminal_(isatty(STDERR_FILENO) == 1) {}

void StatusLine::update(const std::string& text) {
  const auto now = Clock::now();
  const auto pause = terminal_ ? Clock::duration(std::chrono::milliseconds(200))
                               : Clock::duration(std::chrono::seconds(5));
  if (now - start_ < std::chrono::seconds(1) || (drawn_ && now - shown_ < pause))
    return;
  drawn_ = true;
  shown_ = now;
  std::cerr << (terminal_ ? "\r\033[K" : "") << label_ << ": " << text
            << (terminal_ ? "" : "\n") << std::flush;
}

void StatusLine::clear() {
  if (drawn_ && terminal_) std::cerr << "\r\033[K";
}

}  // namespace delos::cli
