// Exceptions out of parallel loops.
#pragma once

#include <exception>
#include <mutex>
#include <utility>

namespace delos {

/// Keeps the first exception that a loop's body throws on any thread, for after the
/// loop.
class FirstFailure {
 public:
  /// @returns whether the body came to its end
  template <class Body>
  bool guard(Body&& body) {
    try {
      std::forward<Body>(body)();
      return true;
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!first_) first_ = std::current_exception();
      return false;
    }
  }
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr first_;
};

}  // namespace delos
