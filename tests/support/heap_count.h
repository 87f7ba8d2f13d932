// Counts what a piece of code takes from the heap, in libraries too.
#pragma once

#include <cstddef>
#include <functional>

namespace delos::test {

/// Number of heap allocations that the calling thread makes while `work` runs.
std::size_t allocations(const std::function<void()>& work);

}  // namespace delos::test
