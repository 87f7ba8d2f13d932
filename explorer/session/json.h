// Numbers and matrices as the contract's JSON writes them.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <nlohmann/json.hpp>

namespace delos::session {

using Json = nlohmann::ordered_json;

/// A number; null where it isn't finite, since JSON has no infinity.
inline Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

/// A list of numbers.
template <class Vector>
Json numbers(const Vector& v) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) list.push_back(number(v(i)));
  return list;
}

/// A list of rows.
template <class Matrix>
Json rows(const Matrix& m) {
  Json list = Json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) list.push_back(numbers(m.row(i)));
  return list;
}

/// The text of a document; bytes that aren't UTF-8, of names and files, become U+FFFD.
/// @param indent spaces a level; −1: all in one line
inline std::string text_of(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace delos::session
