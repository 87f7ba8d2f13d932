#include "output/json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "delos/field/statistics.h"
#include "delos/text/number_text.h"
#include "output/write.h"

namespace delos {
namespace {

using Json = nlohmann::ordered_json;

Json extreme_json(const Extreme& extreme) {
  return {{"value", extreme.value},
          {"at", {extreme.at.x(), extreme.at.y(), extreme.at.z()}}};
}

void add_statistics(Json& json, const FieldStatistics& s) {
  json["samples"] = s.samples;
  json["observable"] = s.observable;
  json["finite"] = s.finite;
  json["one_short"] = s.one_short;
  if (s.inside > 0) json["inside"] = s.inside;
  const bool any = s.finite > 0;
  json["min"] = any ? extreme_json(s.min) : Json();
  json["max"] = any ? extreme_json(s.max) : Json();
  json["mean"] = any ? Json(s.mean) : Json();
  json["median"] = any ? Json(s.median) : Json();
  json["p95"] = any ? Json(s.p95) : Json();
  if (!s.volume) return;
  const auto finite = [](double v) { return std::isfinite(v) ? Json(v) : Json(); };
  json["volume"] = {{"observable", s.volume->observable},
                    {"observable_error", s.volume->observable_error},
                    {"one_short", s.volume->one_short},
                    {"one_short_error", s.volume->one_short_error},
                    {"mean_error", finite(s.volume->mean_error)},
                    {"median_error", finite(s.volume->median_error)},
                    {"p95_error", finite(s.volume->p95_error)},
                    {"beyond", s.volume->beyond},
                    {"points", s.volume->points}};
}

Json summary(const Field& field) {
  Json json;
  json["scene"] = field.scene;
  json["metric"] = {{"name", field.metric}, {"unit", field.unit}};
  json["fusion"] = to_string(field.definition.fusion);
  json["covariance"] = to_string(field.definition.covariance);
  if (field.definition.error) json["error"] = to_string(*field.definition.error);
  if (field.definition.lag > 0) json["lag"] = field.definition.lag;
  add_statistics(json, summarize(field));
  if (field.samples.parts.size() > 1) {
    json["parts"] = Json::array();
    for (const SamplePart& part : field.samples.parts) {
      Json entry;
      entry["name"] = part.name;
      add_statistics(entry, summarize_range(field, part.first, part.count));
      json["parts"].push_back(std::move(entry));
    }
  }
  if (field.discretization_error)
    json["discretization_error"] = *field.discretization_error;
  if (field.cancelled) json["cancelled"] = true;
  json["evaluations"] = field.evaluations;
  json["threads"] = field.threads;
  json["seconds"] = field.seconds;
  return json;
}

/// Indented by two. A scene's name may hold any bytes: those that aren't UTF-8 become
/// U+FFFD instead of an exception.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string field_json(const Field& field) { return text_of(summary(field)) + "\n"; }

void write_json(const Field& field, std::ostream& out) {
  // The values are written by hand: as nodes of a document, millions of samples would
  // take many times their size in memory.
  Json head = summary(field);
  head["columns"] = {"x", "y", "z", "value", "observable"};
  const std::string text = text_of(head);
  out << text.substr(0, text.rfind("\n}")) << ",\n  \"values\": [";
  std::string line;
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    line = i == 0 ? "\n    [" : ",\n    [";
    for (const double coordinate : field.samples.points[i]) {
      append_number(line, coordinate);
      line += ", ";
    }
    if (std::isfinite(field.value[i]))
      append_number(line, field.value[i]);
    else
      line += "null";
    line += field.observable[i] != 0 ? ", 1]" : ", 0]";
    out << line;
  }
  out << "\n  ]\n}\n";
}

}  // namespace delos
