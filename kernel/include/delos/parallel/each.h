// One loop over things that don't need each other, on several threads.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>

#include "delos/parallel/first_failure.h"

namespace delos {

/// Threads for `asked`; 0: one a core that the program may use.
[[nodiscard]] inline int thread_count(int asked) {
  return asked > 0 ? asked : omp_get_max_threads();
}

/// How a loop runs. Which thread does what differs from run to run; results that are
/// put where they belong don't.
struct LoopOptions {
  int threads = 0;  ///< 0: one a core
  /// Asked before each thing, on any thread. True: no others begin.
  std::function<bool()> stop = {};
  /// Told on the calling thread, after its things, how many are done.
  std::function<void(std::size_t done)> progress = {};
  std::size_t grain = 1;  ///< things that a thread takes at a time
};

/// Call work(i) once for every i < count, where `make()` makes the work of each thread
/// with the memory that is its own.
/// @returns whether all were done
/// @throws whatever `make`, a work, `stop` or `progress` throws first; no others begin
///         then
template <class Make>
bool each_with(std::size_t count, const LoopOptions& options, Make&& make) {
  FirstFailure failure;
  std::atomic<bool> stopped = false;
  std::atomic<std::size_t> done = 0;
  const auto grain = static_cast<int>(options.grain);
  // More threads than shares would only make memory of their own.
  const std::size_t shares = count / options.grain + 1;
  const int threads = static_cast<int>(
      std::min(static_cast<std::size_t>(thread_count(options.threads)), shares));
#pragma omp parallel num_threads(threads)
  {
    std::optional<decltype(make())> work;
    if (!failure.guard([&] { work.emplace(make()); })) stopped = true;
#pragma omp for schedule(dynamic, grain)
    for (std::size_t i = 0; i < count; ++i) {
      if (stopped.load(std::memory_order_relaxed)) continue;
      const bool whole = failure.guard([&] {
        if (options.stop && options.stop()) {
          stopped = true;
          return;
        }
        (*work)(i);
        const std::size_t so_far = ++done;
        if (options.progress && omp_get_thread_num() == 0) options.progress(so_far);
      });
      if (!whole) stopped = true;
    }
  }
  failure.rethrow();
  return done == count;
}

/// The same where threads need no memory of their own.
template <class Work>
bool each(std::size_t count, const LoopOptions& options, Work&& work) {
  return each_with(count, options, [&] { return [&](std::size_t i) { work(i); }; });
}

}  // namespace delos
