#include "session/select_answer.h"

#include "delos/scene/definition.h"

namespace delos::session {
namespace {

std::vector<std::string> names_of(const SelectResult& result,
                                  const std::vector<char>& flags) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i]) names.push_back(result.all.candidates[i].name);
  return names;
}

void add_definition(Json& json, const CandidateScene& all) {
  json["fusion"] = to_string(definition_of(all.scene).fusion);
  json["covariance"] = to_string(all.scene.covariance);
}

}  // namespace

std::vector<std::string> chosen_names(const CandidateScene& all,
                                      const std::vector<std::size_t>& chosen) {
  std::vector<std::string> names;
  for (const std::size_t i : chosen) names.push_back(all.candidates[i].name);
  return names;
}

double gap_of(double value, double bound) {
  return value > bound ? value / bound - 1 : 0;
}

Json select_json(const SelectResult& result) {
  Json fractions = Json::object();
  for (std::size_t i = 0; i < result.fractions.size(); ++i)
    if (result.fractions[i] > 1e-6)
      fractions[result.all.candidates[i].name] = number(result.fractions[i]);
  Json json{{"chosen", chosen_names(result.all, result.chosen)},
            {"value", number(result.value)},
            {"lower_bound", number(result.lower_bound)},
            {"gap", number(result.gap)},
            {"variance_gap", number(result.variance_gap)},
            {"certified", result.quantity},
            {"unit", result.unit},
            {"samples", result.samples},
            {"blind", result.blind},
            {"always_blind", result.always_blind},
            {"guess", number(result.guess)},
            {"candidates", result.all.candidates.size()},
            {"in_every", names_of(result, result.in_every)},
            {"in_none", names_of(result, result.in_none)},
            {"fractions", fractions},
            {"nodes", result.nodes},
            {"stop", to_string(result.stop)},
            {"seconds", number(result.seconds)}};
  add_definition(json, result.all);
  return json;
}

Json cover_json(const SceneCover& cover) {
  return {{"chosen", chosen_names(cover.all, cover.chosen)},
          {"value", number(cover.cost)},
          {"lower_bound", number(cover.lower_bound)},
          {"gap", number(gap_of(cover.cost, cover.lower_bound))},
          {"certified", "cost of what is chosen"},
          {"samples", cover.samples},
          {"candidates", cover.all.candidates.size()},
          {"stop", to_string(cover.stop)},
          {"seconds", number(cover.seconds)}};
}

Json curve_json(const CountCurve& curve) {
  Json points = Json::array();
  for (const CountPoint& p : curve.points)
    points.push_back({{"count", p.count},
                      {"value", number(p.value)},
                      {"lower_bound", number(p.lower_bound)},
                      {"gap", number(gap_of(p.value, p.lower_bound))},
                      {"blind", p.blind},
                      {"chosen", chosen_names(curve.all, p.chosen)}});
  Json json{{"certified", curve.quantity},
            {"unit", curve.unit},
            {"guess", number(curve.guess)},
            {"curve", points}};
  add_definition(json, curve.all);
  return json;
}

Json removal_json(const RemovalOrder& order) {
  Json removals = Json::array();
  for (const Removal& r : order.removals)
    removals.push_back({{"remove", order.all.candidates[r.candidate].name},
                        {"left", r.left},
                        {"value", number(r.value)},
                        {"lower_bound", number(r.lower_bound)},
                        {"blind", r.blind}});
  Json json{{"certified", order.quantity},
            {"unit", order.unit},
            {"guess", number(order.guess)},
            {"all_chosen", number(order.all_chosen)},
            {"removals", removals}};
  add_definition(json, order.all);
  return json;
}

}  // namespace delos::session
