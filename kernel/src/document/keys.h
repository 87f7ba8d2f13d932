// The keys of a mapping, declared once: reading, writing, help and suggestions share
// them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "document/reader.h"

namespace delos {

enum class Need {
  optional,
  required,
};

/// One key of a mapping that describes a T.
template <class T>
struct Key {
  const char* name;
  Need need;
  const char* help;  ///< a phrase: what the value is
  /// Reads the value into a T; null where another key's reader does it.
  void (*read)(Reader&, const Place&, T&) = nullptr;
  /// The value to write; nullopt where it needn't be written.
  std::optional<Node> (*write)(const T&) = nullptr;
};

/// Two tables as one.
template <class T, std::size_t M, std::size_t N>
constexpr std::array<Key<T>, M + N> concat(const std::array<Key<T>, M>& first,
                                           const std::array<Key<T>, N>& second) {
  std::array<Key<T>, M + N> both{};
  for (std::size_t i = 0; i < M; ++i) both[i] = first[i];
  for (std::size_t i = 0; i < N; ++i) both[M + i] = second[i];
  return both;
}

/// Read a mapping, key by key in the order of the table, whatever the text's order is.
/// Unknown, missing and empty keys are found here.
/// @returns false where it isn't a mapping.
template <class T, std::size_t N>
bool read_map(Reader& reader, const Place& at, const std::array<Key<T>, N>& keys,
              T& out) {
  const Node& node = at.node();
  if (!reader.expect(at, Node::Kind::map, "a mapping")) return false;

  const auto declared = [&](const std::string& name) {
    for (const Key<T>& key : keys)
      if (name == key.name) return true;
    return false;
  };
  for (const Node::Key& key : node.keys) {
    if (declared(key.text)) continue;
    std::array<std::string, N> known;
    for (std::size_t i = 0; i < N; ++i) known[i] = keys[i].name;
    reader.error_within(at, key.mark, key.text,
                        "unknown key" + suggestion(key.text, known));
  }

  for (const Key<T>& key : keys) {
    const Node* value = node.find(key.name);
    if (!value) {
      if (key.need == Need::required)
        reader.error_within(at, node.mark, key.name,
                            std::string("missing: ") + key.help);
    } else if (value->kind == Node::Kind::null) {
      reader.error_within(at, value->mark, key.name,
                          std::string("no value is given: ") + key.help);
    } else if (key.read) {
      key.read(reader, Place(at, key.name, *value), out);
    }
  }
  return true;
}

/// The mapping that read_map() reads as the same T.
template <class T, std::size_t N>
Node write_map(const std::array<Key<T>, N>& keys, const T& value) {
  Node map;
  map.kind = Node::Kind::map;
  for (const Key<T>& key : keys) {
    if (!key.write) continue;
    if (auto node = key.write(value)) {
      map.keys.push_back({key.name, {}});
      map.items.push_back(std::move(*node));
    }
  }
  return map;
}

}  // namespace delos
