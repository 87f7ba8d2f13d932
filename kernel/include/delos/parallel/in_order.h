// A loop whose results are added up in the order of the things.
#pragma once

#include <omp.h>

#include <cstddef>
#include <memory>

#include "delos/parallel/each.h"

namespace delos {

/// Call work(i) for every i in [first, end), where `make()` makes the work of each
/// thread, and then add(i, work) one after the other in the order of i: sums are of the
/// same bits for any number of threads, and none is kept longer than until its turn.
/// @param threads 0: one a core
/// @throws whatever is thrown first; nothing behind it is added
template <class Make, class Add>
void each_in_order(std::size_t first, std::size_t end, int threads, Make&& make,
                   Add&& add) {
  FirstFailure failure;
  bool whole = true;  // up to the one whose turn it is
#pragma omp parallel num_threads(thread_count(threads))
  {
    using Work = decltype(make());
    std::unique_ptr<Work> work;  // which needn't be able to move
    failure.guard([&] { work.reset(new Work(make())); });
#pragma omp for ordered schedule(static, 1)
    for (std::size_t i = first; i < end; ++i) {
      const bool done = work && failure.guard([&] { (*work)(i); });
#pragma omp ordered
      {
        whole = whole && done && failure.guard([&] { add(i, *work); });
      }
    }
  }
  failure.rethrow();
}

}  // namespace delos
