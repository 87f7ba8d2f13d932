// The keys of a mapping, declared once: reading, writing, help, suggestions, bounds and
// the schema share them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "delos/document/shape.h"
#include "document/node_text.h"
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
  Shape shape;       ///< what the value may look like
  /// Reads the value into a T; null where another key's reader does it.
  void (*read)(Reader&, const Place&, T&) = nullptr;
  /// The value to write; nullopt where it needn't be written.
  std::optional<Node> (*write)(const T&) = nullptr;

  [[nodiscard]] KeyShape described() const {
    return {name, need == Need::required, help, shape};
  }
};

namespace member_keys {

// What a member's type makes of a place, whose shape says unit and bounds.
inline void read(Reader& reader, const Place& at, double& out) {
  if (const auto number = reader.number(at)) out = *number;
}
inline void read(Reader& reader, const Place& at, std::optional<double>& out) {
  if (const auto number = reader.number(at)) out = number;
}
inline void read(Reader& reader, const Place& at, int& out) {
  if (const auto number = reader.integer(at)) out = *number;
}
inline void read(Reader& reader, const Place& at, std::optional<int>& out) {
  if (const auto number = reader.integer(at)) out = number;
}
inline void read(Reader& reader, const Place& at, std::string& out) {
  const bool name = at.shape()->kind == Shape::Kind::name;
  if (auto text = name ? reader.name(at) : reader.word(at)) out = std::move(*text);
}
inline void read(Reader& reader, const Place& at, Eigen::Vector3d& out) {
  if (const auto vector = reader.vector3(at, at.shape()->unit)) out = *vector;
}

inline Node node_of(double value) { return to_node(value); }
inline Node node_of(int value) { return to_node(value); }
inline Node node_of(const std::string& value) { return to_node(value); }
inline Node node_of(const Eigen::Vector3d& value) { return vector_node(value); }
template <class V>
Node node_of(const std::optional<V>& value) {
  return node_of(*value);
}

}  // namespace member_keys

template <auto kMember>
struct MemberRow;
template <class T, class V, V T::*kMember>
struct MemberRow<kMember> {
  static void read(Reader& reader, const Place& at, T& out) {
    member_keys::read(reader, at, out.*kMember);
  }
  static std::optional<Node> write(const T& value) {
    return member_keys::node_of(value.*kMember);
  }
  static std::optional<Node> write_other(const T& value) {
    if (value.*kMember == T{}.*kMember) return std::nullopt;
    return write(value);
  }
  using Key = delos::Key<T>;
};

/// The key of a member that is always written.
template <auto kMember>
constexpr typename MemberRow<kMember>::Key member_key(const char* name, Need need,
                                                      const char* help, Shape shape) {
  using Row = MemberRow<kMember>;
  return {name, need, help, shape, Row::read, Row::write};
}

/// The key of a member that is written where it is another than a new T's.
template <auto kMember>
constexpr typename MemberRow<kMember>::Key other_key(const char* name, Need need,
                                                     const char* help, Shape shape) {
  using Row = MemberRow<kMember>;
  return {name, need, help, shape, Row::read, Row::write_other};
}

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
      key.read(reader, Place(at, key.name, *value, &key.shape), out);
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
