#include "session/comparison.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "delos/model/metric_expression.h"
#include "delos/scene/definition.h"
#include "output/write.h"
#include "session/refusal.h"
#include "session/scene_field.h"

namespace delos::session {
namespace {

/// Numbers over the volume where the samples are adaptive, and the difference at the
/// samples.
Comparison compared(const Field& first, const Field& second) {
  Comparison c = compare_fields(first, second);
  if (!first.spread) return c;
  Comparison by_volume = compare_fields(*first.spread, *second.spread);
  by_volume.difference = std::move(c.difference);
  return by_volume;
}

Json to_json(const Comparison& c) {
  return {{"mean", number(c.mean)},
          {"min", number(c.min)},
          {"max", number(c.max)},
          {"improved_fraction", number(c.improved_fraction)},
          {"common", c.common}};
}

Json to_json(const ComparedSide& side) {
  Json json = Json::parse(field_json(side.field));
  if (side.better) json["better_than"] = number(*side.better);
  if (!side.specs.empty()) json["specs"] = specs_json(side.specs);
  if (side.use) {
    json["beacons_used"] = number(side.use->beacons);
    json["views_used"] = number(side.use->views);
    json["sightings_used"] = number(side.use->sightings);
  }
  return json;
}

ComparedSide side_of(Field field, const LoadedScene& loaded,
                     const ComparisonQuestion& question, const FieldOptions& options) {
  ComparedSide side{std::move(field), {}, std::nullopt, {}, std::nullopt};
  side.statistics = summarize(side.field);
  if (question.better) side.better = share_meeting(side.field, *question.better).share;
  side.specs = met_specs(specs_of(question.specs, loaded), loaded, side.field, options);
  const auto& devices = loaded.system.devices;
  if (std::any_of(devices.begin(), devices.end(),
                  [](const PlacedDevice& d) { return d.sees_beacons(); })) {
    side.use = beacon_use(loaded.system,
                          field_poses(side.field.samples, loaded.scene.orientations),
                          options.threads);
  }
  return side;
}

/// A scene's field on samples of another one's.
Field field_on(const Samples& samples, const std::vector<double>& weight,
               const LoadedScene& loaded, const FieldOptions& options) {
  Field field = evaluate_field(loaded.system, samples, loaded.scene.orientations,
                               loaded.metric, options);
  field.scene = loaded.scene.name;
  field.weight = weight;
  return field;
}

/// A later side on the samples of the first, and on those that its volume is counted
/// by.
Field field_like(const Field& first, const LoadedScene& loaded,
                 const FieldOptions& options) {
  Field field = field_on(first.samples, first.weight, loaded, options);
  if (first.spread && !field.cancelled) {
    Field spread =
        field_on(first.spread->samples, first.spread->weight, loaded, options);
    field.cancelled = spread.cancelled;
    field.spread = std::make_shared<const Field>(std::move(spread));
  }
  return field;
}

}  // namespace

void evaluate_alike(std::vector<LoadedScene>& sides) {
  std::vector<const Scene*> scenes;
  for (const LoadedScene& side : sides) scenes.push_back(&side.scene);
  const auto fusion = common_fusion(scenes);
  if (!fusion) return;
  for (LoadedScene& side : sides)
    if (side.system.covariance != CovarianceKind::single) side.system.fusion = *fusion;
}

std::string incomparable(const std::vector<LoadedScene>& sides,
                         const std::vector<std::string>& names) {
  const Metric& metric = sides.front().metric;
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Metric& other = sides[i].metric;
    if (same_metric(other, metric)) continue;
    if (other.name == metric.name && other.unit == metric.unit)
      return names[i] + " and " + names.front() + " mean different things by " +
             metric.name + "; give them one, or choose another metric";
    return names[i] + " shows " + other.name + " and " + names.front() + " shows " +
           metric.name + "; choose one metric for all";
  }
  return "";
}

ComparisonAnswer compare_scenes(const std::vector<LoadedScene>& sides,
                                const ComparisonQuestion& question,
                                const FieldOptions& options) {
  ComparisonAnswer answer;
  for (const LoadedScene& loaded : sides) {
    Field field = answer.sides.empty()
                      ? evaluate_scene(loaded, options).field
                      : field_like(answer.sides.front().field, loaded, options);
    if (field.cancelled) {
      answer.cancelled = true;
      return answer;
    }
    answer.sides.push_back(side_of(std::move(field), loaded, question, options));
    if (answer.sides.size() > 1)
      answer.differences.push_back(
          compared(answer.sides.front().field, answer.sides.back().field));
  }
  return answer;
}

ComparisonAnswer compare_stored(std::vector<Field> fields) {
  ComparisonAnswer answer;
  for (Field& field : fields) {
    const Field& first = answer.sides.empty() ? field : answer.sides.front().field;
    if (field.metric != first.metric || field.unit != first.unit)
      throw Refusal(Blame::question, field.scene + " shows " + field.metric + " and " +
                                         first.scene + " shows " + first.metric +
                                         "; compare fields of one metric");
    if (field.samples.points != first.samples.points ||
        (field.spread == nullptr) != (first.spread == nullptr) ||
        (field.spread && field.spread->samples.points != first.spread->samples.points))
      throw Refusal(Blame::question,
                    field.scene + " isn't sampled where " + first.scene +
                        " is; compare the scenes, or fields of one set of samples");
    answer.sides.push_back({std::move(field), {}, std::nullopt, {}, std::nullopt});
    answer.sides.back().statistics = summarize(answer.sides.back().field);
    if (answer.sides.size() > 1)
      answer.differences.push_back(
          compared(answer.sides.front().field, answer.sides.back().field));
  }
  return answer;
}

bool evaluated_alike(const ComparisonAnswer& answer) {
  const auto& sides = answer.sides;
  return std::all_of(sides.begin(), sides.end(), [&](const ComparedSide& side) {
    return alike(side.field.definition, sides.front().field.definition);
  });
}

Json comparison_json(const ComparisonAnswer& answer) {
  const bool same = evaluated_alike(answer);
  const Definition& definition = answer.sides.front().field.definition;
  Json json;
  json["fusion"] = same ? Json(to_string(definition.fusion)) : Json();
  json["covariance"] = same ? Json(to_string(definition.covariance)) : Json();
  json["scenes"] = Json::array();
  for (const ComparedSide& side : answer.sides) json["scenes"].push_back(to_json(side));
  json["difference"] = to_json(answer.differences.front());
  if (answer.differences.size() > 1) {
    json["differences"] = Json::array();
    for (const Comparison& c : answer.differences)
      json["differences"].push_back(to_json(c));
  }
  return json;
}

}  // namespace delos::session
