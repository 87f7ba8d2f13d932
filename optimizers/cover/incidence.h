// Which candidate sees which sample, in lists both ways.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace delos {

/// Lists of numbers one after the other.
struct Lists {
  std::vector<std::int64_t> start = {0};
  std::vector<std::int32_t> items;

  [[nodiscard]] int size() const { return static_cast<int>(start.size()) - 1; }
  [[nodiscard]] std::span<const std::int32_t> operator[](int i) const {
    return {items.data() + start[i], items.data() + start[i + 1]};
  }
};

/// The lists of who has an item, of `count` items, in rising order.
/// @pre lists rise
[[nodiscard]] Lists transposed(const Lists& lists, int count);

/// The lists of those that `keep` (old numbers, rising), of items renumbered; −1: gone.
[[nodiscard]] Lists selected(const Lists& lists, const std::vector<int>& keep,
                             const std::vector<int>& renumber);

}  // namespace delos
