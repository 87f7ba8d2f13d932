#include "server/request.h"

#include <cmath>
#include <limits>

namespace delos::server {

const Json& member(const Json& request, const char* key) {
  const auto found = request.find(key);
  if (found == request.end()) throw BadRequest(std::string("'") + key + "' is missing");
  return *found;
}

std::string text_at(const Json& request, const char* key) {
  const Json& json = member(request, key);
  if (!json.is_string()) throw BadRequest(std::string("'") + key + "' must be a text");
  return json.get<std::string>();
}

std::string text_or_empty(const Json& request, const char* key) {
  return request.contains(key) ? text_at(request, key) : "";
}

Eigen::VectorXd numbers_at(const Json& list, const char* key, Eigen::Index n) {
  const BadRequest wrong("'" + std::string(key) + "' must be " + std::to_string(n) +
                         " finite numbers");
  if (!list.is_array() || static_cast<Eigen::Index>(list.size()) != n) throw wrong;
  Eigen::VectorXd v(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Json& item = list[static_cast<std::size_t>(i)];
    if (!item.is_number()) throw wrong;
    v(i) = item.get<double>();
    if (!std::isfinite(v(i))) throw wrong;
  }
  return v;
}

double number_or(const Json& request, const char* key, double usual, double most,
                 double least) {
  if (!request.contains(key)) return usual;
  const Json& json = request[key];
  const double value =
      json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
  if (!(value >= least && value <= most))
    throw BadRequest("'" + std::string(key) + "' must be a number from " +
                     std::to_string(static_cast<long long>(least)) + " to " +
                     std::to_string(static_cast<long long>(most)));
  return value;
}

std::size_t most_samples(const Json& request) {
  if (!request.contains("most")) return 0;
  const Json& json = request["most"];
  if (!json.is_number_unsigned())
    throw BadRequest("'most' must be a whole number of samples, 0 for all");
  return json.get<std::size_t>();
}

}  // namespace delos::server
