#include "session/parameter_shape.h"

#include <cmath>
#include <sstream>

namespace delos::session {

bool has_default(const ParamSpec& row) {
  return row.kind == ParamKind::number ? !std::isnan(row.initial) : row.text != nullptr;
}

std::vector<std::string> words_of(const ParamSpec& row) {
  std::vector<std::string> words;
  std::istringstream choices(row.choices ? row.choices : "");
  for (std::string word; std::getline(choices, word, '|');) words.push_back(word);
  return words;
}

Shape shape_of(const ParamSpec& row) {
  const Bounds bounds = delos::between(row.lower, row.upper);
  const int length = static_cast<int>(row.length);
  switch (row.kind) {
    case ParamKind::number:
      return shapes::number(row.unit, bounds);
    case ParamKind::vector:
      return length > 0 ? shapes::numbers(row.unit, length, length, bounds)
                        : shapes::numbers(row.unit, 0, Shape::kMany, bounds);
    case ParamKind::matrix:
      // One number a row may stand alone.
      return shapes::either([] {
        return std::vector{shapes::matrix("1"), shapes::numbers("1", 1)};
      });
    case ParamKind::choice:
    case ParamKind::text:
      return shapes::text();
  }
  return shapes::text();
}

}  // namespace delos::session
