// Long work while Python's signals and callbacks stay alive.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <future>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

namespace delos::python {

namespace py = pybind11;

/// How far work is.
struct Reached {
  std::size_t done = 0, of = 0;
  std::optional<double> best;  ///< of searches
};

/// What work looks at and tells, from any of its threads.
class Watch {
 public:
  std::atomic<bool> cancel = false;

  void tell(const Reached& at) {
    const std::lock_guard lock(mutex_);
    reached_ = at;
  }
  /// What was told since the last time it was asked.
  std::optional<Reached> news() {
    const std::lock_guard lock(mutex_);
    return std::exchange(reached_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<Reached> reached_;
};

/// Call `progress` with what was reached; None: nobody asks.
void call_progress(const py::object& progress, const Reached& at);

/// Run work on a thread of its own, without Python's lock, while this one, which has
/// it, looks for Ctrl-C and calls `progress`. Where either raises, the work is
/// cancelled and what was raised goes on.
/// @param work of (Watch&)
template <class Work>
auto stoppable(const py::object& progress, Work&& work) {
  Watch watch;
  auto future = std::async(std::launch::async, [&] { return work(watch); });
  const auto ready = [&](std::chrono::milliseconds patience) {
    const py::gil_scoped_release unlocked;
    return future.wait_for(patience) == std::future_status::ready;
  };
  constexpr std::chrono::milliseconds kLook(20);
  try {
    while (!ready(kLook)) {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (const auto news = watch.news()) call_progress(progress, *news);
    }
    if (const auto news = watch.news()) call_progress(progress, *news);
  } catch (...) {
    watch.cancel = true;
    const py::gil_scoped_release unlocked;
    future.wait();
    throw;
  }
  return future.get();
}

}  // namespace delos::python
