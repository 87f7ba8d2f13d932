#include "simulation/tally_bytes.h"

#include <cstring>
#include <type_traits>

namespace delos {
namespace {

/// Visits the numbers of a tally in an order of its own: visit(number) and
/// visit(numbers, how many).
template <class AnyTally, class Visit>
void each_number(AnyTally& t, Visit&& visit) {
  for (auto* count : {&t.runs, &t.tracked, &t.lost, &t.coasting, &t.dropped})
    visit(count, 1);
  visit(&t.longest_gap, 1);
  visit(&t.perfect, 1);
  const auto all = [&](auto& matrix) { visit(matrix.data(), matrix.size()); };
  for (auto& i : t.instants) {
    for (auto* vector : {&i.error, &i.square, &i.filter}) all(*vector);
    all(i.at);
    all(i.information);
    for (auto* sum : {&i.nees, &i.nis}) visit(sum, 1);
    for (auto* count : {&i.nis_rows, &i.seen}) visit(count, 1);
  }
  for (auto& l : t.looks)
    for (auto* matrix : {&l.sum, &l.squares, &l.filter}) all(*matrix);
}

}  // namespace

std::string bytes_of(const Tally& tally) {
  std::string bytes;
  each_number(tally, [&](const auto* from, auto count) {
    bytes.append(reinterpret_cast<const char*>(from),
                 sizeof(*from) * static_cast<std::size_t>(count));
  });
  return bytes;
}

bool read_bytes(std::string_view bytes, Tally& tally) {
  bool fits = true;
  each_number(tally, [&](auto* to, auto count) {
    using Number = std::remove_pointer_t<decltype(to)>;
    const std::size_t size = sizeof(Number) * static_cast<std::size_t>(count);
    if (!fits || bytes.size() < size) {
      fits = false;
      return;
    }
    // A bool is nothing but 0 or 1.
    if constexpr (std::is_same_v<Number, bool>)
      *to = bytes.front() != 0;
    else
      std::memcpy(to, bytes.data(), size);
    bytes.remove_prefix(size);
  });
  return fits && bytes.empty();
}

}  // namespace delos
