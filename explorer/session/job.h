// Something that is worked on for long beside what is asked of a design: a search.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "session/json.h"

namespace delos::session {

/// Where a job is.
enum class Phase {
  waiting,  ///< for a thread
  running,
  paused,  ///< asked to stop, or its time is over; goes on where it was
  ended,
  failed,  ///< see message()
};
[[nodiscard]] const char* to_string(Phase phase);

/// What somebody who follows a job has heard of it.
struct Heard {
  std::size_t incumbents = 0;  ///< so many of them
  std::size_t evaluations = 0;
  int round = 0;
};

/// Done on one thread, asked about and stopped from others.
class Job {
 public:
  Job() = default;
  virtual ~Job() = default;
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Work until it ends or is to stop. Called once after each resume() that says so,
  /// and once at first.
  void work();
  /// Ask it to stop soon.
  void pause();
  /// @returns whether work() is to be called
  [[nodiscard]] bool resume();

  [[nodiscard]] Phase phase() const;
  /// Grows whenever there is something to tell.
  [[nodiscard]] std::uint64_t news() const { return news_; }
  /// What it found, without what was heard.
  [[nodiscard]] virtual Json json(const Heard& heard) const = 0;

 protected:
  /// Work until it ends. @returns false where it was stopped before
  /// @throws std::exception it can't be done
  virtual bool advance() = 0;
  /// What json() begins with: kind, phase, message. @pre the mutex is held
  [[nodiscard]] Json head(const char* kind) const;
  void tell() { ++news_; }
  /// Stop, and don't go on. @pre the mutex is held
  void give_over();
  [[nodiscard]] bool wanted() const { return wanted_; }

  mutable std::mutex mutex_;        ///< of what is told
  std::atomic<bool> stop_ = false;  ///< looked at by what works

 private:
  std::atomic<std::uint64_t> news_ = 1;
  Phase phase_ = Phase::waiting;
  std::atomic<bool> wanted_ = true;
  std::string message_;
};

}  // namespace delos::session
