#include "cover/incidence.h"

namespace delos {

Lists transposed(const Lists& lists, int count) {
  Lists out;
  out.start.assign(static_cast<std::size_t>(count) + 1, 0);
  for (const std::int32_t item : lists.items) ++out.start[item + 1];
  for (std::size_t i = 1; i < out.start.size(); ++i) out.start[i] += out.start[i - 1];
  out.items.resize(lists.items.size());
  std::vector<std::int64_t> next(out.start.begin(), out.start.end() - 1);
  for (int j = 0; j < lists.size(); ++j)
    for (const std::int32_t item : lists[j]) out.items[next[item]++] = j;
  return out;
}

Lists selected(const Lists& lists, const std::vector<int>& keep,
               const std::vector<int>& renumber) {
  Lists out;
  out.start.reserve(keep.size() + 1);
  for (const int j : keep) {
    for (const std::int32_t item : lists[j])
      if (renumber[item] >= 0) out.items.push_back(renumber[item]);
    out.start.push_back(static_cast<std::int64_t>(out.items.size()));
  }
  return out;
}

}  // namespace delos
