#include "session/specs.h"

#include <map>

#include "delos/scene/definition.h"
#include "session/refusal.h"

namespace delos::session {

std::vector<Spec> specs_of(const std::vector<std::string>& texts,
                           const LoadedScene& loaded) {
  std::vector<Spec> specs;
  for (const std::string& text : texts) {
    auto spec = parse_spec(text, known_metrics(loaded.scene));
    if (const auto* problem = std::get_if<std::string>(&spec))
      throw Refusal(Blame::question, "spec '" + text + "': " + *problem);
    specs.push_back(std::get<Spec>(std::move(spec)));
    const Metric& metric = specs.back().metric;
    if (const std::string no = metric_problem(loaded.system, metric); !no.empty())
      throw Refusal(Blame::question, "spec '" + text + "': " + no);
  }
  return specs;
}

std::vector<MetSpec> met_specs(const std::vector<Spec>& specs,
                               const LoadedScene& loaded, const Field& field,
                               const FieldOptions& options) {
  std::map<std::string, Field> others;
  std::vector<MetSpec> all;
  for (const Spec& spec : specs) {
    const Field* of_metric = &field;
    if (spec.metric.name != field.metric) {
      const auto [at, is_new] = others.try_emplace(spec.metric.name);
      if (is_new) {
        at->second = evaluate_field(loaded.system, field.samples,
                                    loaded.scene.orientations, spec.metric, options);
        at->second.weight = field.weight;
      }
      of_metric = &at->second;
    }
    all.push_back({spec, share_meeting(*of_metric, spec), !field.weight.empty()});
  }
  return all;
}

Json specs_json(const std::vector<MetSpec>& all) {
  Json json = Json::array();
  for (const auto& [spec, share, by_volume] : all)
    json.push_back({{"spec", spec.text},
                    {"share", number(share.share)},
                    {"met", share.met},
                    {"samples", share.samples}});
  return json;
}

}  // namespace delos::session
