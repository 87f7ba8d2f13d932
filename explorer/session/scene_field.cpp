#include "session/scene_field.h"

#include "delos/model/metric_expression.h"
#include "output/write.h"

namespace delos::session {

const AdaptiveSampling* adaptive_sampling(const Scene& scene) {
  return scene.samples.size() == 1
             ? std::get_if<AdaptiveSampling>(&scene.samples.front().shape)
             : nullptr;
}

Evaluation evaluate_scene(const LoadedScene& loaded, const FieldOptions& options) {
  Evaluation evaluation;
  if (const AdaptiveSampling* sampling = adaptive_sampling(loaded.scene)) {
    AdaptiveOptions adaptive;
    adaptive.field = options;
    evaluation.octree = std::make_shared<const AdaptiveField>(evaluate_adaptive(
        loaded.system, *sampling, loaded.scene.orientations, loaded.metric, adaptive));
    evaluation.field = evaluation.octree->field();
  } else {
    evaluation.field =
        evaluate_field(loaded.system, make_samples(loaded.scene.samples),
                       loaded.scene.orientations, loaded.metric, options);
  }
  evaluation.field.scene = loaded.scene.name;
  return evaluation;
}

Json field_answer(const LoadedScene& loaded, const Field& field) {
  Json json = Json::parse(field_json(field));
  if (loaded.metric.expression)
    json["metric"]["expression"] = loaded.metric.expression->formula.text;
  for (const ClutterEntry& c : loaded.scene.clutter)
    json["clutter"].push_back({{"name", c.name}, {"count", c.count}, {"seed", c.seed}});
  return json;
}

Json verification_json(const Verification& v) {
  Json resolutions = Json::array();
  for (const Resolution& r : v.resolutions) {
    resolutions.push_back({{"spacing", number(r.spacing)},
                           {"evaluations", r.evaluations},
                           {"error", number(r.error)}});
  }
  return {{"resolutions", resolutions},
          {"orders", {number(v.first_order), number(v.second_order)}}};
}

}  // namespace delos::session
