#include "cover/incidence.h"

namespace delos {
namespace {

/// Lists written to side by side, about as many as the pages whose addresses processors
/// remember.
constexpr std::int64_t kAtHand = 1024;

}  // namespace

Lists transposed(const Lists& lists, int count) {
  Lists out;
  out.start.assign(static_cast<std::size_t>(count) + 1, 0);
  for (const std::int32_t item : lists.items) ++out.start[item + 1];
  for (std::size_t i = 1; i < out.start.size(); ++i) out.start[i] += out.start[i - 1];
  out.items.resize(lists.items.size());
  std::vector<std::int64_t> next(out.start.begin(), out.start.end() - 1);
  // Some items at a time, so that the lists that are written to stay at hand.
  std::vector<std::int64_t> read(lists.start.begin(), lists.start.end() - 1);
  for (std::int64_t end = kAtHand; end < count + kAtHand; end += kAtHand)
    for (int j = 0; j < lists.size(); ++j) {
      std::int64_t k = read[j];
      for (; k < lists.start[j + 1] && lists.items[k] < end; ++k)
        out.items[next[lists.items[k]]++] = j;
      read[j] = k;
    }
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
