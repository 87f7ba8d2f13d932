#include "document/reader.h"

#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

#include "delos/text/number_text.h"
#include "delos/text/numbers.h"
#include "delos/text/units.h"
#include "text/nearest.h"

namespace delos {
namespace {

const char* kind_name(Node::Kind kind) {
  switch (kind) {
    case Node::Kind::null:
      return "nothing";
    case Node::Kind::scalar:
      return "a single value";
    case Node::Kind::list:
      return "a list";
    case Node::Kind::map:
      return "a mapping";
  }
  return "";
}

/// "0", "180 deg"
std::string bound_text(double bound, std::string_view unit) {
  return unit == "rad" && bound != 0 ? shortest(bound * 180 / std::numbers::pi) + " deg"
                                     : shortest(bound);
}

/// "must be above 0 and at most 180 deg"
std::string text_of(const Bounds& b, std::string_view unit) {
  const std::string least = bound_text(b.least, unit),
                    greatest = bound_text(b.greatest, unit);
  const bool from = std::isfinite(b.least), to = std::isfinite(b.greatest);
  if (from && to && !b.above && !b.below)
    return "must be from " + least + " to " + greatest;
  if (from && !to && !b.above) return "must not be below " + least;
  std::string text = "must be";
  if (from) text += (b.above ? " above " : " at least ") + least;
  if (to)
    text += (from ? " and" : "") + std::string(b.below ? " below " : " at most ") +
            greatest;
  return text;
}

}  // namespace

std::string Place::path() const {
  if (!parent_) return {};
  return parent_->path(segment_);
}

std::string Place::path(std::string_view segment) const {
  std::string text = path();
  if (!text.empty()) text += '.';
  return text.append(segment);
}

std::string Reader::file_name(const Place& at, const std::string& written) const {
  const auto base = folder_of_source.find(at.node().mark.source);
  if (base == folder_of_source.end()) return written;
  return (base->second / written).lexically_normal().string();
}

void Reader::error(const Place& at, std::string problem) {
  findings.error(at.node().mark, at.path(), std::move(problem));
}

void Reader::warning(const Place& at, std::string problem) {
  findings.warning(at.node().mark, at.path(), std::move(problem));
}

void Reader::error_within(const Place& at, Mark mark, std::string_view segment,
                          std::string problem) {
  findings.error(mark, at.path(segment), std::move(problem));
}

bool Reader::expect(const Place& at, Node::Kind kind, std::string_view what) {
  if (at.node().kind == kind) return true;
  error(at, "expected " + std::string(what) + ", not " + kind_name(at.node().kind));
  return false;
}

std::optional<double> Reader::number(const Place& at, std::string_view unit) {
  if (!expect(at, Node::Kind::scalar, "a number")) return std::nullopt;
  auto parsed = parse_quantity(at.node().text, unit);
  if (const auto* value = std::get_if<double>(&parsed)) return *value;
  error(at, std::get<std::string>(parsed));
  return std::nullopt;
}

std::optional<double> Reader::number(const Place& at) {
  const Shape& shape = *at.shape();
  const std::string_view unit = shape.unit;
  const auto value = unit == "rad" ? angle(at) : number(at, unit);
  if (!value || !within(at, *value, shape.bounds, unit)) return std::nullopt;
  return value;
}

bool Reader::within(const Place& at, double value, const Bounds& bounds,
                    std::string_view unit) {
  if (bounds.hold(value)) return true;
  error(at, text_of(bounds, unit) + bounds.why);
  return false;
}

std::optional<double> Reader::angle(const Place& at) {
  const auto value = number(at, "rad");
  const std::string& text = at.node().text;
  const bool bare = scan_number(text).length == text.size();
  if (value && bare && std::abs(*value) > 2 * std::numbers::pi)
    warning(at, "is in radians, and more than a full turn; do you mean '" + text +
                    " deg'?");
  return value;
}

std::optional<int> Reader::integer(const Place& at, int least, int greatest) {
  if (!expect(at, Node::Kind::scalar, "a whole number")) return std::nullopt;
  const std::string& text = at.node().text;
  const NumberText number = scan_number(text);
  if (!number.problem.empty() || number.length != text.size() || text.empty() ||
      number.value != std::floor(number.value)) {
    error(at, "expected a whole number, not '" + text + '\'');
    return std::nullopt;
  }
  if (number.value < least || number.value > greatest) {
    error(at, text + " is outside " + grouped(least) + " to " + grouped(greatest));
    return std::nullopt;
  }
  return static_cast<int>(number.value);
}

std::optional<int> Reader::integer(const Place& at) {
  const Bounds& bounds = at.shape()->bounds;
  return integer(at, static_cast<int>(bounds.least), static_cast<int>(bounds.greatest));
}

std::optional<std::string> Reader::word(const Place& at) {
  if (!expect(at, Node::Kind::scalar, "a word")) return std::nullopt;
  return at.node().text;
}

std::optional<std::string> Reader::name(const Place& at) {
  auto text = word(at);
  if (!text) return std::nullopt;
  const auto refuse = [&](const char* problem) {
    error(at, '\'' + *text + "' " + problem);
    return std::nullopt;
  };
  if (text->empty()) return refuse("is empty; a name has at least one character");
  if (text->front() == ' ' || text->back() == ' ')
    return refuse("begins or ends with a blank");
  for (const char c : *text) {
    if (c == '.' || c == '=')
      return refuse("holds '.' or '=', which separate the parts of a path; use '_'");
  }
  if (has_control(*text)) return refuse("holds a control character");
  return text;
}

std::string Reader::key_name(const Place& map, std::size_t i) {
  const Node::Key& key = map.node().keys[i];
  const Node node{Node::Kind::scalar, key.mark, key.text, {}, {}};
  name(Place(map, key.text, node));
  return key.text;
}

std::optional<Eigen::Vector3d> Reader::vector3(
    const Place& at, std::string_view unit,
    const std::array<const char*, 3>& components) {
  const auto& [a, b, c] = components;
  const std::string form =
      std::string("three numbers [") + a + ", " + b + ", " + c + ']';
  if (!expect(at, Node::Kind::list, form)) return std::nullopt;
  const auto& items = at.node().items;
  if (items.size() != 3) {
    error(at, "expected " + form + ", not " + counted(items.size(), "member"));
    return std::nullopt;
  }
  Eigen::Vector3d vector;
  bool good = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Place item(at, components[i], items[i]);
    const auto value = unit == "rad" ? angle(item) : number(item, unit);
    if (value) vector[static_cast<Eigen::Index>(i)] = *value;
    good = good && value;
  }
  if (!good) return std::nullopt;
  return vector;
}

std::optional<std::vector<Eigen::Vector3d>> Reader::vectors3(
    const Place& at, std::string_view unit,
    const std::array<const char*, 3>& components) {
  if (!expect(at, Node::Kind::list, "a list of lists")) return std::nullopt;
  const auto& items = at.node().items;
  if (items.empty()) {
    error(at, "the list is empty; give at least one");
    return std::nullopt;
  }
  std::vector<Eigen::Vector3d> vectors;
  vectors.reserve(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    if (auto v = vector3(Place(at, std::to_string(i), items[i]), unit, components))
      vectors.push_back(*v);
  if (vectors.size() != items.size()) return std::nullopt;
  return vectors;
}

std::optional<Eigen::MatrixXd> Reader::matrix(
    const Place& at, const std::function<std::string(int, int)>& unit) {
  if (!expect(at, Node::Kind::list, "a list of rows")) return std::nullopt;
  const auto& rows = at.node().items;
  if (rows.empty()) {
    error(at, "the matrix is empty");
    return std::nullopt;
  }
  const std::size_t before = findings.errors();
  const std::size_t columns = rows[0].items.size();
  Eigen::MatrixXd m(rows.size(), columns);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Place row(at, std::to_string(i), rows[i]);
    if (!expect(row, Node::Kind::list, "a row of numbers")) continue;
    if (rows[i].items.empty() || rows[i].items.size() != columns) {
      error(row, "the row has " + counted(rows[i].items.size(), "number") +
                     (i == 0 ? "" : ", the first has " + std::to_string(columns)));
      continue;
    }
    for (std::size_t j = 0; j < columns; ++j) {
      const auto value = number(Place(row, std::to_string(j), rows[i].items[j]),
                                unit(static_cast<int>(i), static_cast<int>(j)));
      if (value) m(static_cast<int>(i), static_cast<int>(j)) = *value;
    }
  }
  if (findings.errors() != before) return std::nullopt;
  return m;
}

std::optional<std::size_t> Reader::choice(const Place& at,
                                          std::span<const std::string> known) {
  const auto text = word(at);
  if (!text) return std::nullopt;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (known[i] == *text) return i;
  const std::string meant = nearest(*text, known);
  error(at, '\'' + *text + "' is none of " + joined(known) +
                (meant.empty() ? "" : "; did you mean '" + meant + "'?"));
  return std::nullopt;
}

void read_vector(Reader& reader, const Place& at, Eigen::Vector3d& out) {
  if (const auto v = reader.vector3(at, "m")) out = *v;
}

std::string suggestion(std::string_view word, std::span<const std::string> known) {
  const std::string meant = nearest(word, known);
  if (!meant.empty()) return "; did you mean '" + meant + "'?";
  return known.empty() ? "" : "; known: " + joined(known);
}

void check_duplicate_keys(Reader& reader, const Place& at) {
  const Node& node = at.node();
  std::map<std::string_view, int> first;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const bool map = node.kind == Node::Kind::map;
    if (map) {
      const auto [known, is_new] =
          first.emplace(node.keys[i].text, node.keys[i].mark.line);
      if (!is_new)
        reader.error_within(
            at, node.keys[i].mark, node.keys[i].text,
            "duplicate key; the first is on line " + std::to_string(known->second));
    }
    if (node.items[i].items.empty()) continue;
    check_duplicate_keys(
        reader, Place(at, map ? node.keys[i].text : member_name(node.items[i], i),
                      node.items[i]));
  }
}

}  // namespace delos
