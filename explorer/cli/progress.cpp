#include "progress.h"

#include <unistd.h>

#include <cmath>
#include <iostream>
#include <utility>

namespace delos::cli {
namespace {

constexpr std::chrono::seconds kQuiet{1};
constexpr std::chrono::milliseconds kRedraw{200};
constexpr std::chrono::seconds kLine{5};
constexpr std::size_t kWidth = 30;

}  // namespace

Progress::Progress(std::string label)
    : label_(std::move(label)),
      start_(Clock::now()),
      shown_(start_),
      terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (drawn_ && terminal_) std::cerr << "\r\033[K";
}

void Progress::update(std::size_t done, std::size_t all) {
  const Clock::time_point now = Clock::now();
  if (now - start_ < kQuiet || all == 0) return;
  if (drawn_ && now - shown_ < (terminal_ ? Clock::duration(kRedraw) : kLine)) return;
  drawn_ = true;
  shown_ = now;
  const double part = static_cast<double>(done) / static_cast<double>(all);
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const auto left =
      static_cast<long>(std::ceil(part > 0 ? elapsed / part - elapsed : 0));
  const int percent = static_cast<int>(100 * part);
  if (terminal_) {
    const auto filled = static_cast<std::size_t>(part * kWidth);
    std::cerr << "\r\033[K" << label_ << " [" << std::string(filled, '#')
              << std::string(kWidth - filled, ' ') << "] " << percent << " %, " << left
              << " s left" << std::flush;
  } else {
    std::cerr << label_ << ": " << percent << " %, " << left << " s left\n";
  }
}

}  // namespace delos::cli
