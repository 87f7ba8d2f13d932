// The searches of a visitor: the one at work, and those before.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>

#include "session/job.h"
#include "session/scene_changes.h"

namespace delos::server {

/// A search, and what the design has of it.
struct Searched {
  int number = 0;
  std::shared_ptr<session::Job> job;
  session::VariableValues before;  ///< of the design when it began
  /// Grows when what was found is kept: what comes after is a step of its own.
  int kept = 0;
  /// History::steps() after the design took over what was found, where it did.
  std::size_t step = 0;

  /// What all changes have in common that are one step.
  [[nodiscard]] std::string gesture() const {
    return "search " + std::to_string(number) + '.' + std::to_string(kept);
  }
};

/// What a watcher has heard.
struct Watched {
  int number = 0;
  std::uint64_t news = 0;
  session::Heard heard;
};

/// Changed on the visitor's strand only; asked from other threads too.
class Searches {
 public:
  static constexpr std::size_t kMost = 8;  ///< the oldest is forgotten

  /// It takes the place of the one at work, which stops.
  Searched& begin(std::shared_ptr<session::Job> job, session::VariableValues before);
  /// The newest; null where there is none.
  [[nodiscard]] Searched* now();
  /// @returns null where there is none of that number
  [[nodiscard]] Searched* find(int number);
  [[nodiscard]] const std::deque<Searched>& all() const { return all_; }

  /// The newest job. From any thread.
  [[nodiscard]] std::shared_ptr<session::Job> job() const;
  /// What there is to tell of it that wasn't; nullopt: nothing. From any thread.
  [[nodiscard]] std::optional<session::Json> news(Watched& watched) const;

 private:
  mutable std::mutex mutex_;
  std::deque<Searched> all_;  // oldest first
  int count_ = 0;
};

/// {search: number, …} of all that a job has to tell, or of what wasn't heard.
[[nodiscard]] session::Json searched_json(int number, const session::Job& job,
                                          const session::Heard& heard = {});

}  // namespace delos::server
