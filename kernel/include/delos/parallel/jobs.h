// Jobs that take long, on threads of their own.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "delos/parallel/first_failure.h"

namespace delos {

/// Threads for `asked`; 0: one a core of the machine.
[[nodiscard]] inline std::size_t worker_count(int asked) {
  return asked > 0 ? static_cast<std::size_t>(asked)
                   : std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

/// Call work(job, worker) once for every job < count, each worker < workers on a thread
/// of its own, which may use loops over many things itself. Jobs begin in their order.
/// @throws whatever a job throws first; no others begin then
template <class Work>
void each_job(std::size_t count, std::size_t workers, Work&& work) {
  std::atomic<std::size_t> next = 0;
  FirstFailure failure;
  const auto run = [&](std::size_t worker) {
    for (std::size_t job = next++; job < count; job = next++)
      if (!failure.guard([&] { work(job, worker); })) next = count;
  };
  std::vector<std::thread> others;
  for (std::size_t w = 1; w < std::min(workers, count); ++w)
    others.emplace_back(run, w);
  run(0);
  for (std::thread& t : others) t.join();
  failure.rethrow();
}

}  // namespace delos
