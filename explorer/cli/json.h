// Numbers and matrices as the contract's JSON writes them.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

namespace delos::cli {

using Json = nlohmann::ordered_json;

/// A number; null where it isn't finite, since JSON has no infinity.
inline Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

/// A document on stdout; bytes that aren't UTF-8, of names and files, become U+FFFD.
inline void print_document(const Json& json) {
  std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

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

}  // namespace delos::cli
