#include "session/simulation_answer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "delos/scene/definition.h"

namespace delos::session {
namespace {

Json by_state(const std::vector<std::string>& names, const StateVector& values) {
  Json json = Json::object();
  for (Eigen::Index i = 0; i < values.size(); ++i)
    json[names[static_cast<std::size_t>(i)]] = number(values(i));
  return json;
}

Json consistency_json(const Consistency& of, double share) {
  return {{"mean", number(of.mean)},
          {"expected", number(of.expected)},
          {"band", {number(of.lower), number(of.upper)}},
          {"inside", of.inside()},
          {"share_inside", number(share)}};
}

Json covariance_json(const std::vector<std::string>& names,
                     const SimulatedCovariance& c) {
  const StateVector predicted = deviations(c.predicted),
                    measured = deviations(c.measured), errors = deviation_errors(c);
  Json json;
  json["predicted"] = by_state(names, predicted);
  json["measured"] = by_state(names, measured);
  json["error"] = by_state(names, errors);
  json["ratio"] = by_state(names, measured.cwiseQuotient(predicted));
  json["ratio_error"] = by_state(names, errors.cwiseQuotient(predicted));
  json["filter"] = by_state(names, deviations(c.filter));
  json["bound"] = c.bound.size() > 0 ? by_state(names, deviations(c.bound)) : Json();
  return json;
}

Json instant_json(const std::vector<std::string>& names, const SimulatedInstant& at) {
  Json json{{"t", at.t}, {"at", numbers(at.at)}};
  json["mean"] = by_state(names, at.mean);
  json["measured"] = by_state(names, at.square.cwiseSqrt());
  json["filter"] = by_state(names, at.filter.cwiseSqrt());
  json["predicted"] = by_state(names, at.predicted.cwiseSqrt());
  json["bound"] = at.bound.size() > 0 ? by_state(names, at.bound.cwiseSqrt()) : Json();
  json["nees"] = number(at.nees.mean);
  json["nis"] = number(at.nis.mean);
  json["seen"] = at.seen;
  return json;
}

Json place_json(const SimulationAnswer& answer, const LoadedScene& loaded, bool along) {
  const std::vector<std::string> names = loaded.system.motion.layout.names();
  Json json;
  if (!answer.place.name.empty()) json["name"] = answer.place.name;
  json["at"] = numbers(answer.place.pose.p);
  json["rpy"] = numbers(answer.place.rpy);
  if (!answer.simulation) {
    json["problem"] = answer.problem;
    return json;
  }
  const Simulation& s = *answer.simulation;
  json["runs"] = s.runs;
  json["lost"] = s.lost;
  if (s.covariances.empty()) return json;
  if (const auto path = along_path(s)) {
    json["predicted"] = by_state(names, path->predicted);
    json["measured"] = by_state(names, path->measured);
    json["ratio"] = by_state(names, path->measured.cwiseQuotient(path->predicted));
    json["filter"] = by_state(names, path->filter);
    json["blind"] = path->blind;
  } else if (!along) {
    json.update(covariance_json(names, s.covariances.front()));
  }
  json["nees"] = consistency_json(s.instants.back().nees, s.nees_inside);
  json["nis"] = consistency_json(s.instants.back().nis, s.nis_inside);
  json["latency"] = number(s.time_constant);
  json["seconds"] = s.instants.back().t;
  json["converged_after"] = s.settled_after ? Json(*s.settled_after) : Json();
  json["coasting"] = s.coasting;
  json["longest_gap"] = s.longest_gap;
  json["dropped"] = s.dropped;
  if (!along) json["covariances"] = Json::object();
  for (const SimulatedCovariance& c : s.covariances)
    if (!along) json["covariances"][c.name] = covariance_json(names, c);
  if (!along) return json;
  json["path"] = Json::array();
  for (const SimulatedInstant& at : s.instants)
    json["path"].push_back(instant_json(names, at));
  return json;
}

}  // namespace

std::vector<SimulatedPlace> typical_places(const Field& field,
                                           const Eigen::Vector3d& rpy) {
  std::vector<std::size_t> finite;
  for (std::size_t i = 0; i < field.value.size(); ++i)
    if (std::isfinite(field.value[i]) && field.observable[i] != 0) finite.push_back(i);
  if (finite.empty()) return {};
  std::stable_sort(finite.begin(), finite.end(), [&](std::size_t a, std::size_t b) {
    return field.larger_is_better ? field.value[a] > field.value[b]
                                  : field.value[a] < field.value[b];
  });
  const auto place = [&](const char* name, std::size_t rank) {
    return SimulatedPlace{
        name, {rotation_from_rpy(rpy), field.samples.points[finite[rank]]}, rpy};
  };
  if (finite.size() == 1) return {place("best", 0)};
  return {place("best", 0), place("median", finite.size() / 2),
          place("worst", finite.size() - 1)};
}

GivenPath given_path(const std::vector<PathRow>& rows) {
  GivenPath path;
  for (const PathRow& row : rows) {
    path.t.push_back(row.t);
    path.p.push_back(row.p);
  }
  return path;
}

SimulationAnswer answer_simulation(const LoadedScene& loaded,
                                   const SimulatedPlace& place,
                                   const SimulationOptions& options,
                                   PluginRegistry& plugins, Crew* crew) {
  SimulationAnswer answer{place, std::nullopt, {}};
  try {
    answer.simulation =
        crew ? simulate_with_crew(loaded.scene, place.pose, plugins, options, *crew)
             : simulate(loaded.system, place.pose, options);
  } catch (const std::invalid_argument& error) {
    answer.problem = error.what();
  }
  return answer;
}

StateVector deviations(const StateMatrix& P) {
  return P.diagonal().cwiseMax(0).cwiseSqrt();
}

// dσ = d(σ²)/2σ
StateVector deviation_errors(const SimulatedCovariance& c) {
  StateVector errors = c.error.diagonal();
  const StateVector sigma = deviations(c.measured);
  for (Eigen::Index i = 0; i < errors.size(); ++i)
    if (sigma(i) > 0) errors(i) /= 2 * sigma(i);
  return errors;
}

std::optional<AlongPath> along_path(const Simulation& simulation) {
  AlongPath sum;
  double count = 0;
  for (const SimulatedInstant& at : simulation.instants) {
    if (at.predicted.size() == 0) return std::nullopt;
    if (!at.predicted.allFinite()) {
      ++sum.blind;
      continue;
    }
    if (count++ == 0) {
      sum.predicted = sum.measured = sum.filter = StateVector::Zero(at.square.size());
    }
    sum.predicted += at.predicted;
    sum.measured += at.square;
    sum.filter += at.filter;
  }
  if (count == 0) return std::nullopt;
  for (StateVector* of : {&sum.predicted, &sum.measured, &sum.filter})
    *of = (*of / count).cwiseSqrt();
  return sum;
}

Json simulation_json(const std::vector<SimulationAnswer>& answers,
                     const LoadedScene& loaded, const SimulationOptions& options) {
  Json json;
  json["scene"] = loaded.scene.name;
  json["fusion"] = to_string(loaded.system.fusion);
  json["covariance"] = to_string(loaded.system.covariance);
  json["filter"] = to_string(options.filter);
  json["runs"] = options.runs;
  json["seed"] = options.seed;
  json["state"] = loaded.system.motion.layout.names();
  json["units"] = loaded.system.motion.layout.units();
  json["points"] = Json::array();
  for (const SimulationAnswer& answer : answers)
    json["points"].push_back(place_json(answer, loaded, options.path.has_value()));
  // Of the first place; the others have theirs.
  const Json& first = json["points"].front();
  json["nis"] = first.value("nis", Json());
  json["converged_after"] = first.value("converged_after", Json());
  return json;
}

std::string instants_csv(const Simulation& simulation, const LoadedScene& loaded) {
  const std::vector<std::string> names = loaded.system.motion.layout.names();
  std::string text = "t,x,y,z";
  for (const char* what : {"mean_", "measured_", "filter_", "bound_", "predicted_"})
    for (const std::string& name : names) text += std::string(",") + what + name;
  text += ",nees,nis,nis_expected,seen\n";
  const auto append = [&](double value) {
    char buffer[32];
    if (!std::isfinite(value)) return;
    text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  };
  for (const SimulatedInstant& at : simulation.instants) {
    append(at.t);
    for (const double p : at.at) text += ',', append(p);
    for (const double m : at.mean) text += ',', append(m);
    for (const StateVector* of : {&at.square, &at.filter, &at.bound, &at.predicted})
      for (std::size_t i = 0; i < names.size(); ++i) {
        text += ',';
        if (of->size() > 0) append(std::sqrt((*of)(static_cast<Eigen::Index>(i))));
      }
    for (const double v : {at.nees.mean, at.nis.mean, at.nis.expected, at.seen})
      text += ',', append(v);
    text += '\n';
  }
  return text;
}

}  // namespace delos::session
