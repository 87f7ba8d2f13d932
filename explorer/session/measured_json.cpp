#include "session/measured_json.h"

namespace delos::session {
namespace {

/// By the axes that the state has.
Json by_axis(const Eigen::Vector3d& of, const LoadedScene& loaded) {
  Json json = Json::object();
  for (int k = 0; k < loaded.system.motion.layout.positions(); ++k)
    json[std::string(1, "xyz"[k])] = number(of(k));
  return json;
}

/// Measured over predicted.
Eigen::Vector3d ratio(const Eigen::Vector3d& measured,
                      const Eigen::Vector3d& predicted) {
  return measured.cwiseQuotient(predicted);
}

}  // namespace

Json measured_json(const measured::PosesComparison& answer,
                   const std::vector<measured::Window>& windows,
                   const LoadedScene& loaded) {
  Json json;
  json["scene"] = loaded.scene.name;
  json["scatter"] = by_axis(answer.scatter, loaded);
  json["predicted"] = by_axis(answer.predicted, loaded);
  json["ratio"] = by_axis(ratio(answer.scatter, answer.predicted), loaded);
  json["paths"] = Json::array();
  for (const measured::PathComparison& path : answer.paths)
    json["paths"].push_back(
        {{"name", path.name},
         {"places", path.places},
         {"bias", path.bias ? by_axis(*path.bias, loaded) : Json()},
         {"scatter", by_axis(path.scatter, loaded)},
         {"predicted", by_axis(path.predicted, loaded)},
         {"ratio", by_axis(ratio(path.scatter, path.predicted), loaded)},
         {"without_prediction", path.blind}});
  json["windows"] = Json::array();
  for (const measured::Window& w : windows)
    json["windows"].push_back({{"at", numbers(w.p)},
                               {"measured", number(w.measured)},
                               {"predicted", number(w.predicted)}});
  return json;
}

Json measured_json(const measured::ReadingsComparison& answer,
                   const LoadedScene& loaded) {
  Json json;
  json["scene"] = loaded.scene.name;
  json["instants"] = answer.instants;
  json["with_truth"] = answer.with_truth;
  json["longest_gap"] = number(answer.longest_gap);
  json["dropped"] = answer.dropped;
  json["nis"] = {{"mean", number(answer.nis)}, {"expected", 1}};
  json["devices"] = Json::array();
  for (const measured::DeviceComparison& d : answer.devices)
    json["devices"].push_back({{"name", d.name},
                               {"readings", d.readings},
                               {"rate", number(d.rate)},
                               {"scene_rate", number(d.scene_rate)},
                               {"bias", number(d.bias)},
                               {"scatter", number(d.scatter)},
                               {"predicted", number(d.predicted)},
                               {"ratio", number(d.scatter / d.predicted)},
                               {"correlation", number(d.correlation)}});
  json["track"] = Json();
  if (!answer.track) return json;
  const measured::TrackComparison& t = *answer.track;
  json["track"] = {
      {"bias", by_axis(t.bias, loaded)},
      {"scatter", by_axis(t.scatter, loaded)},
      {"predicted", by_axis(t.predicted, loaded)},
      {"ratio", by_axis(ratio(t.scatter, t.predicted), loaded)},
      {"filter", by_axis(t.filter, loaded)},
      {"nees", {{"mean", number(t.nees)}, {"expected", number(t.nees_expected)}}}};
  return json;
}

}  // namespace delos::session
