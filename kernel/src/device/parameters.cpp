#include "delos/device/parameters.h"

#include <algorithm>
#include <stdexcept>

namespace delos {
namespace {

/// The alternative T of a value, or an error that names the parameter and what it
/// isn't.
template <class T>
const T& get(const ParamValue& value, std::string_view name, const char* kind) {
  const T* held = std::get_if<T>(&value);
  if (!held) {
    throw std::out_of_range("parameter '" + std::string(name) + "' is not a " + kind);
  }
  return *held;
}

}  // namespace

bool same_value(const ParamValue& a, const ParamValue& b) {
  const auto* m = std::get_if<Eigen::MatrixXd>(&a);
  const auto* n = std::get_if<Eigen::MatrixXd>(&b);
  if (!m || !n) return a.index() == b.index() && a == b;
  // Eigen's == takes equal shapes for granted.
  return m->rows() == n->rows() && m->cols() == n->cols() && *m == *n;
}

void ParamValues::set(std::string_view name, ParamValue value) {
  const auto it = std::find_if(values_.begin(), values_.end(),
                               [&](const auto& entry) { return entry.first == name; });
  if (it == values_.end()) {
    values_.emplace_back(name, std::move(value));
  } else {
    it->second = std::move(value);
  }
}

double ParamValues::operator[](std::string_view name) const {
  return get<double>(at(name), name, "number");
}

const std::string& ParamValues::choice(std::string_view name) const {
  return get<std::string>(at(name), name, "choice");
}

const Eigen::MatrixXd& ParamValues::matrix(std::string_view name) const {
  return get<Eigen::MatrixXd>(at(name), name, "vector or matrix");
}

ParamValue& ParamValues::edit(std::string_view name) {
  return const_cast<ParamValue&>(at(name));
}

const ParamValue& ParamValues::at(std::string_view name) const {
  for (const auto& [key, value] : values_) {
    if (key == name) return value;
  }
  throw std::out_of_range("there is no parameter '" + std::string(name) + "'");
}

bool operator==(const ParamValues& a, const ParamValues& b) {
  return std::equal(a.values_.begin(), a.values_.end(), b.values_.begin(),
                    b.values_.end(), [](const auto& x, const auto& y) {
                      return x.first == y.first && same_value(x.second, y.second);
                    });
}

}  // namespace delos
