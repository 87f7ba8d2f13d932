// What a value of a text may look like, as data: readers keep to it, and schemas, forms
// and manuals are made of it.
#pragma once

#include <limits>
#include <vector>

namespace delos {

/// From where to where a number may be.
struct Bounds {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  bool above = false;    ///< `least` itself is left out
  bool below = false;    ///< `greatest` itself is left out
  const char* why = "";  ///< what messages add: "; a device that is off is left out"

  [[nodiscard]] constexpr bool hold(double x) const {
    return (above ? x > least : x >= least) && (below ? x < greatest : x <= greatest);
  }
};

constexpr Bounds above(double least, const char* why = "") {
  return {.least = least, .above = true, .why = why};
}
constexpr Bounds at_least(double least, const char* why = "") {
  return {.least = least, .why = why};
}
constexpr Bounds between(double least, double greatest, const char* why = "") {
  return {.least = least, .greatest = greatest, .why = why};
}

struct KeyShape;

/// What a value may look like. Members that a kind doesn't name have no meaning for it.
/// What a value is made of is a function, so that tables in different files can be of
/// each other's and all of it is known before the program runs.
struct Shape {
  enum class Kind {
    number,      ///< of `unit` within `bounds`
    integer,     ///< within `bounds`
    numbers,     ///< a list of `least` to `most` numbers of `unit` within `bounds`
    text,        ///< any words: a file, a formula, a path
    name,        ///< words that a path can hold
    choice,      ///< one of `words()`
    list,        ///< `least` to `most` times `item()`
    map,         ///< the keys `keys()`
    table,       ///< names of one's own, each with an `item()`
    parameters,  ///< numbers and words by the names of a plugin's parameters
    either,      ///< one of `forms()`
    nothing,     ///< no value
    anything,    ///< what some other key may look like
  };
  static constexpr int kMany = std::numeric_limits<int>::max();

  Kind kind = Kind::text;
  /// SI: "m", "1"; null: one that only the rest of the text tells.
  const char* unit = "1";
  Bounds bounds = {};
  int least = 0, most = kMany;
  std::vector<const char*> (*words)() = nullptr;
  Shape (*item)() = nullptr;
  std::vector<KeyShape> (*keys)() = nullptr;
  std::vector<Shape> (*forms)() = nullptr;
};

/// A key of a mapping.
struct KeyShape {
  const char* name;
  bool required;
  const char* help;  ///< a phrase: what the value is
  Shape shape;
};

namespace shapes {

constexpr Shape number(const char* unit, Bounds bounds = {}) {
  return {.kind = Shape::Kind::number, .unit = unit, .bounds = bounds};
}
constexpr Shape integer(int least, int greatest = Shape::kMany) {
  return {.kind = Shape::Kind::integer, .bounds = between(least, greatest)};
}
constexpr Shape numbers(const char* unit, int least, int most = Shape::kMany,
                        Bounds bounds = {}) {
  return {.kind = Shape::Kind::numbers,
          .unit = unit,
          .bounds = bounds,
          .least = least,
          .most = most};
}
/// [x, y, z]
constexpr Shape vector(const char* unit) { return numbers(unit, 3, 3); }
constexpr Shape text() { return {.kind = Shape::Kind::text}; }
constexpr Shape name() { return {.kind = Shape::Kind::name}; }
constexpr Shape parameters() { return {.kind = Shape::Kind::parameters}; }
constexpr Shape list(Shape (*item)(), int least = 0, int most = Shape::kMany) {
  return {.kind = Shape::Kind::list, .least = least, .most = most, .item = item};
}
constexpr Shape table(Shape (*item)()) {
  return {.kind = Shape::Kind::table, .item = item};
}
constexpr Shape either(std::vector<Shape> (*forms)()) {
  return {.kind = Shape::Kind::either, .forms = forms};
}
/// [[x, y, z], …], metres
constexpr Shape points() {
  return list([] { return vector("m"); }, 1);
}
/// A list of rows.
constexpr Shape matrix(const char* unit) {
  Shape rows = {.kind = Shape::Kind::list, .unit = unit, .least = 1};
  rows.item =
      unit ? [] { return numbers("1", 1); } : [] { return numbers(nullptr, 1); };
  return rows;
}
/// A name or a list of them.
constexpr Shape names() {
  return either([] { return std::vector{text(), list([] { return text(); })}; });
}

constexpr Shape nothing() { return {.kind = Shape::Kind::nothing}; }
constexpr Shape anything() { return {.kind = Shape::Kind::anything}; }

constexpr Shape choice_of(std::vector<const char*> (*words)()) {
  return {.kind = Shape::Kind::choice, .words = words};
}
/// One of the first members of a table of pairs.
template <auto& kWords>
constexpr Shape choice() {
  return choice_of([] {
    std::vector<const char*> words;
    for (const auto& [word, value] : kWords) words.push_back(word);
    return words;
  });
}

constexpr Shape map(std::vector<KeyShape> (*keys)()) {
  return {.kind = Shape::Kind::map, .keys = keys};
}
/// The keys of a table.
template <auto& kKeys>
std::vector<KeyShape> keys_of() {
  std::vector<KeyShape> keys;
  for (const auto& key : kKeys) keys.push_back(key.described());
  return keys;
}
template <auto& kKeys>
constexpr Shape map() {
  return map(keys_of<kKeys>);
}

}  // namespace shapes

}  // namespace delos
