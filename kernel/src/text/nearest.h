// "Did you mean": the known word closest to a mistyped one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace delos {

/// Fewest insertions, deletions, replacements and swaps of neighbours that turn a into
/// b.
///
/// Source: Damerau (1964), CACM 7(3), 171–176, in the form that edits no place twice.
[[nodiscard]] inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Rows i−2, i−1 and i of the table d(i, j) over the prefixes a[0, i) and b[0, j).
  std::vector<std::size_t> before, above, row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
  }
  return row.back();
}

/// The word of `known` that needs the fewest edits, the first one where several do.
/// @returns empty where nothing is close: within two edits or a third of the word, and
///          never more than half of it.
[[nodiscard]] inline std::string nearest(std::string_view word,
                                         std::span<const std::string> known) {
  const std::size_t n = word.size();
  std::size_t allowed = std::min(std::max<std::size_t>(2, n / 3), n / 2);
  std::string best;
  for (const std::string& candidate : known) {
    const std::size_t edits = edit_distance(word, candidate);
    if (edits > allowed || (edits == allowed && !best.empty())) continue;
    best = candidate;
    allowed = edits;
  }
  return best;
}

}  // namespace delos
