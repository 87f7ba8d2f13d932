#include "report/tradeoff.h"

#include <stdexcept>
#include <string>

namespace delos::report {
namespace {

using session::Json;

Json named(const Json& one, const char* name) {
  return {{"name", one.at(name).get<std::string>()},
          {"unit", one.at("unit").get<std::string>()}};
}

Json points_of(const Json& document, bool of_limit) {
  Json points = Json::array();
  for (const Json& p : document.at("points")) {
    if (p.at("objective").is_null()) continue;
    points.push_back({{"across", p.at(of_limit ? "limit" : "devices").get<double>()},
                      {"used", p.at(of_limit ? "used" : "price").get<double>()},
                      {"objective", p.at("objective").get<double>()},
                      {"kept", p.at("kept").get<bool>()},
                      {"dominated", of_limit && p.at("dominated").get<bool>()}});
  }
  return points;
}

Json cheapest_of(const Json& document) {
  const Json& cheapest = document.at("cheapest");
  if (cheapest.is_null()) return {};
  return {{"devices", cheapest.at("devices").get<std::size_t>()},
          {"price", cheapest.at("price").get<double>()}};
}

}  // namespace

Json tradeoff_json(const Json& document) {
  try {
    const bool of_limit = document.contains("limit");
    return {{"across", of_limit ? named(document.at("limit"), "constraint")
                                : Json({{"name", "devices"}, {"unit", "1"}})},
            {"of_limit", of_limit},
            {"objective", named(document.at("objective"), "name")},
            {"points", points_of(document, of_limit)},
            {"cheapest", of_limit ? Json() : cheapest_of(document)}};
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("this isn't what delos tradeoff --json writes");
  }
}

}  // namespace delos::report
