#include "session/job.h"

#include <exception>
#include <utility>

namespace delos::session {

const char* to_string(Phase phase) {
  switch (phase) {
    case Phase::waiting:
      return "waiting";
    case Phase::running:
      return "running";
    case Phase::paused:
      return "paused";
    case Phase::ended:
      return "ended";
    case Phase::failed:
      return "failed";
  }
  return "";
}

void Job::work() {
  for (;;) {
    {
      const std::lock_guard lock(mutex_);
      if (phase_ != Phase::waiting) return;  // paused before its turn came
      phase_ = Phase::running;
      stop_ = false;
      message_.clear();
      tell();
    }
    bool ended = false;
    std::string problem;
    try {
      ended = advance();
    } catch (const std::exception& error) {
      problem = error.what();
    }
    const std::lock_guard lock(mutex_);
    // Stopped early, a search may have nothing to show, and says so.
    if (!stop_) message_ = std::move(problem);
    phase_ = !message_.empty() ? Phase::failed
             : ended           ? Phase::ended
             : wanted_         ? Phase::waiting
                               : Phase::paused;
    tell();
    if (phase_ != Phase::waiting) return;
  }
}

void Job::pause() {
  const std::lock_guard lock(mutex_);
  give_over();
  if (phase_ == Phase::waiting) phase_ = Phase::paused;
  tell();
}

void Job::give_over() {
  wanted_ = false;
  stop_ = true;
}

bool Job::resume() {
  const std::lock_guard lock(mutex_);
  wanted_ = true;
  if (phase_ == Phase::running || phase_ == Phase::waiting) return false;
  phase_ = Phase::waiting;
  tell();
  return true;
}

Phase Job::phase() const {
  const std::lock_guard lock(mutex_);
  return phase_;
}

Json Job::head(const char* kind) const {
  return {{"kind", kind}, {"phase", to_string(phase_)}, {"message", message_}};
}

}  // namespace delos::session
