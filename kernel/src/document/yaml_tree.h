// YAML as a tree of texts with positions: nothing is guessed about what a text means.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/findings.h"

namespace delos {

/// A value of a YAML text. Aliases are copies of what they stand for.
struct Node {
  enum class Kind { null, scalar, list, map };
  /// The key of a map's entry.
  struct Key {
    std::string text;
    Mark mark;
  };

  Kind kind = Kind::null;
  Mark mark;
  std::string text;         ///< of a scalar, unquoted
  std::vector<Node> items;  ///< members of a list, values of a map
  std::vector<Key> keys;    ///< of a map, one an item; may repeat
  bool quoted = false;      ///< a scalar whose text begins a column after its mark

  /// The first value of that key, null where there is none or this isn't a map.
  [[nodiscard]] const Node* find(std::string_view key) const;
  [[nodiscard]] Node* find(std::string_view key);
};

/// Where a character of a scalar's text stands, counted from 0.
[[nodiscard]] inline Mark mark_of(const Node& text, std::size_t character) {
  Mark mark = text.mark;
  if (mark.line > 0) mark.column += static_cast<int>(character) + (text.quoted ? 1 : 0);
  return mark;
}

/// What messages call member `index` of a list: its `name` where it has one.
[[nodiscard]] std::string member_name(const Node& member, std::size_t index);

/// Parse one YAML document.
/// @param source  its number in `findings`
/// @param located false for texts without lines, whose marks stay at 0:0
/// @returns nullopt, with a finding, where it isn't one YAML document.
[[nodiscard]] std::optional<Node> parse_yaml(std::string_view text, int source,
                                             bool located, Findings& findings);

}  // namespace delos
